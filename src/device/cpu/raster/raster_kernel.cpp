// SPDX-License-Identifier: Apache-2.0
// Compiled once for each width (SUNDOG_KERNEL_LANES), under the names SUNDOG_BIN_KERNEL, SUNDOG_RASTER_KERNEL and
// SUNDOG_CELL_KERNEL.
#include "device/cpu/raster/raster_kernel.h"

#include "device/cpu/raster/scan_cells.h"

namespace sundog::cpu::raster {

void SUNDOG_BIN_KERNEL(const kernel::SceneView& scene, const EyeView& view, TriangleRun run, BinScratch& scratch,
                       Bins& bins) {
    bin_triangles(scene, view, run, scratch, bins);
}

void SUNDOG_RASTER_KERNEL(const TileToRaster& tile, TileScratch& scratch) {
    TileScan scan(tile, scratch);
    scan.scan_all();
    scan.conclude();
    if (tile.scene.frame.plane_count > 0) scan.ask_at_planes();
    for (const PixelRect& rect : tile.traced) scan.ask_at(rect);
}

void SUNDOG_CELL_KERNEL(const CellsToScan& work, CellScratch& scratch) {
    CellScan scan(work, scratch);
    scan.scan_all();
    scan.conclude();
}

}  // namespace sundog::cpu::raster
