// SPDX-License-Identifier: Apache-2.0
// Points of grid refinement, compiled like tile_kernel.cpp for all scenes and for plain ones, with paths that remember
// what they met (SUNDOG_KERNEL_RECORDS, whose cost other pictures needn't pay), under the names SUNDOG_POINT_KERNEL and
// SUNDOG_LOOK_KERNEL.
#include "device/cpu/trace_points.h"

namespace sundog::cpu {

BatchRays SUNDOG_POINT_KERNEL(const PointBatch& points, sampling::PointRecord* records) {
    return trace_points(points, records);
}

#ifdef SUNDOG_LOOK_KERNEL
BatchRays SUNDOG_LOOK_KERNEL(const PointBatch& points, sampling::SurfaceLook* looks) {
    return look_at_points(points, looks);
}
#endif

}  // namespace sundog::cpu
