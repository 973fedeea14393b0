// SPDX-License-Identifier: Apache-2.0
// The filter itself, over one tile.
#pragma once

#include <array>

#include "denoise/planes.h"

namespace sundog::denoise {

/// A tile's pixels, row by row, of three channels.
using TileLight = std::array<std::array<float, kTilePixels>, 3>;

/// Filters tile (tile_x, tile_y).
void filter_tile(const Light& light, const Guides& guides, const Layout& layout, int tile_x, int tile_y,
                 TileLight& out);

}  // namespace sundog::denoise
