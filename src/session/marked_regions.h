// SPDX-License-Identifier: Apache-2.0
// Pixels that are to get more samples, as rectangles for Device::render_regions().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "device/film.h"

namespace sundog {

/// Rectangles that hold all pixels of `bounds` whose mark (row by row) isn't 0. They don't overlap, and their sides lie
/// on multiples of 8 pixels or on the bounds.
std::vector<PixelRect> marked_regions(const PixelRect& bounds, std::span<const std::uint8_t> marks);

}  // namespace sundog
