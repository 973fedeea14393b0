// SPDX-License-Identifier: Apache-2.0
// How much of a light reaches a point. The device defines trace_any and trace_closest first (see
// integrators/whitted.h).
#ifndef SUNDOG_KERNEL_LIGHTS_SHADOW_H
#define SUNDOG_KERNEL_LIGHTS_SHADOW_H

#include "kernel/atmosphere/fog.h"
#include "kernel/atmosphere/media_insides.h"
#include "kernel/lights/light.h"
#include "kernel/lights/photon_flags.h"
#include "kernel/materials/interior.h"
#include "kernel/materials/layers.h"
#include "kernel/patterns/noise.h"
#include "kernel/rays.h"
#ifdef KERNEL_MEDIA
#include "kernel/atmosphere/media.h"
#endif

KERNEL_BEGIN

/// Share of the light, per channel, that comes along a shadow ray: 0 behind anything opaque, 1 in the open; each
/// transparent surface in the way takes its part by its transmittance, which falls with the light's angle to its normal
/// where the material follows Fresnel. The ray goes straight: real caustics are not its business (Whitted 1980, section
/// 3). `insides` is what the ray starts inside of: media there and on the way dim the light; fog and the atmosphere's
/// media only that of lights with LIGHT_ATTENUATED among `light_flags`.
FN real3 shadow_transmittance(SCENE Ray ray, MediaInsides insides, uint light_flags, mask alive,
                              INOUT(RayCounts) counts) {
    word one = select(alive, word(1u), word(0u));
    counts.rays = counts.rays + one;
    counts.shadow_rays = counts.shadow_rays + one;
    bool attenuated = (light_flags & LIGHT_ATTENUATED) != 0u;
    bool in_fog = FEATURE(FEATURE_ATMOSPHERE) && FRAME.fog_count > 0u && attenuated;
    bool in_air = FEATURE(FEATURE_MEDIA) && FRAME.atmosphere != NONE && attenuated;
    if (!FEATURE(FEATURE_TRANSPARENT) && !in_fog && !in_air) {
        mask blocked = trace_any(SCENE_ ray, alive, word(RAY_SHADOW));
        return select(blocked, real3(real(0.0f)), real3(real(1.0f)));
    }
    real3 transmittance = real3(real(1.0f));
    for (uint surface = 0u; surface < MAX_SHADOW_SURFACES; surface = surface + 1u) {
        Hit hit = trace_closest(SCENE_ ray, alive, word(RAY_SHADOW), true);
        mask found = mask_and(alive, hit.geometry != word(NONE));
        real way = select(found, hit.t, ray.t_max);
        if (in_fog) {
            real3 dimmed = transmittance;
            fog_radiance(SCENE_ ray, way, dimmed);
            transmittance = select(mask_and(alive, mask_not(in_solid(insides))), dimmed, transmittance);
        }
        mask open = mask_and(alive, mask_not(found));
        alive = found;
        if (any_lane(alive)) {
            // Most of what stands in the way is opaque: that is told from the material alone.
            word flags = FIELD(materials, hit_material(SCENE_ hit, alive), flags);
            mask opaque = mask_and(alive, (flags & word(MATERIAL_TRANSPARENT)) == word(0u));
            if (FEATURE(FEATURE_PHOTONS)) {
                word photons = FIELD(geometries, valid_index(alive, hit.geometry), photons);
                opaque = mask_or(opaque, mask_and(alive, photons_replace_shadow(photons, light_flags)));
            }
            transmittance = select(opaque, real3(real(0.0f)), transmittance);
            alive = mask_and(alive, mask_not(opaque));
        }
        real3 clear = real3(real(1.0f));
#ifdef KERNEL_MEDIA
        if (FEATURE(FEATURE_MEDIA)) {
            // As in povray, what is in an object dims light where that leaves it: not the light of a lamp inside.
            mask passing = in_air ? mask_or(alive, open) : alive;
            if (any_lane(passing)) {
                MediaInsides crossed = solids_alone(insides);
                for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
                    crossed.entry[i] = select(open, crossed.entry[i], insides.entry[i]);
                clear = media_transmittance(SCENE_ ray, way, crossed, attenuated, passing);
                transmittance = select(open, transmittance * clear, transmittance);
            }
        }
#endif
        if (!any_lane(alive)) return transmittance;
        Surface s = surface_at(SCENE_ ray, hit, alive);
        Lobes lobes = evaluate_material(SCENE_ s, ray.direction);
        real3 passes = lobes.transmittance;
        if (FEATURE(FEATURE_PATTERNED)) {
            LayerColors layered;
            evaluate_layers(SCENE_ s, ray.direction, alive, mask(false), true, lobes, layered);
            word interior = interior_of(SCENE_ s, lobes.patterned);
            passes =
                lobes.transmittance * interior_transmittance(SCENE_ select(s.from_behind, interior, word(0u)), hit.t);
            if (FEATURE(FEATURE_CAUSTICS)) {
                // As povray's pictures show: twice as much where light meets the surface head-on.
                real exponent = FIELD(interiors, interior, caustics);
                real cosine = abs(dot(layered.mirror, ray.direction));
                passes = passes * select(exponent > real(0.0f), 1.0f + power(cosine, exponent), real(1.0f));
            }
        }
        if (FEATURE(FEATURE_MEDIA)) passes = passes * clear;
        transmittance = select(alive, transmittance * passes, transmittance);
        alive = mask_and(alive, largest(transmittance) > real(0.0f));
        if (!any_lane(alive)) return transmittance;
        if (FEATURE(FEATURE_HOLLOW)) insides = media_beyond(SCENE_ s, insides, alive);
        // On from the far side of that surface; a lamp's distance shrinks by what was passed.
        ray.origin = s.position - s.geometric_normal * s.error;
        ray.t_max = ray.t_max - hit.t;
        alive = mask_and(alive, ray.t_max > real(0.0f));
    }
    return select(alive, real3(real(0.0f)), transmittance);
}

