// SPDX-License-Identifier: Apache-2.0
// How much of a light reaches a point. The device defines trace_any and trace_closest first (see
// integrators/whitted.h).
#ifndef SUNDOG_KERNEL_LIGHTS_SHADOW_H
#define SUNDOG_KERNEL_LIGHTS_SHADOW_H

#include "kernel/materials/material.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// Share of the light, per channel, that comes along a shadow ray: 0 behind anything opaque, 1 in the open; each
/// transparent surface in the way takes its part by its transmittance, which falls with the light's angle to its normal
/// where the material follows Fresnel. The ray goes straight: caustics are not its business (Whitted 1980, section 3).
FN real3 shadow_transmittance(SCENE Ray ray, mask alive, INOUT(RayCounts) counts) {
    word one = select(alive, word(1u), word(0u));
    counts.rays = counts.rays + one;
    counts.shadow_rays = counts.shadow_rays + one;
    if (!FEATURE(FEATURE_TRANSPARENT)) {
        mask blocked = trace_any(SCENE_ ray, alive);
        return select(blocked, real3(real(0.0f)), real3(real(1.0f)));
    }
    real3 transmittance = real3(real(1.0f));
    for (uint surface = 0u; surface < MAX_SHADOW_SURFACES; surface = surface + 1u) {
        Hit hit = trace_closest(SCENE_ ray, alive, true);
        alive = mask_and(alive, hit.geometry != word(NONE));
        if (!any_lane(alive)) return transmittance;
        // Most of what stands in the way is opaque: that is told from the material alone.
        word flags = FIELD(materials, hit_material(SCENE_ hit, alive), flags);
        mask opaque = mask_and(alive, (flags & word(MATERIAL_TRANSPARENT)) == word(0u));
        transmittance = select(opaque, real3(real(0.0f)), transmittance);
        alive = mask_and(alive, mask_not(opaque));
        if (!any_lane(alive)) return transmittance;
        Surface s = surface_at(SCENE_ ray, hit, alive);
        Lobes lobes = evaluate_material(SCENE_ s, ray.direction);
        transmittance = select(alive, transmittance * lobes.transmittance, transmittance);
        alive = mask_and(alive, max(transmittance.x, max(transmittance.y, transmittance.z)) > real(0.0f));
        if (!any_lane(alive)) return transmittance;
        // On from the far side of that surface; a lamp's distance shrinks by what was passed.
        ray.origin = s.position - s.geometric_normal * s.error;
        ray.t_max = ray.t_max - hit.t;
        alive = mask_and(alive, ray.t_max > real(0.0f));
    }
    return select(alive, real3(real(0.0f)), transmittance);
}

KERNEL_END

#endif
