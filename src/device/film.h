// SPDX-License-Identifier: Apache-2.0
// The picture under way: sums of radiance and auxiliary planes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace sundog {

/// Pixels [x0, x1) x [y0, y1); y grows downwards.
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Sums of linear RGB radiance over samples, times their weights, with the sum of weights in the fourth place: the
/// number of samples, but for filters that go below 0 (about it, there); auxiliary planes on request (those asked for
/// are sized as `radiance`, others empty). AOVs are those of sample 0 (cost: the sum).
struct Film {
    /// A film of the given pixels of an image, zeroed, with the planes of the AOV_* bits `aovs`.
    explicit Film(PixelRect bounds, std::uint32_t aovs = 0);

    PixelRect bounds;
    std::uint32_t aovs = 0;
    std::vector<std::array<float, 4>> radiance;  ///< (sum r, sum g, sum b, weights), row by row.
    std::vector<float> depth;
    std::vector<Vec3> normal, albedo;
    std::vector<std::uint32_t> object, primitive, material;  ///< AOV_OBJECT
    std::vector<float> cost;

    /// Place of pixel (x, y) of the image in the planes.
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - bounds.y0) * static_cast<std::size_t>(bounds.width()) +
               static_cast<std::size_t>(x - bounds.x0);
    }
    /// Mean radiance of a pixel; black where it has no sample.
    [[nodiscard]] Vec3 mean(int x, int y) const {
        const auto& sum = radiance[index(x, y)];
        const float scale = sum[3] > 0 ? 1 / sum[3] : 0;
        return {sum[0] * scale, sum[1] * scale, sum[2] * scale};
    }
};

}  // namespace sundog