/// The same for a ray to one of a light's points: where the light is projected through an object, it comes from where
/// the ray first meets that, and from nowhere else.
FN real3 ray_transmittance(SCENE Light light, Ray shadow, MediaInsides insides, mask open, INOUT(RayCounts) counts) {
    mask through = open;
    // In scenes without hidden objects no light is projected through any.
    if (FEATURE(FEATURE_HIDDEN)) {
        if (light.projection != 0u) {
            counts.rays = counts.rays + select(open, word(1u), word(0u));
            Hit window = trace_closest(SCENE_ shadow, open, word(light.projection), false);
            through = mask_and(open, window.geometry != word(NONE));
            if (!any_lane(through)) return real3(real(0.0f));
            // Short of it by rounding: the same object may be drawn there, too.
            real there = window.t - hit_error(shadow.origin, point_at(shadow, window.t), window.t);
            shadow.t_max = min(shadow.t_max, there);
        }
    }
    real3 passes = shadow_transmittance(SCENE_ shadow, insides, light.flags, through, counts);
    return select(through, passes, real3(real(0.0f)));
}

/// Share of a light that reaches the lanes of `lit`, whose shadow ray starts at `origin`: of one point, or the mean
/// over an area's (see area_share). An area with probes asks those first, spread over it from corner to corner; lanes
/// in which all of them give the same are done. `insides` is what `origin` is inside of.
FN real3 light_visibility(SCENE Light light, real3 origin, real3 to_light, real distance, MediaInsides insides,
                          mask lit, INOUT(RayCounts) counts) {
    Ray shadow;
    shadow.origin = origin;
    shadow.direction = to_light;
    shadow.t_min = real(0.0f);
    // Short of the light by both ends' rounding: a light may lie in a surface.
    shadow.t_max = distance;
    if (light.kind == LIGHT_LAMP || light.kind == LIGHT_SPOT) {
        // From where the ray starts, which is a little off the lit point: else it would end beside the light.
        real3 to_place = real3(light.place) - origin;
        real reach = length(to_place);
        shadow.t_max = reach - hit_error(origin, real3(light.place), reach);
        shadow.direction = to_place * (1.0f / max(reach, real(1e-30f)));
    } else if (light.kind != LIGHT_SUN) {
        shadow.t_max = distance - hit_error(origin, real3(light.place), distance);
    }
    bool is_area = light.area_count_u * light.area_count_v > 1u;
    bool probing = light.area_probes > 1u && light.area_probes < max(light.area_count_u, light.area_count_v);
    uint steps_u = probing ? min(light.area_probes, light.area_count_u) : light.area_count_u;
    uint steps_v = probing ? min(light.area_probes, light.area_count_v) : light.area_count_v;
    real3 result = real3(real(0.0f));
    mask open = lit;
    while (true) {
        real3 sum = real3(real(0.0f));
        real3 least = real3(real(1.0e30f));
        real3 most = real3(real(-1.0e30f));
        for (uint i = 0u; i < steps_u * steps_v; i = i + 1u) {
            if (is_area) {
                real s = real(place_in_row(i % steps_u, steps_u));
                real t = real(place_in_row(i / steps_u, steps_v));
                if ((light.flags & LIGHT_JITTER) != 0u) {
                    // At most half the way to its neighbours.
                    s = s + (random_at(origin, word(2u * i)) - 0.5f) * row_step(light.area_count_u);
                    t = t + (random_at(origin, word(2u * i + 1u)) - 0.5f) * row_step(light.area_count_v);
                }
                real3 place = area_light_place(light, s, t, to_light);
                if (light.kind == LIGHT_SUN) {
                    shadow.direction = normalize(place);
                } else {
                    real3 to_place = place - origin;
                    real reach = length(to_place);
                    shadow.t_max = reach - hit_error(origin, place, reach);
                    shadow.direction = to_place * (1.0f / max(reach, real(1e-30f)));
                }
            }
            real3 share = ray_transmittance(SCENE_ light, shadow, insides, open, counts);
            float part = area_share(i % steps_u, steps_u) * area_share(i / steps_u, steps_v);
            sum = sum + share * real(part);
            least = min(least, share);
            most = max(most, share);
        }
        if (!probing) return select(open, sum, result);
        real3 spread = most - least;
        mask agree = largest(spread) < real(0.004f);
        result = select(mask_and(open, agree), sum, result);
        open = mask_and(open, mask_not(agree));
        if (!any_lane(open)) return result;
        probing = false;
        steps_u = light.area_count_u;
        steps_v = light.area_count_v;
    }
    return result;
}

KERNEL_END

#endif
