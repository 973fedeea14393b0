// SPDX-License-Identifier: Apache-2.0
// Grid refinement of a tile, with the kernel compiled for several widths.
#pragma once

#include <cstdint>

#include "device/cpu/tile_kernel.h"
#include "sampling/grid_refinement.h"

namespace sundog::cpu {

/// A tile to refine: at most sampling::kRefinedTileSide pixels a side.
struct GridWork {
    const RenderScene& scene;
    const Frame& frame;
    const void* traversal;  ///< RTCScene
    PixelRect region;       ///< Pixels to write.
    sampling::RefinementQuality quality;
    const std::uint8_t* finest;  ///< As in GridRefinement::refine(), or null.
    sampling::GridRefinement& refinement;
    Film& film;
    const kernel::IndirectLight* indirect = nullptr;  ///< Where the frame has FEATURE_RADIOSITY.
    const kernel::PhotonLight* photons = nullptr;     ///< Where the frame has FEATURE_PHOTONS.
};

/// What that took.
struct GridRays {
    std::uint64_t rays = 0, shadow_rays = 0;
    std::uint64_t points = 0;  ///< Of the picture's pixels and those beside them that were traced.
};

using GridKernel = GridRays (*)(const GridWork& work);

// The same function for each width and for plain scenes (see tile_kernel.h).
GridRays refine_tile_4(const GridWork& work);
GridRays refine_tile_8(const GridWork& work);
GridRays refine_tile_16(const GridWork& work);
GridRays refine_plain_tile_4(const GridWork& work);
GridRays refine_plain_tile_8(const GridWork& work);
GridRays refine_plain_tile_16(const GridWork& work);

}  // namespace sundog::cpu
