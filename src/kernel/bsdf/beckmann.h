// SPDX-License-Identifier: Apache-2.0
// Microfacets with slopes of a normal distribution (Beckmann and Spizzichino 1963; Cook and Torrance 1982), with
// Smith's shadowing (Walter et al. 2007). The roughnesses along x and y are alpha_x and alpha_y.
#ifndef SUNDOG_KERNEL_BSDF_BECKMANN_H
#define SUNDOG_KERNEL_BSDF_BECKMANN_H

#include "kernel/bsdf/frame.h"

KERNEL_BEGIN

/// The error function (Abramowitz and Stegun, 7.1.26); error under 2e-7.
FN real error_function(real x) {
    real z = abs(x);
    real t = 1.0f / (1.0f + 0.3275911f * z);
    real series = t * (0.254829592f + t * (t * (1.421413741f + t * (t * 1.061405429f - 1.453152027f)) - 0.284496736f));
    real value = 1.0f - series * exp2_clamped(z * z * -1.44269504f);
    return select(x < real(0.0f), -value, value);
}

/// Its inverse, for x in (-1, 1) (Winitzki's approximation of 2008, made exact by two steps of Newton's method).
FN real inverse_error_function(real x) {
    real logarithm = log2_positive(max(1.0f - x * x, real(1e-12f))) * 0.693147181f;
    real half_sum = 4.33074675f + logarithm * 0.5f;
    real z = sqrt(max(sqrt(max(half_sum * half_sum - logarithm * 6.80272109f, real(0.0f))) - half_sum, real(0.0f)));
    z = select(x < real(0.0f), -z, z);
    for (uint i = 0u; i < 2u; i = i + 1u)
        z = z - (error_function(z) - x) * 0.886226925f * exp2_clamped(min(z * z, real(16.0f)) * 1.44269504f);
    return z;
}

FN real beckmann_distribution(real3 h, real alpha_x, real alpha_y) {
    real z2 = max(h.z * h.z, real(1e-8f));
    real x = h.x / alpha_x;
    real y = h.y / alpha_y;
    return exp2_clamped((x * x + y * y) / z2 * -1.44269504f) * 0.318309886f / (alpha_x * alpha_y * z2 * z2);
}

FN real beckmann_lambda(real3 w, real alpha_x, real alpha_y) {
    real x = w.x * alpha_x;
    real y = w.y * alpha_y;
    real a = abs(w.z) / sqrt(max(x * x + y * y, real(1e-12f)));
    // Without the difference of two nearly equal numbers where a is large: there it is 0 to single precision.
    real near = (error_function(a) - 1.0f) * 0.5f + exp2_clamped(a * a * -1.44269504f) * 0.282094792f / a;
    return select(a < real(3.5f), max(near, real(0.0f)), real(0.0f));
}

FN real beckmann_visible(real3 w, real alpha_x, real alpha_y) {
    return 1.0f / (1.0f + beckmann_lambda(w, alpha_x, alpha_y));
}

FN real beckmann_both_visible(real3 v, real3 w, real alpha_x, real alpha_y) {
    return 1.0f / (1.0f + beckmann_lambda(v, alpha_x, alpha_y) + beckmann_lambda(w, alpha_x, alpha_y));
}

/// A facet's normal, drawn among those that are seen from `to_eye` (Heitz and d'Eon, Importance Sampling
/// Microfacet-Based BSDFs using the Distribution of Visible Normals, EGSR 2014): slopes of the surface that is
/// stretched to roughness 1, of which those along the view are drawn by inverting their distribution.
FN real3 beckmann_normal(real3 to_eye, real alpha_x, real alpha_y, real2 u) {
    real3 v = real3(to_eye.x * alpha_x, to_eye.y * alpha_y, max(to_eye.z, real(1e-4f)));
    v = normalize(v);
    real sin_eye = sqrt(max(v.x * v.x + v.y * v.y, real(1e-12f)));
    real cot_eye = v.z / sin_eye;
    // Share of the projected area of all facets whose slope is under x:
    //   (cos (1 + erf x) + sin exp(-x^2) / sqrt(pi)) / (the same at the cotangent, from where on they face away).
    real reach = min(cot_eye, real(5.0f));
    real whole =
        v.z * (1.0f + error_function(reach)) + sin_eye * exp2_clamped(reach * reach * -1.44269504f) * 0.564189584f;
    real low = real(-5.0f);
    real high = reach;
    real wanted = u.x * whole;
    for (uint i = 0u; i < 22u; i = i + 1u) {
        real middle = (low + high) * 0.5f;
        real share = v.z * (1.0f + error_function(middle)) +
                     sin_eye * exp2_clamped(middle * middle * -1.44269504f) * 0.564189584f;
        mask beyond = share < wanted;
        low = select(beyond, middle, low);
        high = select(beyond, high, middle);
    }
    real along = (low + high) * 0.5f;
    real across = inverse_error_function(clamp(2.0f * u.y - 1.0f, real(-0.999999f), real(0.999999f)));
    // Turned to where the eye is, and back to the surface as it was.
    real c = v.x / sin_eye;
    real s = v.y / sin_eye;
    real3 h = real3(-(c * along - s * across) * alpha_x, -(s * along + c * across) * alpha_y, real(1.0f));
    return normalize(h);
}

FN real beckmann_normal_density(real3 to_eye, real3 h, real alpha_x, real alpha_y) {
    return beckmann_visible(to_eye, alpha_x, alpha_y) * max(dot(to_eye, h), real(0.0f)) *
           beckmann_distribution(h, alpha_x, alpha_y) / max(to_eye.z, real(1e-6f));
}

FN real beckmann_value(real3 to_eye, real3 to_light, real3 h, real alpha_x, real alpha_y) {
    return beckmann_distribution(h, alpha_x, alpha_y) * beckmann_both_visible(to_eye, to_light, alpha_x, alpha_y) /
           max(4.0f * to_eye.z * to_light.z, real(1e-6f));
}

FN real beckmann_density(real3 to_eye, real3 h, real alpha_x, real alpha_y) {
    return beckmann_visible(to_eye, alpha_x, alpha_y) * beckmann_distribution(h, alpha_x, alpha_y) /
           max(4.0f * to_eye.z, real(1e-6f));
}

KERNEL_END

#endif
