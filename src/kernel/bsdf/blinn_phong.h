// SPDX-License-Identifier: Apache-2.0
// Highlights by a power of the halfway vector's cosine (Blinn, Models of Light Reflection for Computer Synthesized
// Pictures, SIGGRAPH 1977).
#ifndef SUNDOG_KERNEL_BSDF_BLINN_PHONG_H
#define SUNDOG_KERNEL_BSDF_BLINN_PHONG_H

#include "kernel/bsdf/frame.h"

KERNEL_BEGIN

/// As a BSDF that sends back all light that comes along the normal (Giesen, Phong Normalization Factor derivation,
/// 2009), and less of other light.
FN real blinn_phong_value(real3 to_eye, real3 to_light, real exponent) {
    real3 halfway = to_eye + to_light;
    real reach = sqrt(max(dot(halfway, halfway), real(1e-20f)));
    real whole = (exponent + 2.0f) * (exponent + 4.0f) * 0.0397887358f / (exp2_clamped(exponent * -0.5f) + exponent);
    return whole * power(max(halfway.z, real(0.0f)) / reach, exponent);
}

/// The direction that a halfway vector mirrors `to_eye` to, all local; vectors may come to lie below the surface.
FN real3 blinn_phong_direction(real3 to_eye, real exponent, real2 u) {
    real cos_half = power(u.x, 1.0f / (exponent + 1.0f));
    real sin_half = sqrt(max(1.0f - cos_half * cos_half, real(0.0f)));
    real angle = u.y * 6.28318531f;
    real3 halfway = real3(sin_half * cosine(angle), sin_half * sine(angle), cos_half);
    return halfway * (2.0f * dot(to_eye, halfway)) - to_eye;
}

/// Its density over solid angle.
FN real blinn_phong_density(real3 to_eye, real3 to_light, real exponent) {
    real3 halfway = to_eye + to_light;
    real reach = sqrt(max(dot(halfway, halfway), real(1e-20f)));
    real cos_half = max(halfway.z, real(0.0f)) / reach;
    real eye_half = max(dot(to_eye, halfway), real(0.0f)) / reach;
    real density = (exponent + 1.0f) * 0.159154943f * power(cos_half, exponent);
    return density / max(4.0f * eye_half, real(1e-6f));
}

KERNEL_END

#endif
