// SPDX-License-Identifier: Apache-2.0
// Whitted's ray tracing (An Improved Illumination Model for Shaded Display, CACM 1980), iterative.
//
// Before including this header the device defines, in the kernel's namespace:
//   Hit trace_closest(SCENE Ray ray, mask alive, word ray_kind, bool together)
//     the nearest hit in (t_min, t_max); geometry NONE on a miss
//   mask trace_any(SCENE Ray ray, mask alive, word ray_kind)
//     true where anything, opaque or not, lies in between
// ray_kind is one of RAY_*; the lanes' rays start or end close together where `together` says so. Lanes that aren't
// alive may return anything.
#ifndef SUNDOG_KERNEL_INTEGRATORS_WHITTED_H
#define SUNDOG_KERNEL_INTEGRATORS_WHITTED_H

#include "kernel/atmosphere/fog.h"
#include "kernel/atmosphere/rainbow.h"
#include "kernel/atmosphere/sky.h"
#include "kernel/lights/light.h"
#include "kernel/lights/shadow.h"
#include "kernel/materials/bump.h"
#include "kernel/materials/interior.h"
#include "kernel/materials/layers.h"
#include "kernel/materials/material.h"
#ifdef __cplusplus
#include "kernel/integrators/media.h"
#include "kernel/lights/indirect.h"
#endif

KERNEL_BEGIN

/// A ray still to be followed, and how much of its radiance counts.
struct PathState {
    Ray ray;
    real3 weight;
    word depth;  ///< Surfaces before it on its path, in DEPTH_UNITS.
    word kind;   ///< RAY_CAMERA, or RAY_REFLECTED from the first mirror on.
    mask alive;
    Insides insides;     ///< What it is inside of, as far as that is known.
    MediaInsides media;  ///< If FEATURE_HOLLOW: of what its origin is inside, whose media it passes.
#ifdef __cplusplus
    real spectrum;  ///< If FEATURE_DISPERSION: its place there, 0 (violet) to 1 (red); negative: all colours.
    uint nesting;   ///< How many path_radiance() are under way around this one.
#endif
};

/// What the primary ray found, for AOVs (a miss where FrameParams::aovs is 0).
struct FirstHit {
    real t;
    real3 normal;
    real3 albedo;
    word geometry, primitive, material;
};

/// Lanes of `alive` whose surface a light in direction `to_light` lights: their front, or, in the lanes of `behind`,
/// their back, where the material lets that be seen. Not where it is behind the face, or behind the smoothed one.
FN mask lit_lanes(SCENE Surface s, mask patterned, real3 to_light, mask alive, OUT(mask) behind) {
    mask faces = dot(s.normal, to_light) > real(0.0f);
    // Layers have normals of their own, which may turn to a light that the surface's turns from.
    if (FEATURE(FEATURE_NORMALS)) faces = mask_or(faces, patterned);
    real facing = dot(s.geometric_normal, to_light);
    mask lit = mask_and(alive, mask_and(faces, facing > real(0.0f)));
    behind = mask_and(alive, mask_not(alive));
    if (FEATURE(FEATURE_BACKLIT)) {
        mask backlit = (FIELD(materials, s.material, flags) & word(MATERIAL_BACKLIT)) != word(0u);
        behind = mask_and(mask_and(alive, backlit), facing < real(0.0f));
        lit = mask_or(lit, behind);
    }
    return lit;
}

/// Adds what light of number `light_number` does that arrives from one direction in the lanes of `lit`.
FN void add_light(SCENE Surface s, Lobes lobes, LayerColors layered, real3 light_color, uint light_flags,
                  uint light_number, mask lit, mask behind, real3 to_light, real3 to_eye, INOUT(real3) base,
                  INOUT(real3) highlight) {
    light_color = select(lit, light_color, real3(real(0.0f)));
    if (FEATURE(FEATURE_PATTERNED)) {
        light_layers(SCENE_ s, layered, lit, behind, lobes.patterned, light_color, light_flags, light_number, to_light,
                     to_eye, base, highlight);
    }
    base = base + lobes.diffuse * light_color * dot(s.normal, to_light);
    real specular_most = max(lobes.specular.x, max(lobes.specular.y, lobes.specular.z));
    if (any_lane(mask_and(lit, specular_most > real(0.0f)))) {
        real blinn = blinn_phong_highlight(s.normal, to_light, to_eye, lobes.shininess);
        if (any_lane(lobes.phong)) {
            blinn = select(lobes.phong, phong_highlight(s.normal, to_light, to_eye, lobes.shininess), blinn);
        }
        highlight = highlight + lobes.specular * light_color * blinn;
    }
}

