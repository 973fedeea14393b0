// SPDX-License-Identifier: Apache-2.0
// How much light particles send on in which direction. CPU only.
#ifndef SUNDOG_KERNEL_ATMOSPHERE_SCATTERING_H
#define SUNDOG_KERNEL_ATMOSPHERE_SCATTERING_H

#include "kernel/math.h"

KERNEL_BEGIN

/// Phase functions of POV-Ray's scattering types 1 to 5 (reference, section 3.4.8.2.3): isotropic, haze and murky air
/// (Nishita, Miyawaki and Nakamae, A Shading Model for Atmospheric Scattering, SIGGRAPH 1987), Rayleigh, Henyey and
/// Greenstein. `cosine` is 1 where the light goes on straight to the eye. The factors are those that pictures of povray
/// 3.7 show.
FN real phase_function(uint type, real cosine, float eccentricity) {
    if (type == 2u || type == 3u) {
        real half_squared = (1.0f + cosine) * 0.5f;
        real p2 = half_squared * half_squared;
        real p8 = p2 * p2 * p2 * p2;
        if (type == 2u) return 0.576655375f * (1.0f + 9.0f * p8);
        real p32 = p8 * p8 * p8 * p8;
        return 0.495714547f * (1.0f + 50.0f * p32);
    }
    if (type == 4u) return 0.799372013f * (1.0f + cosine * cosine);
    if (type == 5u && eccentricity != 0.0f) {
        float e2 = eccentricity * eccentricity;
        real d = max(real(1.0f + e2) - cosine * (2.0f * eccentricity), real(1e-6f));
        return (1.0f - e2) / (d * sqrt(d));
    }
    return real(1.0f);
}

KERNEL_END

#endif
