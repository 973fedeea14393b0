// SPDX-License-Identifier: Apache-2.0
// LDR-FLIP: how large the difference between two pictures looks when they alternate in one place.
#pragma once

#include <cstdint>
#include <vector>

#include "output/filter.h"

namespace sundog::output {

/// The perceived error of each pixel, 0 to 1, of two pictures in sRGB codes (3 bytes a pixel), seen at 67 pixels per
/// degree. Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator
/// for Alternating Images", 2020, section 4.
Plane flip_errors(const std::vector<std::uint8_t>& codes_a, const std::vector<std::uint8_t>& codes_b, int width,
                  int height);

}  // namespace sundog::output
