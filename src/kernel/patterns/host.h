// SPDX-License-Identifier: Apache-2.0
// Fields, warps and normals that only the host computes, for all lanes that ask, in double precision: those that need
// other parts of the program (functions, solids, data files) or are too rare to be worth a vectorised form.
#ifndef SUNDOG_KERNEL_PATTERNS_HOST_H
#define SUNDOG_KERNEL_PATTERNS_HOST_H

#include "kernel/compat/compat.h"
#ifdef __cplusplus
#include <array>
#include <span>

#include "kernel/patterns/host_fields.h"
#endif

KERNEL_BEGIN

/// Where lanes ask for patterns, and which do.
struct PatternPoint {
    real3 position;
    real3 normal;     ///< The surface's, unit, world space; 0: there is no surface.
    real3 direction;  ///< Of the ray that sees it, unit, world space.
    real3 world;      ///< The surface's point in world space.
    mask asking;      ///< Other lanes' answers are of no use.
};

#ifdef __cplusplus
/// What host field number `index` answers at p in the lanes of `asking`; 0 in others.
FN real3 ask_host(SCENE uint index, real3 p, PatternPoint at, mask asking) {
#if SUNDOG_KERNEL_LANES == 1
    vec3 answer(0.0f, 0.0f, 0.0f);
    const HostPoint point{p, at.normal, at.direction, at.world};
    if (asking) scene.host_fields->at(index, std::span(&point, 1), std::span(&answer, 1));
    return answer;
#else
    const auto lane_of = [](const real3& v, int i) { return vec3(v.x.v[i], v.y.v[i], v.z.v[i]); };
    std::array<HostPoint, kLanes> points;
    std::array<vec3, kLanes> answers;
    std::size_t count = 0;
    for (unsigned lanes = lane_bits(asking); lanes != 0; lanes &= lanes - 1) {
        const int i = std::countr_zero(lanes);
        points[count++] = {lane_of(p, i), lane_of(at.normal, i), lane_of(at.direction, i), lane_of(at.world, i)};
    }
    scene.host_fields->at(index, std::span(points.data(), count), std::span(answers.data(), count));
    real3 answer = real3(real(0.0f));
    count = 0;
    for (unsigned lanes = lane_bits(asking); lanes != 0; lanes &= lanes - 1) {
        const int i = std::countr_zero(lanes);
        const vec3& one = answers[count++];
        answer.x.v[i] = one.x;
        answer.y.v[i] = one.y;
        answer.z.v[i] = one.z;
    }
    return answer;
#endif
}
#endif

KERNEL_END

#endif