/// Light that a surface sends back from the lights alone: matt and emitted light in `base`, highlights apart.
FN void direct_light(SCENE Surface s, Lobes lobes, LayerColors layered, real3 to_eye, MediaInsides media, mask alive,
                     INOUT(RayCounts) counts, OUT(real3) base, OUT(real3) highlight) {
    base = lobes.emission + lobes.ambient * real3(FRAME.ambient);
    highlight = real3(real(0.0f));
    for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
        Light light = AT(lights, i);
        real distance;
        real3 to_light = direction_to_light(light, s.position, distance);
        // An area that illuminates lights from each of its lights, dimmed by the shadow of the area as a whole.
        bool in_parts = FEATURE(FEATURE_LIGHT_SHAPES) && (light.flags & LIGHT_ILLUMINATES) != 0u;
        mask behind;
        mask lit = lit_lanes(SCENE_ s, lobes.patterned, to_light, alive, behind);
        if (in_parts) lit = alive;
        if (FEATURE(FEATURE_LIGHT_GROUPS))
            lit = mask_and(lit, light_reaches(SCENE_ light.group, s.material, lobes.patterned));
        // No shadow ray where nothing is lit.
        if (!any_lane(lit)) continue;
        real3 light_color = real3(light.color);
        if (FEATURE(FEATURE_LIGHT_SHAPES)) {
            if (!in_parts) light_color = light_color * light_share(light, s.position, to_light, distance);
            // Lights may be negative.
            real3 amount = abs(light_color);
            lit = mask_and(lit, max(amount.x, max(amount.y, amount.z)) > real(0.0f));
        }
        if (FEATURE(FEATURE_SHADOWS)) {
            if ((light.flags & LIGHT_SHADOWS) != 0u && any_lane(lit)) {
                real3 off = s.geometric_normal * s.error;
                if (FEATURE(FEATURE_BACKLIT)) off = select(behind, -off, off);
                light_color = light_color *
                              light_visibility(SCENE_ light, s.position + off, to_light, distance, media, lit, counts);
            }
        }
        uint parts = in_parts ? light.area_count_u * light.area_count_v : 1u;
        mask reached = lit;
        real3 color = light_color;
        real3 from = to_light;
        for (uint part = 0u; part < parts; part = part + 1u) {
            if (in_parts) {
                uint column = part % light.area_count_u;
                uint row = part / light.area_count_u;
                real3 place = area_light_place(light, real(place_in_row(column, light.area_count_u)),
                                               real(place_in_row(row, light.area_count_v)), to_light);
                if (light.kind != LIGHT_SUN) place = place - s.position;
                real reach = max(length(place), real(1e-30f));
                from = place * (1.0f / reach);
                lit = lit_lanes(SCENE_ s, lobes.patterned, from, reached, behind);
                color = light_color * (light_share(light, s.position, from, reach) * (1.0f / float(parts)));
            }
            add_light(SCENE_ s, lobes, layered, color, light.flags, i, lit, behind, from, to_eye, base, highlight);
        }
    }
}

/// The ray off a mirror at a surface.
FN Ray mirrored_ray(Surface s, real3 incoming) {
    Ray ray;
    ray.direction = mirror_direction(incoming, s.normal);
    // A smoothed normal can mirror a ray into the face: lift it out along the face's own normal.
    real into = dot(ray.direction, s.geometric_normal);
    real3 lifted = ray.direction - s.geometric_normal * (2.0f * into);
    ray.direction = select(into < real(0.0f), lifted, ray.direction);
    ray.origin = s.position + s.geometric_normal * s.error;
    ray.t_min = real(0.0f);
    ray.t_max = real(3.0e38f);
    return ray;
}

#ifdef __cplusplus
/// path_radiance() from within itself.
inline real3 nested_radiance(SCENE PathState path, INOUT(RayCounts) counts);

KERNEL_END
#include "kernel/integrators/nested.h"
KERNEL_BEGIN
#endif

