// SPDX-License-Identifier: Apache-2.0
#include "trace/draw.h"
#include "trace/draw_tile.h"

namespace sundog::intro {

DrawTile draw_tile_by_8() { return draw_tile; }

void make_noise(uint* voxels, uint first, uint last) { make_noise_slices(voxels, first, last); }

}  // namespace sundog::intro
