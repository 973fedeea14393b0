// SPDX-License-Identifier: Apache-2.0
// Which of two surfaces at one place a ray meets.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "device/accel/primitive_facts.h"
#include "device/cpu/embree.h"

namespace sundog::cpu {

using accel::kCoincident;

/// How far to look for hits that may be at the place of the lane's hit, or nearer.
inline float reach_of(RTCRayN* rays, unsigned n, unsigned lane) {
    return RTCRayN_tfar(rays, n, lane) * (1 + kCoincident);
}

inline RTCBounds rtc_bounds(const Bounds3& b) {
    return {b.lower.x, b.lower.y, b.lower.z, 0, b.upper.x, b.upper.y, b.upper.z, 0};
}

/// Enters a hit of the geometry or instance `id` at `t` if it is nearer than the lane's, or at its place and before it
/// in order: what is left comes before what is entered, then what was written first. The same for all pixels, whichever
/// was found first. False if it isn't entered.
inline bool enter_hit(const RTCIntersectFunctionNArguments* args, unsigned lane, float t, float nx, float ny,
                      float nz) {
    const unsigned n = args->N;
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, n);
    const float far = RTCRayN_tfar(rays, n, lane);
    const auto along = [&](float x, float y, float z) {
        return x * RTCRayN_dir_x(rays, n, lane) + y * RTCRayN_dir_y(rays, n, lane) + z * RTCRayN_dir_z(rays, n, lane);
    };
    const unsigned other_geometry = RTCHitN_geomID(hits, n, lane);
    if (other_geometry == RTC_INVALID_GEOMETRY_ID) {
        if (!(t < far)) return false;
    } else if (std::abs(t - far) <= kCoincident * far) {
        const unsigned other_instance = RTCHitN_instID(hits, n, lane, 0);
        const unsigned other = other_instance != RTC_INVALID_GEOMETRY_ID ? other_instance : other_geometry;
        const unsigned instance = args->context->instID[0];
        const unsigned self = instance != RTC_INVALID_GEOMETRY_ID ? instance : args->geomID;
        const bool leaves = along(nx, ny, nz) > 0;
        // The other's normal may be in the space of a moving object; then its order alone counts.
        const bool comparable = instance == other_instance;
        const bool other_leaves = comparable ? along(RTCHitN_Ng_x(hits, n, lane), RTCHitN_Ng_y(hits, n, lane),
                                                     RTCHitN_Ng_z(hits, n, lane)) > 0
                                             : leaves;
        if (leaves != other_leaves ? other_leaves
                                   : self > other || (self == other && args->primID >= RTCHitN_primID(hits, n, lane)))
            return false;
    } else if (!(t < far)) {
        return false;
    }
    // Never farther than before, which Embree counts on.
    RTCRayN_tfar(rays, n, lane) = std::min(t, far);
    RTCHitN_Ng_x(hits, n, lane) = nx;
    RTCHitN_Ng_y(hits, n, lane) = ny;
    RTCHitN_Ng_z(hits, n, lane) = nz;
    RTCHitN_geomID(hits, n, lane) = args->geomID;
    RTCHitN_instID(hits, n, lane, 0) = args->context->instID[0];
    return true;
}

}  // namespace sundog::cpu
