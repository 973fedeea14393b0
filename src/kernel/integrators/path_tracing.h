// SPDX-License-Identifier: Apache-2.0
// Path tracing (Kajiya, The Rendering Equation, SIGGRAPH 1986) with light that is aimed at and light that is met,
// weighed by multiple importance sampling (Veach 1997, chapter 9), and Russian roulette (Arvo and Kirk 1990).
//
// Surfaces are those of Whitted's integrator: what a light of colour 1 makes of them is pi times their BSDF times the
// cosine. Surfaces that shine are lights; lights without size are those of Whitted's integrator, with areas for soft
// shadows. Of ambient light there is none. Transparent surfaces that bend light stand in its way, except in that of
// lights without size, which no path could meet.
//
// The device defines its traversal first (see whitted.h).
#ifndef SUNDOG_KERNEL_INTEGRATORS_PATH_TRACING_H
#define SUNDOG_KERNEL_INTEGRATORS_PATH_TRACING_H

#include "kernel/atmosphere/sky.h"
#include "kernel/bsdf/blinn_phong.h"
#include "kernel/bsdf/frame.h"
#include "kernel/integrators/air.h"
#include "kernel/integrators/path.h"
#include "kernel/integrators/surface_met.h"
#include "kernel/lights/direct.h"
#include "kernel/lights/emitter.h"
#include "kernel/materials/bsdf_material.h"
#include "kernel/materials/spectrum.h"
#include "kernel/sequences.h"

KERNEL_BEGIN

/// A path under way.
struct TracedPath {
    Ray ray;
    real3 weight;
    word vertices;  ///< Surfaces met so far.
    word kind;      ///< RAY_*
    real density;   ///< Over solid angle, with which the ray's direction was drawn; 0: it was the only one.
    PathSample sample;
    real spectrum;  ///< If FEATURE_DISPERSION: the place in the spectrum by which it is refracted,
    mask colored;   ///< and where it has been, so that it has that colour.
    Insides insides;
    MediaInsides media;
    mask alive;
};

/// A path that starts with a camera's ray.
FN TracedPath begun_path(SCENE Ray ray, PathSample sample, mask alive) {
    TracedPath path;
    path.ray = ray;
    path.weight = real3(real(1.0f));
    path.vertices = word(0u);
    path.kind = word(RAY_CAMERA);
    path.density = real(0.0f);
    path.sample = sample;
    path.spectrum = real(0.5f);
    path.colored = mask(false);
    if (FEATURE(FEATURE_DISPERSION)) path.spectrum = sample_pair(sample, word(2u)).x;
    path.insides = insides_of_eye(SCENE_ alive);
    path.media = eye_insides(SCENE_ alive);
    path.alive = alive;
    return path;
}

/// Puts `other` in the lanes of m.
FN void take_path(mask m, TracedPath other, INOUT(TracedPath) path) {
    path.ray.origin = select(m, other.ray.origin, path.ray.origin);
    path.ray.direction = select(m, other.ray.direction, path.ray.direction);
    path.ray.t_min = select(m, other.ray.t_min, path.ray.t_min);
    path.ray.t_max = select(m, other.ray.t_max, path.ray.t_max);
    path.weight = select(m, other.weight, path.weight);
    path.vertices = select(m, other.vertices, path.vertices);
    path.kind = select(m, other.kind, path.kind);
    path.density = select(m, other.density, path.density);
    path.sample.pixel = select(m, other.sample.pixel, path.sample.pixel);
    path.sample.index = select(m, other.sample.index, path.sample.index);
    path.spectrum = select(m, other.spectrum, path.spectrum);
    path.colored = select_mask(m, other.colored, path.colored);
    path.insides.inner = select(m, other.insides.inner, path.insides.inner);
    path.insides.outer = select(m, other.insides.outer, path.insides.outer);
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
        path.media.entry[i] = select(m, other.media.entry[i], path.media.entry[i]);
    path.alive = select_mask(m, other.alive, path.alive);
}

