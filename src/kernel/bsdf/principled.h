// SPDX-License-Identifier: Apache-2.0
// A surface of everyday materials, as glTF 2.0 and its extensions describe them (Khronos, appendix B): a matt or clear
// base under microfacets (metals and dielectrics), sheen over it, clear coat on top.
//
// What GGX's facets lose by light that bounces between them is given back (Kulla and Conty, Revisiting Physically Based
// Shading at Imageworks, SIGGRAPH 2017), and the base gets what they let through in the same way: white surfaces send
// back all light, and all is reciprocal.
#ifndef SUNDOG_KERNEL_BSDF_PRINCIPLED_H
#define SUNDOG_KERNEL_BSDF_PRINCIPLED_H

#include "kernel/bsdf/albedo_tables.h"
#include "kernel/bsdf/fresnel.h"
#include "kernel/bsdf/ggx.h"
#include "kernel/bsdf/lambert.h"
#include "kernel/bsdf/rough_dielectric.h"
#include "kernel/bsdf/sheen.h"
#include "kernel/bsdf/thin_film.h"

KERNEL_BEGIN

/// A principled surface at a point.
struct Principled {
    real3 base;
    real metallic;
    real alpha_x, alpha_y;  ///< Of the facets along the basis's x and y,
    real roughness;         ///< and the square root of their geometric mean.
    real3 f0;               ///< Reflectance along the normal, of the metal and the dielectric together,
    real f90;               ///< and along the surface.
    real transmission;
    real eta;   ///< Index of refraction on the eye's side over that on the other.
    mask thin;  ///< What passes goes straight on.
    real coat, coat_alpha;
    real3 coat_normal;  ///< Unit; z where the coat lies as its base does.
    real3 sheen;
    real sheen_roughness;
    real film, film_ior, film_nm;  ///< Share, index of refraction and thickness of a thin film.
};

/// Facets' reflectance under the cosine to their own normal.
FN real3 facet_reflectance(Principled p, real eye_half) {
    real3 f = fresnel_between(p.f0, real3(p.f90), eye_half);
    mask glass = mask_and(p.transmission > real(0.0f), mask_not(p.thin));
    if (any_lane(glass)) {
        // Glass may throw all back, from its inside.
        real exact = fresnel_dielectric(eye_half, p.eta);
        f = select(mask_and(glass, p.metallic <= real(0.0f)), real3(exact), f);
    }
    if (any_lane(p.film > real(0.0f))) f = mix(f, thin_film_reflectance(eye_half, p.film_ior, p.film_nm, p.f0), p.film);
    return f;
}

/// Clear coat's reflectance: varnish of an index of refraction of 1.5.
FN real coat_reflectance(real coat, real cosine_there) {
    real m = clamp(1.0f - cosine_there, real(0.0f), real(1.0f));
    real m2 = m * m;
    return coat * (0.04f + 0.96f * m2 * m2 * m);
}

/// A direction as the coat has it, whose normal may be another.
FN real3 seen_by_coat(Principled p, real3 v) {
    mask bent = mask_and(p.coat > real(0.0f), p.coat_normal.z < real(0.999999f));
    if (!any_lane(bent)) return v;
    return select(bent, to_local(frame_around(p.coat_normal), v), v);
}

/// Of what bounces between facets, which share comes out: Kulla and Conty's factor, with the mean of Schlick's
/// reflectance.
FN real3 bounced_share(Principled p, real mean_albedo) {
    real3 mean_f = p.f0 + (real3(p.f90) - p.f0) * real(1.0f / 21.0f);
    real3 lost = real3(real(1.0f)) - mean_f * (1.0f - mean_albedo);
    real3 top = mean_f * mean_f * mean_albedo;
    return real3(top.x / max(lost.x, real(1e-4f)), top.y / max(lost.y, real(1e-4f)), top.z / max(lost.z, real(1e-4f)));
}

/// How directions are drawn; shares add up to 1.
struct PrincipledShares {
    real matt;   ///< Over the hemisphere: base, sheen, what bounces between facets.
    real facet;  ///< Off a facet, or through it.
    real coat;
};

