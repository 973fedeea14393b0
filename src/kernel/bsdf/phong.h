// SPDX-License-Identifier: Apache-2.0
// Phong's highlight (Illumination for Computer Generated Pictures, CACM 1975) as a BSDF that keeps its energy
// (Lafortune and Willems, Using the Modified Phong Reflectance Model, 1994).
#ifndef SUNDOG_KERNEL_BSDF_PHONG_H
#define SUNDOG_KERNEL_BSDF_PHONG_H

#include "kernel/bsdf/frame.h"

KERNEL_BEGIN

/// The cosine between the mirrored direction to the eye and that to the light.
FN real phong_cosine(real3 to_eye, real3 to_light) {
    real3 mirrored = real3(-to_eye.x, -to_eye.y, to_eye.z);
    return max(dot(mirrored, to_light), real(0.0f));
}

FN real phong_value(real3 to_eye, real3 to_light, real exponent) {
    return (exponent + 2.0f) * 0.159154943f * power(phong_cosine(to_eye, to_light), exponent);
}

/// A direction around the mirrored one; it may come to lie below the surface.
FN real3 phong_direction(real3 to_eye, real exponent, real2 u) {
    real cos_off = power(u.x, 1.0f / (exponent + 1.0f));
    real sin_off = sqrt(max(1.0f - cos_off * cos_off, real(0.0f)));
    real angle = u.y * 6.28318531f;
    ShadingFrame around = frame_around(real3(-to_eye.x, -to_eye.y, to_eye.z));
    return to_world(around, real3(sin_off * cosine(angle), sin_off * sine(angle), cos_off));
}

FN real phong_density(real3 to_eye, real3 to_light, real exponent) {
    return (exponent + 1.0f) * 0.159154943f * power(phong_cosine(to_eye, to_light), exponent);
}

KERNEL_END

#endif