/// Choices at each vertex: the direction, the place of a light, and which lobe and light.
const uint CHOICES_A_VERTEX = 3u;
/// The first of them; those before are the camera's.
const uint FIRST_CHOICE = 4u;

/// From how many surfaces on paths that bring little are ended at random.
const uint ROULETTE_AFTER = 2u;

/// How directions are drawn at a surface. Shares are of what goes on: matt and glossy ones in all directions, one that
/// is mirrored, one that passes through.
struct Scatter {
    real rough, mirrored, through;  ///< Shares; they add up to 1 where the path can go on at all.
    real gloss;                     ///< Of the rough share, how much is drawn for highlights,
    real exponent;                  ///< of this sharpness.
    mask own;                       ///< Rough directions are those of a reflection model of the material's own,
    word model;                     ///< number `model` of `bsdfs`,
    mask clear;                     ///< and light comes through it from behind.
};

/// The sharpest highlight of layers counts, and the share of all.
FN void layers_gloss(SCENE Surface s, LARGE(LayerColors) layered, mask patterned_lanes, INOUT(real) gloss,
                     INOUT(real) exponent) {
    mask todo = patterned_lanes;
    word look = FIELD(patterned, valid_index(todo, FIELD(materials, s.material, patterned)), look);
    while (any_lane(todo)) {
        uint i = first_lane(todo, look);
        mask here = mask_and(todo, look == word(i));
        todo = mask_and(todo, mask_not(here));
        PatternedMaterial m = AT(patterned, i);
        for (uint l = 0u; l < m.layer_count; l = l + 1u) {
            Layer layer = AT(layers, m.first_layer + l);
            real seen = largest(layered.above[l]);
            if (layer.specular > 0.0f) {
                gloss =
                    gloss + select(here, seen * (layer.specular * 8.0f / (layer.specular_exponent + 8.0f)), real(0.0f));
                exponent = max(exponent, select(here, real(layer.specular_exponent), real(0.0f)));
            }
            if (layer.phong > 0.0f) {
                // A mirrored ray's angle is about twice a halfway vector's.
                gloss = gloss + select(here, seen * (layer.phong * 2.0f / (layer.phong_size + 2.0f)), real(0.0f));
                exponent = max(exponent, select(here, real(4.0f * layer.phong_size), real(0.0f)));
            }
        }
    }
}

/// By how much light each of its ways brings on.
FN Scatter scatter_of(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, mask found) {
    real matt = largest(lobes.diffuse);
    real gloss = largest(lobes.specular) * 8.0f / (lobes.shininess + 8.0f);
    Scatter scatter;
    scatter.exponent = select(lobes.phong, lobes.shininess * 4.0f, lobes.shininess);
    if (FEATURE(FEATURE_PATTERNED)) {
        mask patterned_lanes = mask_and(found, lobes.patterned);
        matt = select(lobes.patterned, largest(lobes.albedo), matt);
        gloss = select(lobes.patterned, real(0.0f), gloss);
        scatter.exponent = select(lobes.patterned, real(0.0f), scatter.exponent);
        layers_gloss(SCENE_ s, layered, patterned_lanes, gloss, scatter.exponent);
    }
    real rough = max(matt, real(0.0f)) + max(gloss, real(0.0f));
    real mirrored = max(largest(lobes.reflectance), real(0.0f));
    real through = max(largest(lobes.transmittance), real(0.0f));
    real all = rough + mirrored + through;
    real per_all = select(all > real(0.0f), 1.0f / max(all, real(1e-30f)), real(0.0f));
    scatter.rough = rough * per_all;
    scatter.mirrored = mirrored * per_all;
    scatter.through = through * per_all;
    scatter.gloss = max(gloss, real(0.0f)) / max(rough, real(1e-30f));
    scatter.own = mask_and(found, mask_not(found));
    scatter.clear = scatter.own;
    scatter.model = word(0u);
    return scatter;
}