/// What comes back along the ray of `path`, times its weight, as the scene's numbers have it: before working_gamma.
///
/// On a chain of mirrors with reflectances r_j and own colours c_j the sum is c_0 R_0 + r_0 c_1 R_1 + r_0 r_1 c_2 R_2 +
/// … with R_j = 1 - r_j, but R = 1 for the last: a surface whose secondary ray isn't followed (FrameParams::max_depth
/// or min_weight) counts whole, as if it were no mirror. Where a surface both reflects and refracts, the refracted ray
/// waits on a stack of MAX_BRANCHES entries; when that is full, only the stronger of the two is followed. Highlights
/// sit on the surface: transparency doesn't thin them. Textures of layers add what they reflect and let through to
/// their own light, which counts whole at any depth, as POV-Ray has it.
FN_LARGE real3 path_radiance(SCENE PathState path, INOUT(RayCounts) counts, OUT(FirstHit) first) {
    real3 black = real3(real(0.0f));
    real3 radiance = black;
    PathState waiting[MAX_BRANCHES];
    uint waiting_count = 0u;
    first.t = real(3.0e38f);
    first.normal = black;
    first.albedo = black;
    first.geometry = word(NONE);
    first.primitive = word(NONE);
    first.material = word(NONE);
    bool is_first = true;
    while (true) {
        counts.rays = counts.rays + select(path.alive, word(1u), word(0u));
        Hit hit = trace_closest(SCENE_ path.ray, path.alive, path.kind, is_first);
        mask found = mask_and(path.alive, hit.geometry != word(NONE));
        mask missed = mask_and(path.alive, hit.geometry == word(NONE));
#ifdef __cplusplus
        if (FEATURE(FEATURE_MEDIA)) {
            radiance = radiance + media_radiance(SCENE_ path.ray, select(found, hit.t, real(3.0e38f)), path.media,
                                                 path.alive, path.weight, counts);
        }
#endif
        if (FEATURE(FEATURE_ATMOSPHERE)) {
            if (FRAME.fog_count > 0u) {
                mask in_fog = path.alive;
                if (FEATURE(FEATURE_HOLLOW)) in_fog = mask_and(in_fog, mask_not(in_solid(path.media)));
                real3 dimmed = path.weight;
                real3 glow = fog_radiance(SCENE_ path.ray, select(found, hit.t, real(3.0e38f)), dimmed);
                radiance = radiance + select(in_fog, glow, black);
                path.weight = select(in_fog, dimmed, path.weight);
            }
            if (FRAME.rainbows != NONE) {
                mask in_air = path.alive;
                if (FEATURE(FEATURE_HOLLOW)) in_air = mask_and(in_air, mask_not(in_solid(path.media)));
                real3 dimmed = path.weight;
                real reach = select(found, hit.t, real(3.0e38f));
                real3 glow = rainbow_radiance(SCENE_ FRAME.rainbows, path.ray, reach, dimmed);
                radiance = radiance + select(in_air, glow, black);
                path.weight = select(in_air, dimmed, path.weight);
            }
            if (any_lane(missed)) {
                radiance = radiance + select(missed, path.weight * sky_radiance(SCENE_ path.ray.direction), black);
            }
        } else {
            radiance = radiance + select(missed, path.weight * real3(FRAME.sky), black);
        }
        mask follow = mask_and(found, mask_not(found));
        if (any_lane(found)) {
            Surface s = surface_at(SCENE_ path.ray, hit, found);
            if (FEATURE(FEATURE_BUMP)) s.normal = bumped_normal(SCENE_ s);
            Lobes lobes = evaluate_material(SCENE_ s, path.ray.direction);
            LayerColors layered;
            Crossing crossing;
            real3 smooth_normal = s.normal;
            if (FEATURE(FEATURE_PATTERNED)) {
                word interior = interior_of(SCENE_ s, lobes.patterned);
                crossing = crossing_at(interior, path.insides);
                if (FEATURE(FEATURE_TRANSPARENT)) {
                    real3 dimmed = inside_transmittance(SCENE_ path.insides, hit.t);
                    path.weight = path.weight * select(found, dimmed, real3(real(1.0f)));
                }
                real spectrum = real(0.5f);
#ifdef __cplusplus
                if (FEATURE(FEATURE_DISPERSION)) spectrum = select(path.spectrum < real(0.0f), spectrum, path.spectrum);
#endif
                real eta = crossing_eta(SCENE_ crossing, interior, path.insides, spectrum);
                lobes.eta = select(lobes.patterned, eta, lobes.eta);
                evaluate_layers(SCENE_ s, path.ray.direction, found, false, lobes, layered);
                // Which way light is mirrored and refracted.
                if (FEATURE(FEATURE_NORMALS)) s.normal = layered.mirror;
            }
            real3 base;
            real3 highlight;
            direct_light(SCENE_ s, lobes, layered, -path.ray.direction, path.media, found, counts, base, highlight);
#ifdef __cplusplus
            if (FEATURE(FEATURE_RADIOSITY))
                base = base + indirect_light(SCENE_ s, smooth_normal, lobes, path.weight, found);
#endif
            if (is_first && FRAME.aovs != 0u) {
                first.t = select(found, hit.t, first.t);
                first.normal = select(found, s.normal, black);
                first.albedo = select(found, lobes.albedo, black);
                first.geometry = select(found, s.geometry, word(NONE));
                first.primitive = select(found, s.primitive, word(NONE));
                first.material = select(found, s.material, word(NONE));
            }
            if (FEATURE(FEATURE_MIRRORS | FEATURE_TRANSPARENT)) {
                // Straight on where eta is 1, to the last bit.
                mask straight = mask_and(lobes.patterned, abs(lobes.eta - 1.0f) <= real(0.0f));
                word deepest = word(FRAME.max_depth * DEPTH_UNITS);
                mask deeper = mask_and(found, path.depth < deepest);
                mask deeper_on = mask_and(found, path.depth < select(straight, deepest + word(DEPTH_UNITS), deepest));
                real3 reflected = path.weight * lobes.reflectance;
                real3 transmitted = path.weight * lobes.transmittance;
                real reflected_most = max(reflected.x, max(reflected.y, reflected.z));
                real transmitted_most = max(transmitted.x, max(transmitted.y, transmitted.z));
                mask reflects =
                    mask_and(mask_and(deeper, reflected_most > real(0.0f)), reflected_most >= real(FRAME.min_weight));
                mask transmits = mask_and(mask_and(deeper_on, transmitted_most > real(0.0f)),
                                          transmitted_most >= real(FRAME.min_weight));
#ifdef __cplusplus
                if (FEATURE(FEATURE_EXPONENTS)) {
                    mask bent = mask_and(reflects, abs(lobes.exponent - 1.0f) > real(0.0f));
                    if (any_lane(bent) && path.nesting < MAX_NESTING) {
                        radiance = radiance + exponent_radiance(SCENE_ path, s, lobes, bent, counts);
                        reflects = mask_and(reflects, mask_not(bent));
                    }
                }
                if (FEATURE(FEATURE_DISPERSION)) {
                    mask split = mask_and(transmits, path.spectrum < real(0.0f));
                    split = disperses(SCENE_ s, lobes, split);
                    if (any_lane(split) && path.nesting < MAX_NESTING) {
                        radiance = radiance + dispersed_radiance(SCENE_ path, s, lobes, crossing, split, counts);
                        transmits = mask_and(transmits, mask_not(split));
                    }
                }
#endif
                mask both = mask_and(reflects, transmits);
                if (waiting_count == MAX_BRANCHES) {
                    mask drop_reflected = mask_and(both, reflected_most < transmitted_most);
                    mask drop_transmitted = mask_and(both, mask_not(drop_reflected));
                    reflects = mask_and(reflects, mask_not(drop_reflected));
                    transmits = mask_and(transmits, mask_not(drop_transmitted));
                    both = mask_and(both, mask_not(both));
                }
                real3 r = select(reflects, lobes.reflectance, black);
                real3 t = select(transmits, lobes.transmittance, black);
                real3 one = real3(real(1.0f));
                real3 thinned = base * max(one - r - t, black) + highlight * (one - r);
                real3 own = select(lobes.patterned, base + highlight, thinned);
                radiance = radiance + select(found, path.weight * own, black);

                follow = mask_or(reflects, transmits);
                if (any_lane(follow)) {
                    word reflected_depth = path.depth + word(DEPTH_UNITS);
                    word transmitted_depth = path.depth + select(straight, word(1u), word(DEPTH_UNITS));
                    Insides behind_insides = path.insides;
                    if (FEATURE(FEATURE_PATTERNED)) behind_insides = crossing.behind;
                    real3 incoming = path.ray.direction;
                    Ray next = mirrored_ray(s, incoming);
                    if (FEATURE(FEATURE_TRANSPARENT)) {
                        if (any_lane(transmits)) {
                            real3 refracted_direction;
                            mask passes = refract_direction(incoming, s.normal, lobes.eta, refracted_direction);
                            // Straight on where eta is 1, to the last bit, and where rounding says "total" but Fresnel
                            // did not.
                            mask bends = mask_and(passes, abs(lobes.eta - 1.0f) > real(0.0f));
                            refracted_direction = select(bends, normalize(refracted_direction), incoming);
                            real3 behind = s.position - s.geometric_normal * s.error;
                            MediaInsides beyond = path.media;
                            if (FEATURE(FEATURE_HOLLOW)) beyond = media_beyond(SCENE_ s, beyond, transmits);
                            if (any_lane(both)) {
                                PathState branch;
                                branch.ray.origin = behind;
                                branch.ray.direction = refracted_direction;
                                branch.ray.t_min = real(0.0f);
                                branch.ray.t_max = real(3.0e38f);
                                branch.weight = transmitted;
                                branch.depth = transmitted_depth;
                                branch.insides = behind_insides;
                                branch.kind = path.kind;
                                branch.media = beyond;
                                branch.alive = both;
#ifdef __cplusplus
                                branch.spectrum = path.spectrum;
                                branch.nesting = path.nesting;
#endif
                                waiting[waiting_count] = branch;
                                waiting_count = waiting_count + 1u;
                            }
                            next.origin = select(reflects, next.origin, behind);
                            next.direction = select(reflects, next.direction, refracted_direction);
                            for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
                                path.media.entry[i] = select(reflects, path.media.entry[i], beyond.entry[i]);
                        }
                    }
                    path.weight = select(reflects, reflected, transmitted);
                    path.depth = select(reflects, reflected_depth, transmitted_depth);
                    path.insides.inner = select(reflects, path.insides.inner, behind_insides.inner);
                    path.insides.outer = select(reflects, path.insides.outer, behind_insides.outer);
                    path.kind = select(reflects, word(RAY_REFLECTED), path.kind);
                    path.ray = next;
                }
            } else {
                radiance = radiance + select(found, path.weight * (base + highlight), black);
            }
        }
        path.alive = follow;
        is_first = false;
        if (!any_lane(follow)) {
            if (waiting_count == 0u) break;
            waiting_count = waiting_count - 1u;
            path = waiting[waiting_count];
        }
    }
    return radiance;
}

