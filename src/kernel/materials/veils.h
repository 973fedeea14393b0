// SPDX-License-Identifier: Apache-2.0
// Surfaces that light passes without being bent.
#ifndef SUNDOG_KERNEL_MATERIALS_VEILS_H
#define SUNDOG_KERNEL_MATERIALS_VEILS_H

#include "kernel/materials/bsdf_material.h"
#include "kernel/materials/interior.h"
#include "kernel/materials/material.h"

KERNEL_BEGIN

/// Lanes of `alive` whose lobes don't bend what passes. Both ways in which paths find light, by aiming and by meeting
/// it, go by this; what a reflection model's opacity lets pass is never bent.
FN mask is_unbent(SCENE Surface s, Lobes lobes, mask alive) {
    mask straight = mask_and(alive, abs(lobes.eta - 1.0f) <= real(0.0f));
    if (FEATURE(FEATURE_PATTERNED)) {
        mask layered = mask_and(alive, lobes.patterned);
        if (any_lane(layered)) {
            mask unbent = abs(FIELD(interiors, interior_of(SCENE_ s, layered), ior) - 1.0f) <= real(0.0f);
            straight = mask_and(straight, mask_or(mask_not(layered), unbent));
        }
    }
    // A body's surface may be straight for some that come to it, and isn't for others.
    if (FEATURE(FEATURE_BODIES)) straight = mask_and(straight, FIELD(materials, s.material, interior) == word(0u));
    return straight;
}

/// Lanes of `alive` in which light passes a surface without being bent, and what passes.
FN mask passes_straight(SCENE Surface s, Lobes lobes, mask alive, OUT(real3) passes) {
    passes = lobes.transmittance;
    mask straight = is_unbent(SCENE_ s, lobes, alive);
    if (FEATURE(FEATURE_BSDF)) {
        word model = FIELD(materials, s.material, bsdf);
        mask own = mask_and(alive, model != word(NONE));
        if (any_lane(own)) {
            real opacity = bsdf_opacity(SCENE_ s, valid_index(own, model), own);
            passes = select(own, real3(1.0f - opacity), passes);
            straight = mask_or(straight, own);
        }
    }
    return mask_and(straight, largest(passes) > real(0.0f));
}

KERNEL_END

#endif
