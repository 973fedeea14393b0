// SPDX-License-Identifier: Apache-2.0
// How much light particles send on in which direction.
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

/// The same functions as densities over solid angle, a type in each lane.
FN real phase_density(word type, real cosine, real eccentricity) {
    mask hazy = mask_or(type == word(2u), type == word(3u));
    real shape = real(1.0f);
    if (any_lane(hazy)) {
        real half_squared = (1.0f + cosine) * 0.5f;
        half_squared = half_squared * half_squared;
        real p8 = half_squared * half_squared;
        p8 = p8 * p8;
        real p32 = p8 * p8;
        p32 = p32 * p32;
        shape = select(type == word(2u), 0.5f + 4.5f * p8, select(hazy, 0.397590361f + 19.8795181f * p32, shape));
    }
    shape = select(type == word(4u), 0.75f + 0.75f * cosine * cosine, shape);
    mask henyey = type == word(5u);
    if (any_lane(henyey)) {
        real e2 = eccentricity * eccentricity;
        real d = max(1.0f + e2 - 2.0f * eccentricity * cosine, real(1e-6f));
        shape = select(henyey, (1.0f - e2) / (d * sqrt(d)), shape);
    }
    return shape * 0.0795774715f;
}

/// Draws the cosine of a direction by phase_density(), with u in [0, 1).
FN real phase_cosine(word type, real eccentricity, real u) {
    real drawn = 2.0f * u - 1.0f;
    mask hazy = mask_or(type == word(2u), type == word(3u));
    if (any_lane(hazy)) {
        // A constant, and a power of half of 1 + cosine.
        real even = select(type == word(2u), real(0.5f), real(0.397590361f));
        mask peaked = u >= even;
        real v = select(peaked, (u - even) / (1.0f - even), u / even);
        real near_one = power(v, select(type == word(2u), real(0.111111111f), real(0.0303030303f)));
        drawn = select(hazy, 2.0f * select(peaked, near_one, v) - 1.0f, drawn);
    }
    mask rayleigh = type == word(4u);
    if (any_lane(rayleigh)) {
        // The root of c^3 + 3 c = 8 u - 4 (Cardano).
        real q = 4.0f * u - 2.0f;
        real a = power(q + sqrt(q * q + 1.0f), real(0.333333333f));
        drawn = select(rayleigh, a - 1.0f / max(a, real(1e-6f)), drawn);
    }
    mask henyey = mask_and(type == word(5u), abs(eccentricity) > real(1e-3f));
    if (any_lane(henyey)) {
        real g = select(henyey, eccentricity, real(0.5f));
        real t = (1.0f - g * g) / (1.0f - g + 2.0f * g * u);
        drawn = select(henyey, (1.0f + g * g - t * t) / (2.0f * g), drawn);
    }
    return clamp(drawn, real(-1.0f), real(1.0f));
}

KERNEL_END

#endif