/// Density over solid angle of drawing a rough direction. Vectors are local to the normal.
FN real rough_density(Scatter scatter, real3 to_eye, real3 to_light) {
    real matt = max(to_light.z, real(0.0f)) * 0.318309886f;
    real density = matt;
    if (any_lane(scatter.gloss > real(0.0f)))
        density = mix(matt, blinn_phong_density(to_eye, to_light, scatter.exponent), scatter.gloss);
    return density * scatter.rough;
}

/// Lanes of `alive` that light from a direction lights; in the lanes of `behind` it comes from the back.
FN mask scattering_lanes(SCENE Surface s, Lobes lobes, Scatter scatter, real3 to_light, mask alive, OUT(mask) behind) {
    mask lit = lit_lanes(SCENE_ s, lobes.patterned, to_light, alive, behind);
    if (FEATURE(FEATURE_BSDF)) {
        mask through = mask_and(mask_and(alive, scatter.clear), dot(s.geometric_normal, to_light) < real(0.0f));
        through = mask_and(through, dot(s.normal, to_light) < real(0.0f));
        behind = mask_or(behind, through);
        lit = mask_or(lit, through);
    }
    return lit;
}

/// What a light of colour 1 from a direction makes of the surface in the lanes of `lit` (pi times BSDF times cosine),
/// and the density over solid angle of drawing that direction.
FN_LARGE real3 scattered_light(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, LARGE(BsdfPoint) point,
                               Scatter scatter, ShadingFrame frame, mask lit, mask behind, real3 to_light, real3 to_eye,
                               OUT(real) density) {
    real3 black = real3(real(0.0f));
    real3 base = black;
    real3 highlight = base;
    density = real(0.0f);
    real3 local_eye = to_local(frame, to_eye);
    real3 local_light = to_local(frame, to_light);
    mask plain = mask_and(lit, mask_not(scatter.own));
    if (any_lane(plain)) {
        add_light(SCENE_ s, lobes, layered, real3(real(1.0f)), LIGHT_HIGHLIGHTS, 0u, plain, behind, to_light, to_eye,
                  base, highlight);
        density = rough_density(scatter, local_eye, local_light);
    }
    real3 value = select(plain, base + highlight, black);
    if (FEATURE(FEATURE_BSDF)) {
        mask own = mask_and(lit, scatter.own);
        if (any_lane(own)) {
            real3 own_value;
            real own_density;
            bsdf_values(SCENE_ scatter.model, point, local_eye, local_light, own, own_value, own_density);
            value = select(own, own_value * (scatter.rough * 3.14159265f), value);
            density = select(own, own_density * scatter.rough, density);
        }
    }
    return value;
}

