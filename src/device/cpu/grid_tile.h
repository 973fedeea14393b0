// SPDX-License-Identifier: Apache-2.0
// Refinement of one tile of a film, on the grid or along scan lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "device/cpu/point_kernel.h"
#include "device/device.h"
#include "sampling/grid_refinement.h"
#include "sampling/scanline_refinement.h"

namespace sundog::cpu {

/// Memory to work in, for one tile at a time; made when it is first needed.
struct RefinementMemory {
    std::unique_ptr<sampling::GridRefinement> grid;
    std::unique_ptr<sampling::ScanlineRefinement> scanline;
};

/// A tile to refine: at most sampling::kRefinedTileSide pixels a side.
struct GridWork {
    const kernel::SceneView& scene;
    PointKernel trace = nullptr;
    LookKernel look = nullptr;
    PixelRect region;  ///< Pixels to write.
    sampling::RefinementQuality quality;
    const std::uint8_t* finest = nullptr;  ///< As in GridRefinement::refine(); so finest_stride.
    std::ptrdiff_t finest_stride = 0;
    RefinementMethod method = RefinementMethod::grid;
    RefinementMemory& memory;
    Film& film;
};

/// What that took.
struct GridRays {
    std::uint64_t rays = 0, shadow_rays = 0;
    std::uint64_t points = 0;  ///< Of the picture's pixels and those beside them that were traced.
};

/// Writes the film's radiance and, if it has that plane, its cost: 0 where a pixel's eye ray isn't traced.
GridRays refine_tile(const GridWork& work);

}  // namespace sundog::cpu
