// SPDX-License-Identifier: Apache-2.0
// Light that paths aim at. The device defines its traversal first (see whitted.h).
#ifndef SUNDOG_KERNEL_INTEGRATORS_AIMED_LIGHT_H
#define SUNDOG_KERNEL_INTEGRATORS_AIMED_LIGHT_H

#include "kernel/integrators/scatter.h"
#include "kernel/lights/emitter.h"
#include "kernel/lights/emitter_shadow.h"

KERNEL_BEGIN

/// Light of the lights without size, in lanes that drew one of them (an area: any point of it), over its probability.
FN real3 light_from_points(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, LARGE(BsdfPoint) point,
                           Scatter scatter, ShadingFrame basis, MediaInsides media, EmitterChoice choice, real2 u,
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
        if (FEATURE(FEATURE_MEDIA) && (light.flags & LIGHT_PASSES_MEDIA) != 0u)
            lit = mask_and(lit, mask_not(scatter.particle));
        real3 amount = abs(color);
        lit = mask_and(lit, largest(amount) > real(0.0f));
        if (!any_lane(lit)) continue;
        real met;
        real3 value =
            color * scattered_light(SCENE_ s, lobes, layered, point, scatter, basis, lit, behind, from, to_eye, met);
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
                           Scatter scatter, ShadingFrame basis, MediaInsides media, real2 u, real pick, real3 to_eye,
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
    if (any_lane(on_triangle)) take_sample(on_triangle, sample_triangle(SCENE_ choice, from, u, on_triangle), drawn);
    if (FEATURE(FEATURE_ANALYTIC)) {
        mask on_sphere = mask_and(asked, choice.kind == word(EMITTER_SPHERE));
        if (any_lane(on_sphere)) take_sample(on_sphere, sample_sphere(SCENE_ choice, from, u, on_sphere), drawn);
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
            scattered_light(SCENE_ s, lobes, layered, point, scatter, basis, lit, behind, drawn.to_light, to_eye, met);
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
            real3 passes = emitter_visibility(SCENE_ shadow, media, lit, counts);
            sum = select(lit, value * passes, black);
        }
    }
    if (FRAME.light_count > 0u) {
        mask at_point = mask_and(asked, choice.kind == word(EMITTER_LIGHT));
        if (any_lane(at_point))
            sum = sum + light_from_points(SCENE_ s, lobes, layered, point, scatter, basis, media, choice, u, to_eye,
                                          at_point, counts);
    }
    return sum;
}

KERNEL_END

#endif
