// SPDX-License-Identifier: Apache-2.0
// Grid refinement: a tile's picture from few of its rays. Freestanding.
//
// Squares whose four corners agree in what they remember (PointRecord) are filled by bilinear interpolation; others are
// divided in four, down to single pixels. Where the eye sees a textured surface, what lights it is interpolated and the
// texture looked up for each pixel.
#pragma once

#include "sampling/traced_grid.h"

namespace sundog::sampling {

/// Refines one tile at a time. Large: it doesn't belong on a stack of unknown size.
///
/// A Tracer has
///   void trace(const TilePlace* places, int count, PointRecord* records)
/// and, if its surfaces are textured,
///   void look(const TilePlace* places, int count, SurfaceLook* looks)  at most kSquareSide^2 places
/// Places may lie one pixel outside of the tile and up to kSquareSide outside of the picture.
class GridRefinement {
public:
    /// Makes the pixels of a tile; returns how many points it traced. `finest`: for each of the tile's squares, row by
    /// row, `finest_stride` from one row to the next, the side down to which it is divided whatever the corners say
    /// (kSquareSide: where they disagree; 1: all pixels are traced); null: kSquareSide for all.
    template <class Tracer>
    int refine(Tracer& tracer, const TilePixels& pixels, const RefinementQuality& quality,
               const std::uint8_t* finest = nullptr, std::ptrdiff_t finest_stride = kSquaresAcross) {
        grid_.clear();
        looked_count_ = 0;
        int count = 0;
        // Along a Z curve, so that points that are traced one after the other lie close together.
        for (int i = 0; i < kSquaresAcross * kSquaresAcross; ++i) {
            const int x = every_second_bit(i) * kSquareSide, y = every_second_bit(i / 2) * kSquareSide;
            if (x >= pixels.width || y >= pixels.height) continue;
            squares_[0][count++] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)};
            want_corners(x, y, kSquareSide);
        }
        int list = 0;
        for (int step = kSquareSide; step > 1; step /= 2, list = 1 - list) {
            grid_.trace_wanted(tracer, quality, pixels);
            const int half = step / 2;
            int children = 0;
            TilePlace* const divided = squares_[1 - list];
            for (int i = 0; i < count; ++i) {
                const TilePlace at = squares_[list][i];
                const bool forced =
                    finest != nullptr && step > finest[at.y / kSquareSide * finest_stride + at.x / kSquareSide];
                if (!forced &&
                    (step > 2 ? grid_.agree(at.x, at.y, step, quality) : grid_.agree_softly(at.x, at.y, quality))) {
                    if (grid_.surface(at.x, at.y) != 0)
                        looked_[looked_count_++] = {at, static_cast<std::uint8_t>(step)};
                    else fill(at, step, pixels);
                    continue;
                }
                want_between(at.x, at.y, half);
                if (half == 1) continue;
                for (int child = 0; child < 4; ++child)
                    divided[children++] = {static_cast<std::uint8_t>(at.x + child % 2 * half),
                                           static_cast<std::uint8_t>(at.y + child / 2 * half)};
            }
            count = children;
        }
        grid_.trace_wanted(tracer, quality, pixels);
        if constexpr (requires { tracer.look(looked_places_, 0, looks_); }) {
            for (int i = 0; i < looked_count_; ++i) look(looked_[i], tracer, pixels);
            grid_.trace_wanted(tracer, quality, pixels);
        }
        return grid_.traced_count();
    }

