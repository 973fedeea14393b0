// SPDX-License-Identifier: Apache-2.0
// The sky: air, the sun with its ring of 22 degrees and its two dogs (parhelia), clouds.
#pragma once

#include "kernel/math.h"
#include "trace/lanes.h"

namespace sundog::intro {

/// 1 at x = 0, falling off like a bell without an exponential.
FN real bell(real x) {
    real d = 1.0f / (1.0f + x * x);
    return d * d;
}

/// Radiance of the clear sky in a unit direction. Ice crystals bend light by 22 degrees at least (Greenler, Rainbows,
/// Halos and Glories, 1980, chapter 2): red least, so rings and dogs are red towards the sun.
[[gnu::noinline]] inline real3 sky_color(const Air& air, const Sky& sky, const real3& d) {
    real up = max(d.z, real(0.0f));
    real haze = 1.0f - up;
    haze = haze * haze;
    real3 color = mix(real3(air.zenith), real3(air.horizon), haze * haze);
    if (sky.sun_color.x <= 0.0f) return color;
    real toward = dot(d, real3(sky.sun_place));
    real near = max(toward, real(0.0f));
    // The disc and the glare around it.
    real near4 = near * near * near * near;
    real bright = near4 * near4 * 0.22f;
    for (uint i = 0u; i < 2u; i = i + 1u) {
        bright = bright + power(near, real(i == 0u ? 5000.0f : 90.0f)) * (i == 0u ? 12.0f : 0.55f);
    }
    color = color + real3(sky.sun_color) * bright;
    if (sky.halo > 0.0f) {
        real3 ring = real3(bell((toward - 0.9285f) * 110.0f), bell((toward - 0.9255f) * 120.0f),
                           bell((toward - 0.9205f) * 85.0f));
        real3 dogs = real3(real(0.0f));
        for (uint i = 0u; i < 2u; i = i + 1u) {
            real a = max(dot(d, real3(sky.dogs[i])), real(0.0f));
            // Towards the sun, along the way to it, it is red.
            real side = clamp((toward - 0.9245f) * 70.0f, real(-1.0f), real(1.0f));
            real spot = bell((1.0f - a) * 1100.0f) * 5.0f + bell((1.0f - a) * 240.0f) * 0.8f;
            dogs =
                dogs + real3(spot * (0.85f + 0.6f * side), spot * (0.8f - 0.05f * side), spot * (0.75f - 0.75f * side));
        }
        color = color + real3(sky.sun_color) * (ring * real(0.16f) + dogs * real(0.16f)) * real(sky.halo);
    }
    return color;
}

/// What a whole cloud adds to the clear sky in a direction.
FN real3 cloud_light(const Sky& sky, real3 d, real3 clear) {
    real toward = max(dot(d, real3(sky.sun_place)), real(0.0f));
    real toward4 = toward * toward * toward * toward;
    real3 lit = real3(sky.clouds) + real3(sky.sun_color) * (toward4 * toward4 * 0.5f);
    real rise = clamp(d.z * 5.0f, real(0.0f), real(1.0f));
    return (lit - clear) * rise;
}

}  // namespace sundog::intro
