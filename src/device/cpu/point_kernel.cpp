// SPDX-License-Identifier: Apache-2.0
// Points of plain scenes, compiled for each width with paths that remember what they met (SUNDOG_KERNEL_RECORDS), under
// the name SUNDOG_POINT_KERNEL; other scenes' are traced in tile_kernel.cpp.
#include "device/cpu/trace_points.h"

namespace sundog::cpu {

BatchRays SUNDOG_POINT_KERNEL(const PointBatch& points, sampling::PointRecord* records) {
    return trace_points(points, records);
}

}  // namespace sundog::cpu
