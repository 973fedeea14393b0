// SPDX-License-Identifier: Apache-2.0
// What is done before rays are traced: once for the film, and once a tile.
#pragma once

#include "trace/tables.h"
#include "trace/tile_work.h"

namespace sundog::intro {

/// Fills the slices [first, last) of Tables::noise, which has kVolumeVoxels: octaves of the kernel's lattice noise that
/// repeat without seams, 16 bits a voxel, those of its neighbour along x above them.
void make_noise(uint* voxels, uint first, uint last);

/// Lists the solids that rays through the tile at (tile_x, tile_y) of a picture may meet, and marks the squares of 8
/// pixels in which a solid so small that it could hide between a square's corners may be seen.
void find_visible(const World& world, const Picture& picture, TileWork& work, uint tile_x, uint tile_y);

}  // namespace sundog::intro
