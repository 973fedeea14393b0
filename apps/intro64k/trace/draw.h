// SPDX-License-Identifier: Apache-2.0
// The tracer, compiled once for each width of vectors.
#pragma once

#include "trace/tables.h"
#include "trace/tile_work.h"

namespace sundog::intro {

/// Draws the tile whose left upper corner is at (x, y); counts grow by what it traced.
using DrawTile = void (*)(const World& world, const Tables& tables, const Quality& quality, const Picture& picture,
                          TileWork& work, uint x, uint y);

DrawTile draw_tile_by_4();
DrawTile draw_tile_by_8();   ///< Needs AVX2 and FMA.
DrawTile draw_tile_by_16();  ///< Needs AVX-512 F, BW, DQ and VL.

/// Needs AVX2 as well.
/// Fills the slices [first, last) of the noise volume (trace/noise_volume.h), which has kVolumeVoxels.
void make_noise(uint* voxels, uint first, uint last);

}  // namespace sundog::intro
