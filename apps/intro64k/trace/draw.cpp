// SPDX-License-Identifier: Apache-2.0
#include "trace/draw.h"

#include "trace/draw_tile.h"

namespace sundog::intro {

void draw_tile(const World& world, const Tables& tables, const Quality& quality, const Picture& picture, TileWork& work,
               uint x, uint y) {
    draw_squares(world, tables, quality, picture, work, x, y);
}

}  // namespace sundog::intro
