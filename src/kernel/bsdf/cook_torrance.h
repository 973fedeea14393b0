// SPDX-License-Identifier: Apache-2.0
// Cook and Torrance's model (A Reflectance Model for Computer Graphics, TOG 1982): Beckmann's facets of root mean
// square slope m, which shadow each other as long V-shaped grooves do (Torrance and Sparrow 1967).
#ifndef SUNDOG_KERNEL_BSDF_COOK_TORRANCE_H
#define SUNDOG_KERNEL_BSDF_COOK_TORRANCE_H

#include "kernel/bsdf/beckmann.h"

KERNEL_BEGIN

/// Share of facets of normal h that are both lit and seen.
FN real groove_visible(real3 to_eye, real3 to_light, real3 h) {
    real eye_half = max(dot(to_eye, h), real(1e-6f));
    return min(real(1.0f), 2.0f * h.z * min(to_eye.z, to_light.z) / eye_half);
}

/// The BSDF of perfect mirrors as facets; times Fresnel's reflectance it is that of others. (The paper divides by pi
/// where 4 keeps energy: Walter et al. 2007, section 5.1.)
FN real cook_torrance_value(real3 to_eye, real3 to_light, real3 h, real m) {
    return beckmann_distribution(h, m, m) * groove_visible(to_eye, to_light, h) /
           max(4.0f * to_eye.z * to_light.z, real(1e-6f));
}

/// The direction that a facet, drawn among all of them, mirrors `to_eye` to; it may come to lie below the surface.
FN real3 cook_torrance_direction(real3 to_eye, real m, real2 u) {
    real tan_off = m * sqrt(max(log2_positive(max(1.0f - u.x, real(1e-7f))) * -0.693147181f, real(0.0f)));
    real angle = u.y * 6.28318531f;
    real3 h = real3(tan_off * cosine(angle), tan_off * sine(angle), real(1.0f));
    h = normalize(h);
    return h * (2.0f * dot(to_eye, h)) - to_eye;
}

FN real cook_torrance_density(real3 to_eye, real3 h, real m) {
    return beckmann_distribution(h, m, m) * h.z / max(4.0f * dot(to_eye, h), real(1e-6f));
}

KERNEL_END

#endif
