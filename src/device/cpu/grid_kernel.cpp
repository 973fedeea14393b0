// SPDX-License-Identifier: Apache-2.0
// Grid refinement for plain scenes, compiled for each width with paths that remember what they met
// (SUNDOG_KERNEL_RECORDS), under the name SUNDOG_GRID_KERNEL; other scenes' is in tile_kernel.cpp.
#include "device/cpu/grid_tracer.h"

namespace sundog::cpu {

GridRays SUNDOG_GRID_KERNEL(const GridWork& work) { return refine_grid_tile(work); }

}  // namespace sundog::cpu
