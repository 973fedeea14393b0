// SPDX-License-Identifier: Apache-2.0
// Cloth's sheen: fibres that stand up (Estevez and Kulla, Production Friendly Microfacet Sheen BRDF, Sony Pictures
// Imageworks 2017), with the visibility of Neubelt and Pettineo (2013). `roughness` is squared, as glTF has it.
#ifndef SUNDOG_KERNEL_BSDF_SHEEN_H
#define SUNDOG_KERNEL_BSDF_SHEEN_H

#include "kernel/bsdf/lambert.h"

KERNEL_BEGIN

/// The BSDF of white sheen. Directions are drawn as Lambert's are.
FN real sheen_value(real3 to_eye, real3 to_light, real roughness) {
    real3 halfway = to_eye + to_light;
    real3 h = halfway * (1.0f / sqrt(max(dot(halfway, halfway), real(1e-20f))));
    real per_alpha = 1.0f / max(roughness * roughness, real(1e-3f));
    real sine_half = sqrt(clamp(1.0f - h.z * h.z, real(0.0f), real(1.0f)));
    real distribution = (2.0f + per_alpha) * power(sine_half, per_alpha) * 0.159154943f;
    real both = to_eye.z + to_light.z - to_eye.z * to_light.z;
    return distribution / max(4.0f * both, real(1e-6f));
}

KERNEL_END

#endif
