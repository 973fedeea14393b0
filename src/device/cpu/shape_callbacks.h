// SPDX-License-Identifier: Apache-2.0
// Embree's callbacks for spheres and boxes: geometryUserPtr is a GeometryData.
#pragma once

#include "device/accel/primitive_facts.h"
#include "device/cpu/geometry_data.h"

namespace sundog::cpu {

/// True where hits from behind are passed over.
inline bool culls(const GeometryData& data, std::uint32_t primitive) {
    return data.culling && data.opaque(accel::material_of(*data.scene, data.geometry, primitive));
}

void shape_bounds(const RTCBoundsFunctionArguments* args);

/// Those that find hits, for one width of packets.
struct ShapeCallbacks {
    RTCIntersectFunctionN intersect;
    RTCOccludedFunctionN occluded;
    RTCIntersectFunctionN intersect_solid;
    RTCOccludedFunctionN occluded_by_solid;
};

// Ray by ray, for packets of any number.
void intersect_shapes(const RTCIntersectFunctionNArguments* args);
void occluded_by_shapes(const RTCOccludedFunctionNArguments* args);
// The same, with the same bits, for all lanes of a packet of that many at once; others are done ray by ray.
void intersect_shapes_4(const RTCIntersectFunctionNArguments* args);
void intersect_shapes_8(const RTCIntersectFunctionNArguments* args);
void intersect_shapes_16(const RTCIntersectFunctionNArguments* args);
void occluded_by_shapes_4(const RTCOccludedFunctionNArguments* args);
void occluded_by_shapes_8(const RTCOccludedFunctionNArguments* args);
void occluded_by_shapes_16(const RTCOccludedFunctionNArguments* args);

}  // namespace sundog::cpu