private:
    struct LookedSquare {
        TilePlace at;
        std::uint8_t step;
    };

    void want_corners(int x, int y, int step) {
        for (int corner = 0; corner < 4; ++corner) grid_.want(x + corner % 2 * step, y + corner / 2 * step);
    }
    /// The five points that divide a square of side 2*half in four.
    void want_between(int x, int y, int half) {
        grid_.want(x + half, y);
        grid_.want(x, y + half);
        grid_.want(x + half, y + half);
        grid_.want(x + 2 * half, y + half);
        grid_.want(x + half, y + 2 * half);
    }

    static constexpr int every_second_bit(int i) { return (i & 1) | (i >> 1 & 2) | (i >> 2 & 4); }
    static_assert(kSquaresAcross == 8);

    /// Interpolates a square's pixels but those that are traced themselves, and but its right and lower sides, which
    /// belong to its neighbours.
    void fill(TilePlace at, int step, const TilePixels& pixels) const {
        const float part = 1.0F / static_cast<float>(step);
        const auto corner = [&](int x, int y) {
            Float4 light = grid_.light(x, y);
            light[3] = 1;
            return light;
        };
        const Float4 first = corner(at.x, at.y), second = corner(at.x + step, at.y);
        const Float4 left_slope = (corner(at.x, at.y + step) - first) * part;
        const Float4 right_slope = (corner(at.x + step, at.y + step) - second) * part;
        const int columns = at.x + step < pixels.width ? step : pixels.width - at.x;
        const int rows = at.y + step < pixels.height ? step : pixels.height - at.y;
        for (int row = 0; row < rows; ++row) {
            const auto down = static_cast<float>(row);
            const Float4 left = first + left_slope * down;
            const Float4 slope = (second + right_slope * down - left) * part;
            StoredFloat4* const line = pixels.row(at.y + row) + at.x;
            // Inside of the square nothing has been traced.
            for (int column = 0; column < columns; ++column) {
                if ((row == 0 || column == 0) && grid_.is_wanted(at.x + column, at.y + row)) continue;
                line[column] = left + slope * static_cast<float>(column);
            }
        }
    }

    /// The same for a square whose surface is textured; pixels that turn out to see something else are traced.
    template <class Tracer>
    void look(const LookedSquare& square, Tracer& tracer, const TilePixels& pixels) {
        const TilePlace at = square.at;
        const int step = square.step;
        TilePlace* const places = looked_places_;
        SurfaceLook* const looks = looks_;
        int count = 0;
        for (int y = at.y; y < at.y + step && y < pixels.height; ++y)
            for (int x = at.x; x < at.x + step && x < pixels.width; ++x)
                if (!grid_.is_wanted(x, y))
                    places[count++] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)};
        const float part = 1.0F / static_cast<float>(step);
        for (int i = 0; i < count; ++i) {
            const float u = static_cast<float>(places[i].x - at.x) * part;
            const float v = static_cast<float>(places[i].y - at.y) * part;
            looks[i].shade = between(at, step, u, v, true);
            looks[i].light = between(at, step, u, v, false);
        }
        tracer.look(places, count, looks);
        const std::uint32_t surface = grid_.surface(at.x, at.y);
        for (int i = 0; i < count; ++i) {
            if (looks[i].surface != surface) grid_.want(places[i].x, places[i].y);
            else pixels.row(places[i].y)[places[i].x] = looks[i].whole;
        }
    }

    /// `shade` or `light` in a square, at (u, v) of it.
    [[nodiscard]] Float4 between(TilePlace at, int step, float u, float v, bool shade) const {
        const auto corner = [&](int x, int y) { return shade ? grid_.shade(x, y) : grid_.light(x, y); };
        const Float4 a = corner(at.x, at.y), b = corner(at.x + step, at.y);
        const Float4 c = corner(at.x, at.y + step), d = corner(at.x + step, at.y + step);
        const Float4 above = a + (b - a) * u, below = c + (d - c) * u;
        return above + (below - above) * v;
    }

    static constexpr int kSquares = kRefinedTileSide * kRefinedTileSide / 4;  // of side 2
    TracedGrid grid_;
    TilePlace squares_[2][kSquares];
    LookedSquare looked_[kSquares];
    int looked_count_ = 0;
    TilePlace looked_places_[kSquareSide * kSquareSide];
    SurfaceLook looks_[kSquareSide * kSquareSide];
};

}  // namespace sundog::sampling
