// SPDX-License-Identifier: Apache-2.0
// What a ray meets, as all integrators see it.
#ifndef SUNDOG_KERNEL_INTEGRATORS_SURFACE_MET_H
#define SUNDOG_KERNEL_INTEGRATORS_SURFACE_MET_H

#include "kernel/materials/body.h"
#include "kernel/materials/bump.h"
#include "kernel/materials/interior.h"
#include "kernel/materials/layers.h"
#include "kernel/materials/material.h"

KERNEL_BEGIN

/// The surface of a hit in the lanes of `found`, its lobes, layers and what is behind it; its normal is that by which
/// light is mirrored and refracted. The answer is what the interiors that the ray came through let pass. `spectrum` is
/// the ray's place there, 0.5 for all colours.
FN real3 surface_met(SCENE Ray ray, Hit hit, Insides insides, real spectrum, mask found, OUT(Surface) s,
                     OUT(Lobes) lobes, OUT(LayerColors) layered, OUT(Crossing) crossing, OUT(real3) smooth_normal) {
    real3 passes = real3(real(1.0f));
    s = surface_at(SCENE_ ray, hit, found);
    if (FEATURE(FEATURE_BUMP)) s.normal = bumped_normal(SCENE_ s);
    if (FEATURE(FEATURE_BODIES)) {
        word body = body_of(SCENE_ s, found);
        crossing = body_crossing(s, body, insides);
        lobes = evaluate_material_between(SCENE_ s, ray.direction, body_eta(SCENE_ crossing, body, insides));
    } else {
        lobes = evaluate_material(SCENE_ s, ray.direction);
    }
    smooth_normal = s.normal;
    if (FEATURE(FEATURE_PATTERNED)) {
        word interior = interior_of(SCENE_ s, lobes.patterned);
        crossing = crossing_at(interior, insides);
        if (FEATURE(FEATURE_TRANSPARENT)) passes = select(found, inside_transmittance(SCENE_ insides, hit.t), passes);
        real eta = crossing_eta(SCENE_ crossing, interior, insides, spectrum);
        lobes.eta = select(lobes.patterned, eta, lobes.eta);
        evaluate_layers(SCENE_ s, ray.direction, found, is_enclosed(crossing), false, lobes, layered);
        if (FEATURE(FEATURE_NORMALS)) s.normal = layered.mirror;
    }
    return passes;
}

/// Which lanes of `transmits` pass into or out of what disperses light.
FN mask disperses(SCENE Surface s, Lobes lobes, mask transmits) {
    word interior = interior_of(SCENE_ s, mask_and(transmits, lobes.patterned));
    return mask_and(transmits, abs(FIELD(interiors, interior, dispersion) - 1.0f) > real(0.0f));
}

KERNEL_END

#endif
