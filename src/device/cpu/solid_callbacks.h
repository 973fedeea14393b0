// SPDX-License-Identifier: Apache-2.0
// Embree's callbacks for exact solids: geometryUserPtr is a GeometryData whose `solid` is set.
#pragma once

#include <array>
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

/// Where lanes meet the parts of a QuickSolid.
struct QuickHits {
    std::array<double, 16> t;
    std::array<double, 16> place;  ///< Twice the part's number, plus 1 where the ray leaves it.
    std::array<double, 16> face;   ///< Crossing::part.
};

// For the units of each width: the lanes whose bits are set, ray by ray.
void intersect_solid_in(const RTCIntersectFunctionNArguments* args, unsigned lanes);
void occluded_by_solid_in(const RTCOccludedFunctionNArguments* args, unsigned lanes);
/// Enters the hits of the lanes whose bits are set.
void enter_quick_hits(const RTCIntersectFunctionNArguments* args, unsigned lanes, const QuickHits& hits);

}  // namespace sundog::cpu
