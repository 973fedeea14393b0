// SPDX-License-Identifier: Apache-2.0
// The kernel compiled for several widths, behind one function pointer each.
#pragma once

#include <cstdint>
#include <span>

#include "device/film.h"
#include "device/render_scene.h"
#include "kernel/compat/cpp.h"

namespace sundog::cpu {

/// What rasterising knows of the eye rays of a square of pixels, in the kernel's blocks: those of a packet, row by row,
/// and in each its pixels, row by row.
struct RasterisedTile {
    int x0 = 0, y0 = 0;                         ///< Its first pixel, at the corner of a block.
    int side = 0;                               ///< In pixels.
    const std::uint32_t* triangles = nullptr;   ///< As in EyeHits; aligned to 64 bytes.
    const std::uint32_t* geometries = nullptr;  ///< Likewise.
};

/// One tile's work. Pixels are traced in fixed blocks, so neighbouring tiles never change each other's bits.
struct TileWork {
    const RenderScene& scene;
    const Frame& frame;
    const void* traversal;  ///< RTCScene
    PixelRect region;       ///< Pixels to write.
    std::uint32_t first_sample, sample_count;
    Film& film;
    std::span<const std::uint8_t> wanted{};           ///< As in RenderWork.
    const kernel::IndirectLight* indirect = nullptr;  ///< Where the frame has FEATURE_RADIOSITY.
    const kernel::PhotonLight* photons = nullptr;     ///< Where the frame has FEATURE_PHOTONS.
    const kernel::LightCells* light_cells = nullptr;  ///< For each of the frame's lights; null: nothing is known.
    const RasterisedTile* rasterised = nullptr;       ///< What is known of the region's eye rays; null: nothing.
};

/// Rays that a tile took.
struct TileRays {
    std::uint64_t rays = 0, shadow_rays = 0;
};

/// The kernel's view of a scene and a frame, which outlive it.
kernel::SceneView view_of(const RenderScene& scene, const Frame& frame, const void* traversal);

using TileKernel = TileRays (*)(const TileWork& work);

// The same function for each width, in units compiled for SSE4.2, AVX2 and AVX-512.
TileRays render_tile_4(const TileWork& work);
TileRays render_tile_8(const TileWork& work);
TileRays render_tile_16(const TileWork& work);
// The same for frames that need no more than kernel::FEATURES_PLAIN, with the same bits, faster.
TileRays render_plain_tile_4(const TileWork& work);
TileRays render_plain_tile_8(const TileWork& work);
TileRays render_plain_tile_16(const TileWork& work);

// Likewise, by paths.
TileRays path_tile_4(const TileWork& work);
TileRays path_tile_8(const TileWork& work);
TileRays path_tile_16(const TileWork& work);
TileRays plain_path_tile_4(const TileWork& work);
TileRays plain_path_tile_8(const TileWork& work);
TileRays plain_path_tile_16(const TileWork& work);

}  // namespace sundog::cpu