/// Light of the lights without size, in lanes that drew one of them (an area: any point of it), over its probability.
FN real3 light_from_points(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, LARGE(BsdfPoint) point,
                           Scatter scatter, ShadingFrame frame, MediaInsides media, EmitterChoice choice, real2 u,
                           real3 to_eye, mask asked, INOUT(RayCounts) counts) {
    real3 black = real3(real(0.0f));
    real3 sum = black;
    mask todo = asked;
    while (any_lane(todo)) {
        uint number = first_lane(todo, choice.index);
        mask here = mask_and(todo, choice.index == word(number));
        todo = mask_and(todo, mask_not(here));
        Light light = AT(lights, number);
        real distance;
        real3 to_light = direction_to_light(light, s.position, distance);
        real3 place = real3(light.place);
        real3 toward = to_light;
        real reach = distance;
        if (light.area_count_u * light.area_count_v > 1u) {
            place = area_light_place(light, u.x - 0.5f, u.y - 0.5f, to_light);
            real3 to_place = light.kind == LIGHT_SUN ? place : place - s.position;
            reach = max(length(to_place), real(1e-30f));
            toward = to_place * (1.0f / reach);
            if (light.kind == LIGHT_SUN) reach = distance;
        }
        // An area's middle lights, unless it illuminates: as in Whitted's integrator.
        bool in_parts = (light.flags & LIGHT_ILLUMINATES) != 0u;
        real3 from = in_parts ? toward : to_light;
        mask behind;
        mask lit = scattering_lanes(SCENE_ s, lobes, scatter, from, here, behind);
        if (FEATURE(FEATURE_LIGHT_GROUPS))
            lit = mask_and(lit, light_reaches(SCENE_ light.group, s.material, lobes.patterned));
        real3 color = real3(light.color);
        if (FEATURE(FEATURE_LIGHT_SHAPES))
            color = color * light_share(light, s.position, from, in_parts ? reach : distance);
        real3 amount = abs(color);
        lit = mask_and(lit, largest(amount) > real(0.0f));
        if (!any_lane(lit)) continue;
        real met;
        real3 value =
            color * scattered_light(SCENE_ s, lobes, layered, point, scatter, frame, lit, behind, from, to_eye, met);
        if (FEATURE(FEATURE_SHADOWS)) {
            if ((light.flags & LIGHT_SHADOWS) != 0u) {
                real3 off = s.geometric_normal * s.error;
                if (FEATURE(FEATURE_BACKLIT | FEATURE_BSDF)) off = select(behind, -off, off);
                Ray shadow;
                shadow.origin = s.position + off;
                shadow.t_min = real(0.0f);
                shadow.direction = toward;
                shadow.t_max = reach;
                if (light.kind == LIGHT_LAMP || light.kind == LIGHT_SPOT) {
                    real3 to_place = place - shadow.origin;
                    real away = length(to_place);
                    shadow.direction = to_place * (1.0f / max(away, real(1e-30f)));
                    shadow.t_max = away - hit_error(shadow.origin, place, away);
                } else if (light.kind != LIGHT_SUN) {
                    shadow.t_max = reach - hit_error(shadow.origin, place, reach);
                }
                value = value * ray_transmittance(SCENE_ light, shadow, media, lit, counts);
            }
        }
        sum = sum + select(lit, value * (1.0f / choice.probability), black);
    }
    return sum;
}

