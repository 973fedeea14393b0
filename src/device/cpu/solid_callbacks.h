// SPDX-License-Identifier: Apache-2.0
// Embree's callbacks for exact solids: geometryUserPtr is a GeometryData whose `solid` is set.
#pragma once

#include <cstdint>

#include "device/cpu/geometry_data.h"

namespace sundog::cpu {

void solid_bounds(const RTCBoundsFunctionArguments* args);

// Ray by ray, for packets of any number.
void intersect_solid(const RTCIntersectFunctionNArguments* args);
void occluded_by_solid(const RTCOccludedFunctionNArguments* args);
// The same, for all lanes of a packet of that many at once where GeometryData::quick tells of the solid; what that
// leaves open is done ray by ray.
void intersect_solid_4(const RTCIntersectFunctionNArguments* args);
void intersect_solid_8(const RTCIntersectFunctionNArguments* args);
void intersect_solid_16(const RTCIntersectFunctionNArguments* args);
void occluded_by_solid_4(const RTCOccludedFunctionNArguments* args);
void occluded_by_solid_8(const RTCOccludedFunctionNArguments* args);
void occluded_by_solid_16(const RTCOccludedFunctionNArguments* args);

/// Where a ray meets a part of a QuickSolid.
struct QuickHit {
    double t;
    std::uint32_t place;  ///< Twice the part's number, plus 1 where the ray leaves it.
    std::uint32_t face;   ///< Crossing::part.
};

// For the units of each width: the lanes whose bits are set, ray by ray.
void intersect_solid_in(const RTCIntersectFunctionNArguments* args, unsigned lanes);
void occluded_by_solid_in(const RTCOccludedFunctionNArguments* args, unsigned lanes);
void enter_quick_hit(const RTCIntersectFunctionNArguments* args, unsigned lane, const QuickHit& hit);

}  // namespace sundog::cpu
