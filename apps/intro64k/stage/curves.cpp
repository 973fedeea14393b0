// SPDX-License-Identifier: Apache-2.0
#include "stage/curves.h"

#include <cmath>

namespace sundog::intro {

using namespace kernel;

vec3 spline(const Key* keys, uint count, float seconds) {
    uint i = 0;
    while (i + 2 < count && keys[i + 1].seconds <= seconds) ++i;
    const Key& a = keys[i];
    const Key& b = keys[i + 1];
    const float span = b.seconds - a.seconds;
    const float t = clamp((seconds - a.seconds) / span, 0.0F, 1.0F);
    const auto tangent = [&](uint k) {
        if (k == 0 || k + 1 == count) return vec3(0, 0, 0);
        return (keys[k + 1].value - keys[k - 1].value) * (span / (keys[k + 1].seconds - keys[k - 1].seconds));
    };
    const float t2 = t * t;
    const float t3 = t2 * t;
    return a.value * (2 * t3 - 3 * t2 + 1) + tangent(i) * (t3 - 2 * t2 + t) + b.value * (3 * t2 - 2 * t3) +
           tangent(i + 1) * (t3 - t2);
}

float ramp(float from, float to, float seconds) {
    const float t = clamp((seconds - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

float pulse(float beats, float sharpness) { return std::exp2(-sharpness * (beats - std::floor(beats))); }

}  // namespace sundog::intro
