// SPDX-License-Identifier: Apache-2.0
// Embree's callbacks for exact solids; their user data is a GeometryData with a solid.
#pragma once

#include "device/cpu/geometry_data.h"

namespace sundog::cpu {

/// Bounds for Embree's tree. What has no end reaches 1e12: Embree's cost estimate multiplies areas with numbers of
/// objects in single precision, so infinite boxes would spoil its tree, and beyond 1e12 nothing can be told apart in a
/// picture anyway. In the tree, unbounded solids cost their test for every ray, as they must.
void solid_bounds(const RTCBoundsFunctionArguments* args);
void intersect_solid(const RTCIntersectFunctionNArguments* args);
void occluded_by_solid(const RTCOccludedFunctionNArguments* args);

}  // namespace sundog::cpu
