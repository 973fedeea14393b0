// SPDX-License-Identifier: Apache-2.0
// Means over squares of pixels.
#pragma once

#include <vector>

namespace sundog::denoise {

/// The mean of the pixels up to `radius` around each one, of those that lie in the picture.
std::vector<float> smoothed(const std::vector<float>& values, int width, int height, int radius);

}  // namespace sundog::denoise
