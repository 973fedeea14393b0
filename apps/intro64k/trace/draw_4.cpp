// SPDX-License-Identifier: Apache-2.0
#include "trace/draw.h"
#include "trace/draw_tile.h"

namespace sundog::intro {

DrawTile draw_tile_by_4() { return draw_tile; }

}  // namespace sundog::intro
