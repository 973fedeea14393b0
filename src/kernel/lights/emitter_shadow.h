// SPDX-License-Identifier: Apache-2.0
// How much of what paths aim at reaches a point. The device defines trace_any and trace_closest first (see
// integrators/whitted.h).
#ifndef SUNDOG_KERNEL_LIGHTS_EMITTER_SHADOW_H
#define SUNDOG_KERNEL_LIGHTS_EMITTER_SHADOW_H

#include "kernel/lights/shadow.h"
#include "kernel/materials/veils.h"

KERNEL_BEGIN

/// Share of light, per channel, that comes straight along a shadow ray to something that paths aim at. What bends light
/// stands in its way: paths that pass it meet the light for themselves. `insides` is what the ray starts inside of.
FN_LARGE real3 emitter_visibility(SCENE Ray ray, MediaInsides insides, mask alive, INOUT(RayCounts) counts) {
    word one = select(alive, word(1u), word(0u));
    counts.rays = counts.rays + one;
    counts.shadow_rays = counts.shadow_rays + one;
    real3 black = real3(real(0.0f));
    bool in_fog = FEATURE(FEATURE_ATMOSPHERE) && FRAME.fog_count > 0u;
    if (!FEATURE(FEATURE_VEILS) && !in_fog && !FEATURE(FEATURE_MEDIA)) {
        mask blocked = trace_any(SCENE_ ray, alive, word(RAY_SHADOW));
        return select(blocked, black, real3(real(1.0f)));
    }
    real3 transmittance = select(alive, real3(real(1.0f)), black);
    for (uint surface = 0u; surface < MAX_SHADOW_SURFACES; surface = surface + 1u) {
        real way = ray.t_max;
        Hit hit;
        mask found = mask_and(alive, mask_not(alive));
        if (FEATURE(FEATURE_VEILS)) {
            hit = trace_closest(SCENE_ ray, alive, word(RAY_SHADOW), true);
            found = mask_and(alive, hit.geometry != word(NONE));
            way = select(found, hit.t, way);
        } else {
            mask blocked = trace_any(SCENE_ ray, alive, word(RAY_SHADOW));
            transmittance = select(mask_and(alive, blocked), black, transmittance);
            alive = mask_and(alive, mask_not(blocked));
        }
        Surface s;
        Lobes lobes;
        real3 passes = real3(real(1.0f));
        if (FEATURE(FEATURE_VEILS)) {
            word flags = FIELD(materials, hit_material(SCENE_ hit, found), flags);
            mask opaque = mask_and(found, (flags & word(MATERIAL_TRANSPARENT)) == word(0u));
            transmittance = select(opaque, black, transmittance);
            alive = mask_and(alive, mask_not(opaque));
            found = mask_and(found, alive);
            if (any_lane(found)) {
                s = surface_at(SCENE_ ray, hit, found);
                lobes = evaluate_material(SCENE_ s, ray.direction);
                if (FEATURE(FEATURE_PATTERNED)) {
                    LayerColors layered;
                    evaluate_layers(SCENE_ s, ray.direction, found, mask(false), true, lobes, layered);
                }
                mask straight = passes_straight(SCENE_ s, lobes, found, passes);
                if (FEATURE(FEATURE_PATTERNED)) {
                    word interior = interior_of(SCENE_ s, lobes.patterned);
                    passes = passes * interior_transmittance(SCENE_ select(s.from_behind, interior, word(0u)), hit.t);
                }
                transmittance = select(found, select(straight, transmittance * passes, black), transmittance);
                found = mask_and(found, straight);
            }
        }
        alive = mask_and(alive, largest(transmittance) > real(0.0f));
        if (in_fog && any_lane(alive)) {
            real3 dimmed = transmittance;
            fog_radiance(SCENE_ ray, way, dimmed);
            mask in_air = FEATURE(FEATURE_HOLLOW) ? mask_and(alive, mask_not(in_solid(insides))) : alive;
            transmittance = select(in_air, dimmed, transmittance);
        }
#ifdef KERNEL_MEDIA
        if (FEATURE(FEATURE_MEDIA) && any_lane(alive)) {
            real3 dimmed = media_transmittance(SCENE_ ray, way, insides, true, alive);
            transmittance = select(alive, transmittance * dimmed, transmittance);
        }
#endif
        alive = mask_and(alive, found);
        if (!FEATURE(FEATURE_VEILS) || !any_lane(alive)) return transmittance;
        if (FEATURE(FEATURE_HOLLOW)) insides = media_beyond(SCENE_ s, insides, alive);
        // On along the very same line, for it ends short of what shines by no more than rounding.
        real facing = abs(dot(s.geometric_normal, ray.direction));
        real behind = hit.t + 2.0f * s.error / max(facing, real(1e-3f));
        ray.origin = select(alive, point_at(ray, behind), ray.origin);
        ray.t_max = ray.t_max - select(alive, behind, real(0.0f));
        alive = mask_and(alive, ray.t_max > real(0.0f));
    }
    return select(alive, black, transmittance);
}

KERNEL_END

#endif
