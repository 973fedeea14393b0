// SPDX-License-Identifier: Apache-2.0
// Fresnel's equations for metals (for dielectrics see kernel/materials/reflection.h).
#ifndef SUNDOG_KERNEL_BSDF_FRESNEL_H
#define SUNDOG_KERNEL_BSDF_FRESNEL_H

#include "kernel/materials/reflection.h"

KERNEL_BEGIN

/// Unpolarised reflectance of a metal with complex index of refraction n + ik, for one wavelength (Born and Wolf,
/// section 14.2).
FN real fresnel_conductor(real cos_in, real n, real k) {
    real c = clamp(cos_in, real(0.0f), real(1.0f));
    real c2 = c * c;
    real s2 = 1.0f - c2;
    real n2 = n * n;
    real k2 = k * k;
    real difference = n2 - k2 - s2;
    real a2_plus_b2 = sqrt(difference * difference + 4.0f * n2 * k2);
    real a = sqrt(max((a2_plus_b2 + difference) * 0.5f, real(0.0f)));
    real sum = a2_plus_b2 + c2;
    real perpendicular = (sum - 2.0f * a * c) / (sum + 2.0f * a * c);
    real sum_p = c2 * a2_plus_b2 + s2 * s2;
    real parallel = perpendicular * (sum_p - 2.0f * a * c * s2) / (sum_p + 2.0f * a * c * s2);
    return (perpendicular + parallel) * 0.5f;
}

/// The same of red, green and blue.
FN real3 fresnel_conductor(real cos_in, real3 n, real3 k) {
    return real3(fresnel_conductor(cos_in, n.x, k.x), fresnel_conductor(cos_in, n.y, k.y),
                 fresnel_conductor(cos_in, n.z, k.z));
}

/// Schlick's approximation between the reflectances along the normal, f0, and along the surface, f90.
FN real3 fresnel_between(real3 f0, real3 f90, real cos_in) {
    real m = clamp(1.0f - cos_in, real(0.0f), real(1.0f));
    real m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}

KERNEL_END

#endif
