// SPDX-License-Identifier: Apache-2.0
// Embree's callbacks for exact solids; their user data is a GeometryData with a solid.
#pragma once

#include "device/cpu/geometry_data.h"

namespace sundog::cpu {

/// In the tree, unbounded solids cost their test for every ray, as they must.
void solid_bounds(const RTCBoundsFunctionArguments* args);
void intersect_solid(const RTCIntersectFunctionNArguments* args);
void occluded_by_solid(const RTCOccludedFunctionNArguments* args);

}  // namespace sundog::cpu
