// SPDX-License-Identifier: Apache-2.0
// Points of a picture, traced with a memory of what was met: what grid refinement asks of the kernel.
#pragma once

#include "device/cpu/ray_batch.h"
#include "sampling/traced_grid.h"

namespace sundog::cpu {

/// Points of a tile whose first pixel is (x0, y0).
struct PointBatch {
    const kernel::SceneView& scene;
    int x0 = 0, y0 = 0;
    const sampling::TilePlace* places = nullptr;
    int count = 0;
    /// What their eye rays are taken to hit without a search (PointRecord::seen of others), if not null.
    const sampling::SeenPrimitive* seen = nullptr;
};

/// Traces points. Eye rays that hit what they were taken to hit aren't counted.
using PointKernel = BatchRays (*)(const PointBatch& points, sampling::PointRecord* records);
/// Looks textures up where light is known.
using LookKernel = BatchRays (*)(const PointBatch& points, sampling::SurfaceLook* looks);

// The same functions for each width (see tile_kernel.h); plain scenes have no textures.
BatchRays trace_points_4(const PointBatch& points, sampling::PointRecord* records);
BatchRays trace_points_8(const PointBatch& points, sampling::PointRecord* records);
BatchRays trace_points_16(const PointBatch& points, sampling::PointRecord* records);
BatchRays trace_plain_points_4(const PointBatch& points, sampling::PointRecord* records);
BatchRays trace_plain_points_8(const PointBatch& points, sampling::PointRecord* records);
BatchRays trace_plain_points_16(const PointBatch& points, sampling::PointRecord* records);
BatchRays look_at_points_4(const PointBatch& points, sampling::SurfaceLook* looks);
BatchRays look_at_points_8(const PointBatch& points, sampling::SurfaceLook* looks);
BatchRays look_at_points_16(const PointBatch& points, sampling::SurfaceLook* looks);

}  // namespace sundog::cpu
