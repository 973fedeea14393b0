// SPDX-License-Identifier: Apache-2.0
// Values over time: keyframes, and the splines between them.
#pragma once

#include "stage/world.h"

namespace sundog::intro {

struct Key {
    float seconds;
    vec3 value;
};

/// Catmull-Rom's spline (A Class of Local Interpolating Splines, 1974) through keys in order of time, tangents over
/// times that need not be even; it rests at both ends.
vec3 spline(const Key* keys, uint count, float seconds);

template <uint N>
vec3 spline(const Key (&keys)[N], float seconds) {
    return spline(keys, N, seconds);
}

/// 0 before `from`, 1 after `to`, smooth between.
float ramp(float from, float to, float seconds);

/// Falls from 1 to 0 after each beat; `beats` counts them, `sharpness` is how many times it halves before the next.
float pulse(float beats, float sharpness);

}  // namespace sundog::intro
