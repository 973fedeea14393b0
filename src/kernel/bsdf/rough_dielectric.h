// SPDX-License-Identifier: Apache-2.0
// Light that rough glass throws back and lets through (Walter et al., Microfacet Models for Refraction through Rough
// Surfaces, EGSR 2007), over GGX's facets. As with smooth glass, what passes is not scaled by the square of the
// indices' ratio: behind both surfaces of a body that would be 1 again.
#ifndef SUNDOG_KERNEL_BSDF_ROUGH_DIELECTRIC_H
#define SUNDOG_KERNEL_BSDF_ROUGH_DIELECTRIC_H

#include "kernel/bsdf/ggx.h"
#include "kernel/materials/reflection.h"

KERNEL_BEGIN

/// The facet that refracts one direction to the other, towards `to_eye`'s side; eta is the index of refraction on that
/// side over the one on `to_light`'s.
FN real3 refracting_facet(real3 to_eye, real3 to_light, real eta) {
    real3 h = to_eye * eta + to_light;
    real reach = sqrt(max(dot(h, h), real(1e-20f)));
    real side = select(h.z < real(0.0f), real(-1.0f), real(1.0f));
    return h * (side / reach);
}

/// Change of solid angle from facets to the directions that they refract to.
FN real refraction_spread(real3 to_eye, real3 to_light, real3 h, real eta) {
    real light_half = dot(to_light, h);
    real sum = eta * dot(to_eye, h) + light_half;
    return abs(light_half) / max(sum * sum, real(1e-12f));
}

/// True where h can refract one to the other: they are on its two sides as on the surface's.
FN mask refracts_between(real3 to_eye, real3 to_light, real3 h) {
    return mask_and(to_light.z < real(0.0f), mask_and(dot(to_eye, h) > real(0.0f), dot(to_light, h) < real(0.0f)));
}

/// BSDF of clear facets for light from behind, times (1 - Fresnel's reflectance at dot(to_eye, h)) that of glass.
FN real rough_refraction_value(real3 to_eye, real3 to_light, real3 h, real eta, real alpha_x, real alpha_y) {
    real3 flipped = real3(to_light.x, to_light.y, -to_light.z);
    real g2 = ggx_both_visible(to_eye, flipped, alpha_x, alpha_y);
    real value = ggx_distribution(h, alpha_x, alpha_y) * g2 * abs(dot(to_eye, h)) *
                 refraction_spread(to_eye, to_light, h, eta) / max(abs(to_eye.z * to_light.z), real(1e-6f));
    return select(refracts_between(to_eye, to_light, h), value, real(0.0f));
}

/// Density over solid angle of the direction that a drawn facet refracts `to_eye` to.
FN real rough_refraction_density(real3 to_eye, real3 to_light, real3 h, real eta, real alpha_x, real alpha_y) {
    real density = ggx_normal_density(to_eye, h, alpha_x, alpha_y) * refraction_spread(to_eye, to_light, h, eta);
    return select(refracts_between(to_eye, to_light, h), density, real(0.0f));
}

KERNEL_END

#endif
