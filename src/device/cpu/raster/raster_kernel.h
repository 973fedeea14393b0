// SPDX-License-Identifier: Apache-2.0
// The rasteriser compiled for several widths, behind two function pointers each.
//
// For each ray of a tile it finds the triangle that tracing would find, or says that it can't be sure. A triangle is
// three linear functions of the picture's coordinates, positive inside its edges, and a fourth, the inverse length of
// the way to it (Olano and Greer 1997, Triangle Scan Conversion Using 2D Homogeneous Coordinates): so nothing has to be
// clipped where it passes the eye. Each has a bound on its rounding and on that of the traced test. Where a ray lies
// within it of an edge, or two triangles lie within it of each other, the ray is traced.
#pragma once

#include <tbb/cache_aligned_allocator.h>

#include <cstdint>
#include <span>
#include <vector>

#include "device/cpu/raster/eye_view.h"
#include "device/film.h"
#include "kernel/compat/cpp.h"

namespace sundog::cpu::raster {

/// Side of the squares of pixels that are rasterised at a time.
inline constexpr int kTileSide = 32;
inline constexpr int kTilePixels = kTileSide * kTileSide;

/// Some of a scene's triangles, all in world space.
struct TriangleRun {
    std::uint32_t first = 0, count = 0;
};

/// Which triangles of a run may be seen in which tile of the picture.
struct Bins {
    std::vector<std::uint32_t> begins;     ///< For each tile, row by row, where its triangles begin; and one end more.
    std::vector<std::uint32_t> triangles;  ///< By tile, ascending in each.
    std::vector<std::uint32_t> unbounded;  ///< Triangles near the plane of the eye, which may be anywhere.
};

/// Memory for bin_triangles().
struct BinScratch {
    struct Entry {
        std::uint32_t triangle;
        std::uint16_t x0, x1, y0, y1;  ///< Tiles, inclusively.
    };
    std::vector<Entry> entries;
};

/// Sorts a run's triangles into the tiles of the picture.
using BinKernel = void (*)(const kernel::SceneView& scene, const EyeView& view, TriangleRun run, BinScratch& scratch,
                           Bins& bins);
void bin_triangles_4(const kernel::SceneView& scene, const EyeView& view, TriangleRun run, BinScratch& scratch,
                     Bins& bins);
void bin_triangles_8(const kernel::SceneView& scene, const EyeView& view, TriangleRun run, BinScratch& scratch,
                     Bins& bins);
void bin_triangles_16(const kernel::SceneView& scene, const EyeView& view, TriangleRun run, BinScratch& scratch,
                      Bins& bins);

/// Memory for rasterising one tile, in the kernel's blocks (RasterisedTile).
struct TileScratch {
    /// Of each pixel: the triangle that is surely met and surely before all others that surely are, if any is; the
    /// least and the greatest that its inverse length may be; and the greatest of any other that may be met.
    alignas(64) float x[kTilePixels], y[kTilePixels];  ///< Where each pixel's ray goes, in the picture's pixels.
    alignas(64) float low[kTilePixels], high[kTilePixels], others[kTilePixels];
    alignas(64) std::uint32_t nearest[kTilePixels];
};

/// One tile at one sample of its pixels.
struct TileToRaster {
    const kernel::SceneView& scene;
    const EyeView& view;
    std::span<const std::uint32_t> triangles;  ///< That may be seen in it.
    int x0 = 0, y0 = 0;                        ///< Its first pixel.
    PixelRect wanted;                          ///< Pixels of it that are asked for.
    kernel::PixelSampling sampling{};          ///< Where in each pixel the ray goes: by
    std::uint32_t sample = 0;                  ///< the sample of this number.
    std::span<const PixelRect> traced;         ///< Pixels in which something else may be seen.
};

/// Leaves in scratch.nearest what EyeHits::triangles holds.
using TileRaster = void (*)(const TileToRaster& tile, TileScratch& scratch);
void raster_tile_4(const TileToRaster& tile, TileScratch& scratch);
void raster_tile_8(const TileToRaster& tile, TileScratch& scratch);
void raster_tile_16(const TileToRaster& tile, TileScratch& scratch);

/// Memory for scan_cells(), which it aligns by itself: as TileScratch.
struct CellScratch {
    template <class T>
    using Aligned = std::vector<T, tbb::cache_aligned_allocator<T>>;
    Aligned<float> low, high, others;
    Aligned<std::uint32_t> nearest;
};

/// Rows [begin, end) of one side of the cube around a light.
struct CellsToScan {
    const kernel::SceneView& scene;
    const EyeView& view;  ///< Through that side, of side*side pixels.
    std::span<const TriangleRun> runs;
    std::span<const std::uint32_t> opaque;  ///< For each triangle: LIGHT_CELL_BLOCKS or 0.
    std::span<const PixelRect> unknown;     ///< Cells in which something else may be.
    int side = 0, begin = 0, end = 0;
    float nearness_end = 0;          ///< What is nearer than this, by its inverse length, may hide the light itself.
    std::uint32_t* cells = nullptr;  ///< Of these rows; aligned to 64 bytes.
};

/// Fills in what LightCells::cells holds.
using CellKernel = void (*)(const CellsToScan& work, CellScratch& scratch);
void scan_cells_4(const CellsToScan& work, CellScratch& scratch);
void scan_cells_8(const CellsToScan& work, CellScratch& scratch);
void scan_cells_16(const CellsToScan& work, CellScratch& scratch);

}  // namespace sundog::cpu::raster