/// Light that is aimed at: one emitter is drawn, and a place of it. `u` draws the place, `pick` the emitter. Where the
/// path `ends`, no further ray could meet it.
FN_LARGE real3 aimed_light(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, LARGE(BsdfPoint) point,
                           Scatter scatter, ShadingFrame frame, MediaInsides media, real2 u, real pick, real3 to_eye,
                           mask ends, mask asked, INOUT(RayCounts) counts) {
    real3 black = real3(real(0.0f));
    EmitterChoice choice = choose_emitter(SCENE_ pick);
    // Where further rays start from, too: both ways of finding a place have to see it from one point.
    real3 from = s.position + s.geometric_normal * s.error;
    EmitterSample drawn;
    drawn.to_light = s.normal;
    drawn.distance = real(3.0e38f);
    drawn.radiance = black;
    drawn.density = real(1.0f);
    mask on_triangle = mask_and(asked, choice.kind == word(EMITTER_TRIANGLE));
    if (any_lane(on_triangle)) {
        EmitterSample sample = sample_triangle(SCENE_ choice, from, u, on_triangle);
        drawn.to_light = select(on_triangle, sample.to_light, drawn.to_light);
        drawn.distance = select(on_triangle, sample.distance, drawn.distance);
        drawn.radiance = select(on_triangle, sample.radiance, drawn.radiance);
        drawn.density = select(on_triangle, sample.density, drawn.density);
    }
    if (FEATURE(FEATURE_ANALYTIC)) {
        mask on_sphere = mask_and(asked, choice.kind == word(EMITTER_SPHERE));
        if (any_lane(on_sphere)) {
            EmitterSample sample = sample_sphere(SCENE_ choice, from, u, on_sphere);
            drawn.to_light = select(on_sphere, sample.to_light, drawn.to_light);
            drawn.distance = select(on_sphere, sample.distance, drawn.distance);
            drawn.radiance = select(on_sphere, sample.radiance, drawn.radiance);
            drawn.density = select(on_sphere, sample.density, drawn.density);
        }
    }
    mask to_environment = mask_and(asked, mask_not(asked));
    if (FEATURE(FEATURE_ENVIRONMENT)) {
        to_environment = mask_and(asked, choice.kind == word(EMITTER_ENVIRONMENT));
        if (any_lane(to_environment)) {
            real density;
            real3 direction = environment_direction(SCENE_ u, density);
            drawn.to_light = select(to_environment, direction, drawn.to_light);
            drawn.radiance = select(to_environment, environment_radiance(SCENE_ direction), drawn.radiance);
            drawn.density = select(to_environment, density * choice.probability, drawn.density);
        }
    }
    real3 sum = black;
    mask behind;
    mask lit = scattering_lanes(SCENE_ s, lobes, scatter, drawn.to_light, asked, behind);
    lit = mask_and(lit, mask_and(largest(drawn.radiance) > real(0.0f), drawn.density > real(0.0f)));
    if (any_lane(lit)) {
        real met;
        real3 value =
            scattered_light(SCENE_ s, lobes, layered, point, scatter, frame, lit, behind, drawn.to_light, to_eye, met);
        real share = select(ends, real(1.0f), power_heuristic(drawn.density, met));
        value = value * drawn.radiance * (share * 0.318309886f / drawn.density);
        lit = mask_and(lit, largest(value) > real(0.0f));
        if (any_lane(lit)) {
            real3 off = s.geometric_normal * s.error;
            if (FEATURE(FEATURE_BACKLIT | FEATURE_BSDF)) off = select(behind, -off, off);
            Ray shadow;
            shadow.origin = s.position + off;
            real3 place = from + drawn.to_light * select(to_environment, real(0.0f), drawn.distance);
            real3 to_place = place - shadow.origin;
            real away = length(to_place);
            shadow.t_min = real(0.0f);
            shadow.direction = select(to_environment, drawn.to_light, to_place * (1.0f / max(away, real(1e-30f))));
            shadow.t_max = select(to_environment, drawn.distance, away - hit_error(shadow.origin, place, away));
            real3 passes =
                shadow_transmittance(SCENE_ shadow, media, LIGHT_ATTENUATED | LIGHT_MET_BY_PATHS, lit, counts);
            sum = select(lit, value * passes, black);
        }
    }
    if (FRAME.light_count > 0u) {
        mask at_point = mask_and(asked, choice.kind == word(EMITTER_LIGHT));
        if (any_lane(at_point))
            sum = sum + light_from_points(SCENE_ s, lobes, layered, point, scatter, frame, media, choice, u, to_eye,
                                          at_point, counts);
    }
    return sum;
}

/// What paths see that leave the scene.
FN real3 background_met(SCENE TracedPath path, mask missed) {
    real3 seen = background_radiance(SCENE_ path.ray.direction);
    if (FEATURE(FEATURE_ENVIRONMENT)) {
        mask chosen = mask_and(missed, path.density > real(0.0f));
        if (any_lane(chosen)) {
            real other = environment_density(SCENE_ path.ray.direction) * FRAME.environment.probability;
            seen = seen * select(chosen, power_heuristic(path.density, other), real(1.0f));
        }
    }
    return seen;
}

