// SPDX-License-Identifier: Apache-2.0
// The colours that textures run through.
#pragma once

#include "trace/tables.h"

namespace sundog::intro {

/// The first index of Tables::palettes.
enum Palette : uint { kClouds, kWhiteMarble, kBlackMarble, kMarbleTiles, kWood, kJade, kSandstone, kPaletteCount };

/// Fills kPaletteCount * kPaletteSize entries, in the form of Tables::palettes.
void make_palettes(uint* entries);

}  // namespace sundog::intro