FN PrincipledShares principled_shares(SCENE Principled p, real3 to_eye) {
    real2 albedo = ggx_albedo(SCENE_ to_eye.z, p.roughness);
    real coat = coat_reflectance(p.coat, abs(seen_by_coat(p, to_eye).z));
    real3 facets = p.f0 * albedo.x + real3(p.f90 * albedo.y);
    real reflected = min(largest(facets), real(1.0f));
    real base = largest(p.base) * (1.0f - p.metallic) * (1.0f - reflected);
    real matt =
        base * (1.0f - p.transmission) + largest(p.sheen) * 0.5f + (1.0f - albedo.x - albedo.y) * largest(p.f0) + 0.01f;
    real facet = reflected + base * p.transmission;
    PrincipledShares shares;
    real all = (matt + facet) * (1.0f - coat) + coat;
    shares.coat = coat / all;
    shares.matt = matt * (1.0f - coat) / all;
    shares.facet = facet * (1.0f - coat) / all;
    return shares;
}

/// Of directions that facets send on, which share is drawn among reflected ones.
FN real reflected_share(Principled p, real3 reflectance) {
    real r = largest(reflectance);
    real through = p.transmission * (1.0f - p.metallic) * (1.0f - min(r, real(1.0f))) * largest(p.base);
    return select(through > real(0.0f), r / max(r + through, real(1e-10f)), real(1.0f));
}

/// BSDF times the cosine, and density over solid angle of drawing the direction; `to_eye` is on the side of z.
FN void principled_value(SCENE Principled p, real3 to_eye, real3 to_light, OUT(real3) value, OUT(real) density) {
    real3 black = real3(real(0.0f));
    real3 white = real3(real(1.0f));
    value = black;
    PrincipledShares shares = principled_shares(SCENE_ p, to_eye);
    mask above = to_light.z > real(0.0f);
    real cos_light = abs(to_light.z);
    // Through the coat and back.
    real3 coat_eye = seen_by_coat(p, to_eye);
    real3 coat_light = seen_by_coat(p, to_light);
    real passes =
        (1.0f - coat_reflectance(p.coat, abs(coat_eye.z))) * (1.0f - coat_reflectance(p.coat, abs(coat_light.z)));

    real3 h = to_eye + to_light;
    h = h * (1.0f / sqrt(max(dot(h, h), real(1e-20f))));
    real eye_half = dot(to_eye, h);
    real3 reflectance = facet_reflectance(p, eye_half);
    real reflects = reflected_share(p, reflectance);
    density = shares.matt * lambert_density(to_light) +
              shares.facet * reflects * ggx_density(to_eye, h, p.alpha_x, p.alpha_y);
    value = reflectance * (ggx_value(to_eye, to_light, h, p.alpha_x, p.alpha_y) * cos_light);

    real2 eye_albedo = ggx_albedo(SCENE_ to_eye.z, p.roughness);
    real2 light_albedo = ggx_albedo(SCENE_ cos_light, p.roughness);
    real2 mean_albedo = ggx_mean_albedo(SCENE_ p.roughness);
    real eye_lost = max(1.0f - eye_albedo.x - eye_albedo.y, real(0.0f));
    real light_lost = max(1.0f - light_albedo.x - light_albedo.y, real(0.0f));
    real mean = mean_albedo.x + mean_albedo.y;
    real mean_lost = max(1.0f - mean, real(1e-4f));
    real3 bounced = bounced_share(p, mean);
    value = value + bounced * (eye_lost * light_lost / mean_lost * lambert_value() * cos_light);

    // The base, by the brightest of the colours that the facets keep from it.
    real most_f0 = largest(p.f0);
    real most_bounced = largest(bounced);
    real eye_kept = min(most_f0 * eye_albedo.x + p.f90 * eye_albedo.y + most_bounced * eye_lost, real(1.0f));
    real light_kept = min(most_f0 * light_albedo.x + p.f90 * light_albedo.y + most_bounced * light_lost, real(1.0f));
    real mean_kept = min(most_f0 * mean_albedo.x + p.f90 * mean_albedo.y + most_bounced * mean_lost, real(0.9999f));
    if (any_lane(p.film > real(0.0f))) {
        real3 film_eye = thin_film_reflectance(to_eye.z, p.film_ior, p.film_nm, p.f0);
        real3 film_light = thin_film_reflectance(cos_light, p.film_ior, p.film_nm, p.f0);
        eye_kept = max(eye_kept, p.film * largest(film_eye));
        light_kept = max(light_kept, p.film * largest(film_light));
    }
    real reaches = (1.0f - eye_kept) * (1.0f - light_kept) / (1.0f - mean_kept);
    real matt = (1.0f - p.metallic) * (1.0f - p.transmission) * reaches * lambert_value() * cos_light;
    value = value + p.base * matt;
    real most_sheen = largest(p.sheen);
    if (any_lane(most_sheen > real(0.0f))) {
        real kept = 1.0f - most_sheen * max(sheen_albedo(SCENE_ to_eye.z, p.sheen_roughness),
                                            sheen_albedo(SCENE_ cos_light, p.sheen_roughness));
        value =
            value * max(kept, real(0.0f)) + p.sheen * (sheen_value(to_eye, to_light, p.sheen_roughness) * cos_light);
    }
    value = value * passes;
    if (any_lane(p.coat > real(0.0f))) {
        real3 coat_h = seen_by_coat(p, h);
        real coat =
            coat_reflectance(p.coat, eye_half) * ggx_value(coat_eye, coat_light, coat_h, p.coat_alpha, p.coat_alpha);
        mask seen = mask_and(coat_eye.z > real(0.0f), coat_light.z > real(0.0f));
        value = value + real3(select(seen, coat * coat_light.z, real(0.0f)));
        real coat_density = ggx_density(coat_eye, coat_h, p.coat_alpha, p.coat_alpha);
        density = density + select(seen, shares.coat * coat_density, real(0.0f));
    }
    value = select(above, value, black);
    density = select(above, density, real(0.0f));

    mask behind = mask_and(p.transmission > real(0.0f), to_light.z < real(0.0f));
    if (any_lane(behind)) {
        // Thin walls are those of facets that mirror to the other side.
        real3 flipped = real3(to_light.x, to_light.y, -to_light.z);
        real3 thin_h = to_eye + flipped;
        thin_h = thin_h * (1.0f / sqrt(max(dot(thin_h, thin_h), real(1e-20f))));
        real3 thick_h = refracting_facet(to_eye, to_light, p.eta);
        real3 facet = select(p.thin, thin_h, thick_h);
        real3 thrown_back = facet_reflectance(p, dot(to_eye, facet));
        real through = select(p.thin, ggx_value(to_eye, flipped, thin_h, p.alpha_x, p.alpha_y),
                              rough_refraction_value(to_eye, to_light, thick_h, p.eta, p.alpha_x, p.alpha_y));
        real drawn = select(p.thin, ggx_density(to_eye, thin_h, p.alpha_x, p.alpha_y),
                            rough_refraction_density(to_eye, to_light, thick_h, p.eta, p.alpha_x, p.alpha_y));
        real3 clear = max(white - thrown_back, black) * p.base *
                      (p.transmission * (1.0f - p.metallic) * passes * through * cos_light);
        value = select(behind, clear, value);
        density = select(behind, shares.facet * (1.0f - reflected_share(p, thrown_back)) * drawn, density);
    }
}