/// Sets the path's next ray, and its weight; paths without one end. `choice` draws the lobe, `u` the direction.
FN void scatter_path(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, LARGE(BsdfPoint) point,
                     Crossing crossing, Scatter scatter, ShadingFrame frame, real2 u, real choice, mask found,
                     INOUT(TracedPath) path) {
    real3 black = real3(real(0.0f));
    real3 incoming = path.ray.direction;
    mask rough = mask_and(found, choice < scatter.rough);
    mask through = mask_and(found, choice >= scatter.rough + scatter.mirrored);
    mask mirrored = mask_and(mask_and(found, mask_not(rough)), mask_not(through));
    through = mask_and(through, scatter.through > real(0.0f));
    mirrored = mask_and(mirrored, scatter.mirrored > real(0.0f));

    Ray next = mirrored_ray(s, incoming);
    real3 carried = black;
    path.density = real(0.0f);
    if (any_lane(rough)) {
        real3 to_eye = to_local(frame, -incoming);
        real3 local = cosine_direction(u);
        if (any_lane(mask_and(rough, scatter.gloss > real(0.0f)))) {
            // What is left of the number that drew the lobe says whether it is for the highlight.
            mask glossy = choice < scatter.rough * scatter.gloss;
            local = select(glossy, blinn_phong_direction(to_eye, scatter.exponent, u), local);
        }
        mask drawn = rough;
        if (FEATURE(FEATURE_BSDF)) {
            mask own = mask_and(rough, scatter.own);
            if (any_lane(own)) {
                real left = choice / max(scatter.rough, real(1e-10f));
                local = select(own, bsdf_directions(SCENE_ scatter.model, point, to_eye, u, left, own), local);
                drawn = mask_and(rough, dot(local, local) > real(0.5f));
            }
        }
        real3 direction = to_world(frame, select(drawn, local, real3(real(0.0f), real(0.0f), real(1.0f))));
        direction = normalize(direction);
        mask behind;
        mask lit = scattering_lanes(SCENE_ s, lobes, scatter, direction, drawn, behind);
        real density;
        real3 value = scattered_light(SCENE_ s, lobes, layered, point, scatter, frame, lit,
                                      mask_and(behind, mask_not(behind)), direction, -incoming, density);
        lit = mask_and(lit, density > real(0.0f));
        carried = select(lit, value * (0.318309886f / max(density, real(1e-30f))), black);
        if (FEATURE(FEATURE_BSDF)) {
            mask beyond = mask_and(rough, mask_and(behind, scatter.own));
            next.origin = select(beyond, s.position - s.geometric_normal * s.error, next.origin);
        }
        next.direction = select(rough, direction, next.direction);
        path.density = select(rough, density, path.density);
    }
    if (FEATURE(FEATURE_MIRRORS | FEATURE_TRANSPARENT))
        carried = select(mirrored, lobes.reflectance * (1.0f / max(scatter.mirrored, real(1e-30f))), carried);
    if (FEATURE(FEATURE_TRANSPARENT)) {
        if (any_lane(through)) {
            real3 refracted;
            mask passes = refract_direction(incoming, s.normal, lobes.eta, refracted);
            mask bends = mask_and(passes, abs(lobes.eta - 1.0f) > real(0.0f));
            next.direction = select(through, select(bends, normalize(refracted), incoming), next.direction);
            next.origin = select(through, s.position - s.geometric_normal * s.error, next.origin);
            carried = select(through, lobes.transmittance * (1.0f / max(scatter.through, real(1e-30f))), carried);
            if (FEATURE(FEATURE_DISPERSION)) {
                mask splits = disperses(SCENE_ s, lobes, mask_and(through, lobes.patterned));
                splits = mask_and(splits, mask_not(path.colored));
                carried = select(splits, carried * spectrum_light(path.spectrum), carried);
                path.colored = mask_or(path.colored, splits);
            }
            if (FEATURE(FEATURE_PATTERNED)) {
                path.insides.inner = select(through, crossing.behind.inner, path.insides.inner);
                path.insides.outer = select(through, crossing.behind.outer, path.insides.outer);
            }
            if (FEATURE(FEATURE_HOLLOW)) {
                MediaInsides beyond = media_beyond(SCENE_ s, path.media, through);
                for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
                    path.media.entry[i] = select(through, beyond.entry[i], path.media.entry[i]);
            }
        }
    }
    path.kind = select(through, path.kind, word(RAY_REFLECTED));
    path.ray = next;
    path.weight = path.weight * carried;
    path.alive = mask_and(found, largest(path.weight) > real(0.0f));
}

