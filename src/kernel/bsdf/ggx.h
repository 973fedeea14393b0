// SPDX-License-Identifier: Apache-2.0
// Microfacets whose slopes are distributed as Trowbridge and Reitz have it (1975; "GGX" of Walter et al., Microfacet
// Models for Refraction through Rough Surfaces, EGSR 2007), with Smith's shadowing, height-correlated (Heitz,
// Understanding the Masking-Shadowing Function, JCGT 2014). The roughnesses along x and y are alpha_x and alpha_y.
#ifndef SUNDOG_KERNEL_BSDF_GGX_H
#define SUNDOG_KERNEL_BSDF_GGX_H

#include "kernel/bsdf/frame.h"

KERNEL_BEGIN

/// Area of facets with the unit normal h, of each area of the surface, over solid angle.
FN real ggx_distribution(real3 h, real alpha_x, real alpha_y) {
    real x = h.x / alpha_x;
    real y = h.y / alpha_y;
    real sum = x * x + y * y + h.z * h.z;
    return 0.318309886f / max(alpha_x * alpha_y * sum * sum, real(1e-30f));
}

/// Smith's auxiliary function of a direction.
FN real ggx_lambda(real3 w, real alpha_x, real alpha_y) {
    real x = w.x * alpha_x;
    real y = w.y * alpha_y;
    real tan2 = (x * x + y * y) / max(w.z * w.z, real(1e-12f));
    return (sqrt(1.0f + tan2) - 1.0f) * 0.5f;
}

/// Share of facets that is seen from a direction,
FN real ggx_visible(real3 w, real alpha_x, real alpha_y) { return 1.0f / (1.0f + ggx_lambda(w, alpha_x, alpha_y)); }

/// and from two on the same side.
FN real ggx_both_visible(real3 v, real3 w, real alpha_x, real alpha_y) {
    return 1.0f / (1.0f + ggx_lambda(v, alpha_x, alpha_y) + ggx_lambda(w, alpha_x, alpha_y));
}

/// A facet's normal, drawn among those that are seen from `to_eye` (Dupuy and Benyoub, Sampling Visible GGX Normals
/// with Spherical Caps, HPG 2023).
FN real3 ggx_normal(real3 to_eye, real alpha_x, real alpha_y, real2 u) {
    real3 stretched = real3(to_eye.x * alpha_x, to_eye.y * alpha_y, to_eye.z);
    stretched = normalize(stretched);
    real angle = u.x * 6.28318531f;
    real z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
    real sine_off = sqrt(clamp(1.0f - z * z, real(0.0f), real(1.0f)));
    real3 h = real3(sine_off * cosine(angle), sine_off * sine(angle), z) + stretched;
    h = real3(h.x * alpha_x, h.y * alpha_y, max(h.z, real(1e-6f)));
    return normalize(h);
}

/// Its density over solid angle.
FN real ggx_normal_density(real3 to_eye, real3 h, real alpha_x, real alpha_y) {
    return ggx_visible(to_eye, alpha_x, alpha_y) * max(dot(to_eye, h), real(0.0f)) *
           ggx_distribution(h, alpha_x, alpha_y) / max(to_eye.z, real(1e-6f));
}

/// The BSDF of perfect mirrors as facets; times Fresnel's reflectance at dot(to_eye, h) it is that of others.
FN real ggx_value(real3 to_eye, real3 to_light, real3 h, real alpha_x, real alpha_y) {
    return ggx_distribution(h, alpha_x, alpha_y) * ggx_both_visible(to_eye, to_light, alpha_x, alpha_y) /
           max(4.0f * to_eye.z * to_light.z, real(1e-6f));
}

/// Density over solid angle of the direction that a drawn facet mirrors `to_eye` to; h is halfway.
FN real ggx_density(real3 to_eye, real3 h, real alpha_x, real alpha_y) {
    return ggx_visible(to_eye, alpha_x, alpha_y) * ggx_distribution(h, alpha_x, alpha_y) /
           max(4.0f * to_eye.z, real(1e-6f));
}

KERNEL_END

#endif
