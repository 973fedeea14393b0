// SPDX-License-Identifier: Apache-2.0
// One-channel pictures and separable filters over them.
#pragma once

#include <cstddef>
#include <vector>

namespace sundog::output {

/// One float a pixel, row by row.
struct Plane {
    Plane(int width_, int height_)
        : width(width_),
          height(height_),
          values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    int width, height;
    std::vector<float> values;
};

/// Weights at the offsets -radius … radius, an odd number.
using Kernel = std::vector<float>;

/// Gaussian of standard deviation `sigma`, in pixels, whose weights have the sum 1.
Kernel gaussian(float sigma, int radius);

/// `plane` correlated with `along_x` in rows and `along_y` in columns; pixels outside are those of the border.
Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y);

}  // namespace sundog::output