#ifdef __cplusplus
inline real3 nested_radiance(SCENE PathState path, INOUT(RayCounts) counts) {
    path.nesting = path.nesting + 1u;
    FirstHit unused;
    return path_radiance(SCENE_ path, counts, unused);
}
#endif

/// Linear radiance that comes back along `ray` in the lanes of `alive` (0 in others).
FN real3 whitted_radiance(SCENE Ray ray, mask alive, INOUT(RayCounts) counts, OUT(FirstHit) first) {
    PathState path;
    path.ray = ray;
    path.weight = real3(real(1.0f));
    path.depth = word(0u);
    path.kind = word(RAY_CAMERA);
    path.media = eye_insides(SCENE_ alive);
    path.alive = alive;
    path.insides = insides_of_eye(SCENE_ alive);
#ifdef __cplusplus
    path.kind = word(scene.first_ray_kind);
    path.spectrum = real(-1.0f);
    path.nesting = 0u;
#endif
    real3 radiance = path_radiance(SCENE_ path, counts, first);
    real3 black = real3(real(0.0f));
    if (FRAME.working_gamma != 1.0f) {
        radiance = max(radiance, black);
        if (FRAME.working_gamma > 0.0f) {
            real gamma = real(FRAME.working_gamma);
            radiance = real3(power(radiance.x, gamma), power(radiance.y, gamma), power(radiance.z, gamma));
        } else {
            radiance = real3(srgb_decoded(radiance.x), srgb_decoded(radiance.y), srgb_decoded(radiance.z));
        }
    }
    return radiance;
}

KERNEL_END

#endif
