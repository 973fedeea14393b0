// SPDX-License-Identifier: Apache-2.0
// A rough matt surface: grooves of matt facets whose slopes vary by sigma radians (Oren and Nayar, Generalization of
// Lambert's Reflectance Model, SIGGRAPH 1994, the qualitative model). Directions are drawn as Lambert's are.
#ifndef SUNDOG_KERNEL_BSDF_OREN_NAYAR_H
#define SUNDOG_KERNEL_BSDF_OREN_NAYAR_H

#include "kernel/bsdf/lambert.h"

KERNEL_BEGIN

/// The BSDF of a white one.
FN real oren_nayar_value(real3 to_eye, real3 to_light, real sigma) {
    real sigma2 = sigma * sigma;
    real a = 1.0f - 0.5f * sigma2 / (sigma2 + 0.33f);
    real b = 0.45f * sigma2 / (sigma2 + 0.09f);
    // cos(phi difference) sin(alpha) tan(beta), where alpha is the larger and beta the smaller angle to the normal.
    real across = to_eye.x * to_light.x + to_eye.y * to_light.y;
    real larger_cosine = max(max(to_eye.z, to_light.z), real(1e-4f));
    return (a + b * max(across, real(0.0f)) / larger_cosine) * lambert_value();
}

KERNEL_END

#endif
