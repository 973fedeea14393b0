// SPDX-License-Identifier: Apache-2.0
// What the filter reads: planes of floats with a margin around them, so that no loop asks where the picture ends.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace sundog::denoise {

inline constexpr int kReach = 7;      ///< How far away pixels are looked at, in pixels.
inline constexpr int kPatch = 3;      ///< Of the squares that are compared: so far around a pixel.
inline constexpr int kTileSide = 32;  ///< Of what one task filters.
inline constexpr int kMargin = kReach + kPatch;
inline constexpr std::size_t kTilePixels = std::size_t{kTileSide} * kTileSide;

/// Where pixels lie in planes whose sides are whole tiles.
struct Layout {
    Layout(int width_, int height_)
        : width(width_),
          height(height_),
          tiles_x((width_ + kTileSide - 1) / kTileSide),
          tiles_y((height_ + kTileSide - 1) / kTileSide),
          stride(tiles_x * kTileSide + 2 * kMargin),
          rows(tiles_y * kTileSide + 2 * kMargin) {}
    [[nodiscard]] std::ptrdiff_t at(int x, int y) const {
        return static_cast<std::ptrdiff_t>(y + kMargin) * stride + x + kMargin;
    }
    /// In planes without a margin.
    [[nodiscard]] std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows); }
    int width, height, tiles_x, tiles_y, stride, rows;
};

using Plane = std::vector<float>;

/// Light divided by albedo, and its noise.
struct Light {
    std::array<Plane, 3> channels;
    Plane variance;  ///< Sum of the channels', smoothed.
};

/// What the eye rays met.
struct Guides {
    std::array<Plane, 3> normal;
    Plane nearness;          ///< 1/depth, in units of the picture's middle one: linear over flat surfaces.
    Plane slope_x, slope_y;  ///< Of nearness along the surface, a pixel.
    Plane inside;            ///< 1 in the picture, 0 in the margin.
};

}  // namespace sundog::denoise