/// Where materials have reflection models of their own, these take the place of the lobes.
FN void take_bsdf(SCENE mask found, real distance, INOUT(TracedPath) path, INOUT(Surface) s, INOUT(Lobes) lobes,
                  INOUT(Scatter) scatter, INOUT(ShadingFrame) frame, OUT(BsdfPoint) point) {
    real3 black = real3(real(0.0f));
    word model = FIELD(materials, s.material, bsdf);
    mask own = mask_and(found, model != word(NONE));
    scatter.own = own;
    scatter.model = valid_index(own, model);
    if (!any_lane(own)) return;
    // A bent or smoothed normal that faces away from the eye says nothing.
    mask away = mask_and(own, dot(s.normal, path.ray.direction) > real(-1e-3f));
    s.normal = select(away, s.geometric_normal, s.normal);
    ShadingFrame around = frame_around(s.normal);
    point = bsdf_at(SCENE_ s, own, path.spectrum, around);
    if (FEATURE(FEATURE_DISPERSION)) {
        mask splits = mask_and(own, FIELD(bsdfs, scatter.model, dispersion) > real(0.0f));
        splits = mask_and(splits, mask_not(path.colored));
        path.weight = select(splits, path.weight * spectrum_light(path.spectrum), path.weight);
        path.colored = mask_or(path.colored, splits);
    }
    frame.x = select(own, around.x, frame.x);
    frame.y = select(own, around.y, frame.y);
    frame.z = select(own, around.z, frame.z);
    real opacity = bsdf_opacity(SCENE_ s, scatter.model);
    scatter.rough = select(own, opacity, scatter.rough);
    scatter.mirrored = select(own, real(0.0f), scatter.mirrored);
    scatter.through = select(own, 1.0f - opacity, scatter.through);
    scatter.clear = bsdf_is_clear(SCENE_ scatter.model, point, own);
    lobes.transmittance = select(own, real3(1.0f - opacity), lobes.transmittance);
    lobes.reflectance = select(own, black, lobes.reflectance);
    lobes.eta = select(own, real(1.0f), lobes.eta);
    // Inside, light dims on its way.
    mask inside = mask_and(own, s.from_behind);
    if (any_lane(inside)) {
        real3 rate = FIELD(bsdfs, scatter.model, attenuation) * (distance * -1.44269504f);
        real3 passes = real3(exp2_clamped(rate.x), exp2_clamped(rate.y), exp2_clamped(rate.z));
        path.weight = select(inside, path.weight * passes, path.weight);
    }
}

/// Ends paths that bring little at random, so that the others stand for them.
FN void play_roulette(INOUT(TracedPath) path) {
    mask plays = mask_and(path.alive, word(ROULETTE_AFTER) < path.vertices);
    if (!any_lane(plays)) return;
    real survival = clamp(largest(path.weight), real(0.05f), real(1.0f));
    real drawn = sample_hash(path.sample, path.vertices);
    mask ends = mask_and(plays, drawn >= survival);
    path.alive = mask_and(path.alive, mask_not(ends));
    path.weight = select(plays, path.weight * (1.0f / survival), path.weight);
}

