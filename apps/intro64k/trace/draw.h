// SPDX-License-Identifier: Apache-2.0
// The tracer's way out of the one unit that is compiled for AVX2 and FMA, eight rays at a time. Who calls it has asked
// the processor before.
#pragma once

#include "trace/tables.h"
#include "trace/tile_work.h"

namespace sundog::intro {

/// Draws the tile whose left upper corner is at (x, y); counts in `work` grow by what it traced.
void draw_tile(const World& world, const Tables& tables, const Quality& quality, const Picture& picture, TileWork& work,
               uint x, uint y);

}  // namespace sundog::intro