/// A direction, drawn as principled_value() says; it may have density 0 there, and is zero where a facet would send
/// light to the wrong side. `choice` draws the way.
FN real3 principled_direction(SCENE Principled p, real3 to_eye, real2 u, real choice) {
    PrincipledShares shares = principled_shares(SCENE_ p, to_eye);
    mask matt = choice < shares.matt;
    mask coat = mask_and(mask_not(matt), choice >= shares.matt + shares.facet);
    real alpha_x = select(coat, p.coat_alpha, p.alpha_x);
    real alpha_y = select(coat, p.coat_alpha, p.alpha_y);
    mask bent = mask_and(coat, p.coat_normal.z < real(0.999999f));
    real3 from = to_eye;
    if (any_lane(bent)) from = select(bent, seen_by_coat(p, to_eye), from);
    real3 h = ggx_normal(from, alpha_x, alpha_y, u);
    if (any_lane(bent)) h = select(bent, to_world(frame_around(p.coat_normal), h), h);
    real eye_half = dot(to_eye, h);
    real3 mirrored = h * (2.0f * eye_half) - to_eye;
    real3 nowhere = real3(real(0.0f));
    real3 direction = select(matt, lambert_direction(u), select(mirrored.z > real(0.0f), mirrored, nowhere));
    if (any_lane(p.transmission > real(0.0f))) {
        real left = (choice - shares.matt) / max(shares.facet, real(1e-10f));
        mask goes_through =
            mask_and(left >= reflected_share(p, facet_reflectance(p, eye_half)), p.transmission > real(0.0f));
        goes_through = mask_and(goes_through, mask_not(mask_or(matt, coat)));
        real3 refracted;
        refract_direction(-to_eye, h, p.eta, refracted);
        real3 straight = real3(mirrored.x, mirrored.y, -mirrored.z);
        real3 beyond = select(p.thin, straight, refracted);
        direction = select(goes_through, select(beyond.z < real(0.0f), beyond, nowhere), direction);
    }
    return direction;
}

KERNEL_END

#endif