/// Follows each path to the next surface: adds to `radiance` what it finds there, and leaves the path with its next
/// ray, or ended. `first` gets what paths meet first. `together`: all are at their first.
FN void extend_path(SCENE bool together, INOUT(TracedPath) path, INOUT(real3) radiance, INOUT(RayCounts) counts,
                    INOUT(FirstHit) first) {
    real3 black = real3(real(0.0f));
    counts.rays = counts.rays + select(path.alive, word(1u), word(0u));
#ifdef SUNDOG_KERNEL_SHORTCUTS
    Hit hit = trace_closest(SCENE_ path.ray, path.alive, path.kind, together, nullptr);
#else
    Hit hit = trace_closest(SCENE_ path.ray, path.alive, path.kind, together);
#endif
    mask found = mask_and(path.alive, hit.geometry != word(NONE));
    mask missed = mask_and(path.alive, hit.geometry == word(NONE));
    real reach = select(found, hit.t, real(3.0e38f));
    cross_air(SCENE_ path.ray, reach, path.media, path.alive, path.weight, radiance, counts);
    if (any_lane(missed))
        radiance = radiance + select(missed, path.weight * background_met(SCENE_ path, missed), black);
    path.alive = found;
    if (!any_lane(found)) return;

    Surface s;
    Lobes lobes;
    LayerColors layered;
    Crossing crossing;
    real3 smooth_normal;
    real3 dimmed = surface_met(SCENE_ path.ray, hit, path.insides, path.spectrum, found, s, lobes, layered, crossing,
                               smooth_normal);
    path.weight = path.weight * dimmed;
    if (FRAME.aovs != 0u) {
        mask is_first = mask_and(found, path.vertices == word(0u));
        first.t = select(is_first, hit.t, first.t);
        first.normal = select(is_first, s.normal, first.normal);
        first.albedo = select(is_first, lobes.albedo, first.albedo);
        first.geometry = select(is_first, s.geometry, first.geometry);
        first.primitive = select(is_first, s.primitive, first.primitive);
        first.material = select(is_first, s.material, first.material);
    }
    // Textures of layers add what they reflect to their own light; others share it out.
    if (FEATURE(FEATURE_MIRRORS | FEATURE_TRANSPARENT)) {
        real3 white = real3(real(1.0f));
        real3 kept = max(white - lobes.reflectance - lobes.transmittance, black);
        lobes.diffuse = select(lobes.patterned, lobes.diffuse, lobes.diffuse * kept);
        lobes.specular = select(lobes.patterned, lobes.specular, lobes.specular * (white - lobes.reflectance));
    }
    Scatter scatter = scatter_of(SCENE_ s, lobes, layered, found);
    ShadingFrame frame = frame_around(s.normal);
    BsdfPoint point;
    if (FEATURE(FEATURE_BSDF)) take_bsdf(SCENE_ found, hit.t, path, s, lobes, scatter, frame, point);
    real3 emission = lobes.emission + lobes.ambient * real3(FRAME.ambient);
    if (any_lane(mask_and(found, largest(emission) > real(0.0f)))) {
        real share = real(1.0f);
        mask chosen = mask_and(found, path.density > real(0.0f));
        if (any_lane(chosen)) {
            real other = emitter_density(SCENE_ path.ray, hit, s, chosen);
            share = select(chosen, power_heuristic(path.density, other), share);
        }
        radiance = radiance + select(found, path.weight * emission * share, black);
    }
    word dimension = path.vertices * word(CHOICES_A_VERTEX) + word(FIRST_CHOICE);
    real2 picks = sample_pair(path.sample, dimension + word(2u));
    mask ends = mask_not(path.vertices < word(FRAME.max_depth));
    if (FRAME.emitter_count > 0u) {
        mask asked = mask_and(found, scatter.rough > real(0.0f));
        if (any_lane(asked)) {
            real2 place = sample_pair(path.sample, dimension + word(1u));
            real3 aimed = aimed_light(SCENE_ s, lobes, layered, point, scatter, frame, path.media, place, picks.y,
                                      -path.ray.direction, ends, asked, counts);
            radiance = radiance + select(asked, path.weight * aimed, black);
        }
    }
    mask goes_on = mask_and(found, mask_not(ends));
    path.alive = goes_on;
    if (!any_lane(goes_on)) return;
    real2 direction = sample_pair(path.sample, dimension);
    scatter_path(SCENE_ s, lobes, layered, point, crossing, scatter, frame, direction, picks.x, goes_on, path);
    path.vertices = path.vertices + word(1u);
    play_roulette(path);
}

/// A miss, for paths that have met nothing yet.
FN FirstHit nothing_met() {
    FirstHit first;
    first.t = real(3.0e38f);
    first.normal = real3(real(0.0f));
    first.albedo = real3(real(0.0f));
    first.geometry = word(NONE);
    first.primitive = word(NONE);
    first.material = word(NONE);
    return first;
}

KERNEL_END

#endif
