// SPDX-License-Identifier: Apache-2.0
#include "denoise/tile_filter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace sundog::denoise {
namespace {

constexpr int kSide = kTileSide;
constexpr int kWide = kSide + 2 * kPatch;

/// How different patches may be, in squares of their noise (k^2 of Rousselle and others 2012).
constexpr float kNoise2 = 0.25F;
constexpr float kLeastNoise = 1e-7F;  // For variances of 0: what differs by less is the same.
/// How different normals may be: about 13 degrees make a weight of a third.
constexpr float kNormal2 = 0.05F;
/// How far off the surface's tangent plane neighbours may lie, as a share of their distance from the eye.
constexpr float kNearness2 = 0.02F * 0.02F;

/// What is regressed on: 1, position (2), normal (3).
constexpr int kTerms = 6;
constexpr int kProducts = kTerms * (kTerms + 1) / 2;

using TileRow = std::array<float, kSide>;
using TilePlane = std::array<float, kTilePixels>;

/// Weighted sums, of each pixel of a tile.
struct Sums {
    std::array<TilePlane, kProducts> products;            // of terms: the upper half of a matrix, row by row
    std::array<std::array<TilePlane, 3>, kTerms> values;  // of terms and channels
};

/// About exp(-d), 0 from 4 on.
float weight_of(float d) {
    const float t = std::max(1 - 0.25F * std::max(d, 0.0F), 0.0F);
    return t * t * t * t;
}

/// Mean distance of the patches around each pixel from those at an offset, in squares of their noise.
void patch_distances(const Light& light, std::ptrdiff_t first, std::ptrdiff_t offset, int stride, TilePlane& out) {
    std::array<float, std::size_t{kWide} * kWide> single;
    std::array<float, std::size_t{kSide} * kWide> rows;
    const float* const r = light.channels[0].data();
    const float* const g = light.channels[1].data();
    const float* const b = light.channels[2].data();
    const float* const v = light.variance.data();
    for (int y = 0; y < kWide; ++y) {
        const std::ptrdiff_t p = first + static_cast<std::ptrdiff_t>(y - kPatch) * stride - kPatch;
        const std::ptrdiff_t q = p + offset;
        float* const to = single.data() + static_cast<std::ptrdiff_t>(y) * kWide;
        for (int x = 0; x < kWide; ++x) {
            const float dr = r[p + x] - r[q + x], dg = g[p + x] - g[q + x], db = b[p + x] - b[q + x];
            const float vp = v[p + x], vq = v[q + x];
            to[x] = (dr * dr + dg * dg + db * db - vp - std::min(vp, vq)) / (kLeastNoise + kNoise2 * (vp + vq));
        }
    }
    for (int y = 0; y < kWide; ++y) {
        const float* const from = single.data() + static_cast<std::ptrdiff_t>(y) * kWide;
        float* const to = rows.data() + static_cast<std::ptrdiff_t>(y) * kSide;
        for (int x = 0; x < kSide; ++x) {
            float sum = from[x];
            for (int i = 1; i <= 2 * kPatch; ++i) sum += from[x + i];
            to[x] = sum;
        }
    }
    constexpr float kShare = 1.0F / ((2 * kPatch + 1) * (2 * kPatch + 1));
    for (int y = 0; y < kSide; ++y) {
        const float* const from = rows.data() + static_cast<std::ptrdiff_t>(y) * kSide;
        float* const to = out.data() + static_cast<std::ptrdiff_t>(y) * kSide;
        for (int x = 0; x < kSide; ++x) {
            float sum = from[x];
            for (int i = 1; i <= 2 * kPatch; ++i) sum += from[x + static_cast<std::ptrdiff_t>(i) * kSide];
            to[x] = sum * kShare;
        }
    }
}

/// Adds the pixels at one offset to a row's sums.
class RowAdder {
public:
    RowAdder(const Light& light, const Guides& guides, std::ptrdiff_t p, std::ptrdiff_t offset, int dx, int dy)
        : p_(p),
          q_(p + offset),
          dx_(static_cast<float>(dx)),
          dy_(static_cast<float>(dy)),
          light_(light),
          guides_(guides) {}

    /// Weights from patches' distances and guides; false if all are 0.
    bool weigh(const float* distances) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float* const n = guides_.normal[c].data();
            for (int x = 0; x < kSide; ++x) normal_[c][static_cast<std::size_t>(x)] = n[q_ + x] - n[p_ + x];
        }
        const float* const near = guides_.nearness.data();
        const float* const slope_x = guides_.slope_x.data();
        const float* const slope_y = guides_.slope_y.data();
        const float* const inside = guides_.inside.data();
        float sum = 0;
        for (int x = 0; x < kSide; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const float turned =
                normal_[0][i] * normal_[0][i] + normal_[1][i] * normal_[1][i] + normal_[2][i] * normal_[2][i];
            const float off = near[q_ + x] - near[p_ + x] - slope_x[p_ + x] * dx_ - slope_y[p_ + x] * dy_;
            const float scale = std::max(near[p_ + x], near[q_ + x]);
            const float apart = off * off / (kNearness2 * scale * scale + 1e-12F);
            const float guided = weight_of(turned * (1 / kNormal2) + apart);
            weight_[i] = std::min(weight_of(distances[x]), guided) * inside[q_ + x];
            sum += weight_[i];
        }
        return sum > 0;
    }

    void add(Sums& sums, std::size_t row) const {
        constexpr float kUnit = 1.0F / kReach;
        const float x = dx_ * kUnit, y = dy_ * kUnit;
        std::array<TileRow, kTerms> weighted;
        for (std::size_t i = 0; i < kSide; ++i) {
            weighted[0][i] = weight_[i];
            weighted[1][i] = weight_[i] * x;
            weighted[2][i] = weight_[i] * y;
            for (std::size_t c = 0; c < 3; ++c) weighted[3 + c][i] = weight_[i] * normal_[c][i];
        }
        std::size_t product = 0;
        for (std::size_t a = 0; a < kTerms; ++a) {
            add(sums.products[product++], row, weighted[a], a);
            for (std::size_t b = a + 1; b < kTerms; ++b) add(sums.products[product++], row, weighted[a], b);
            for (std::size_t c = 0; c < 3; ++c) {
                const float* const value = light_.channels[c].data() + q_;
                float* const to = sums.values[a][c].data() + row;
                for (std::size_t i = 0; i < kSide; ++i) to[i] += weighted[a][i] * value[i];
            }
        }
    }

private:
    /// Adds weights times term `b`.
    void add(TilePlane& plane, std::size_t row, const TileRow& weighted, std::size_t b) const {
        constexpr float kUnit = 1.0F / kReach;
        float* const to = plane.data() + row;
        if (b == 0) {
            for (std::size_t i = 0; i < kSide; ++i) to[i] += weighted[i];
        } else if (b < 3) {
            const float term = (b == 1 ? dx_ : dy_) * kUnit;
            for (std::size_t i = 0; i < kSide; ++i) to[i] += weighted[i] * term;
        } else {
            const TileRow& term = normal_[b - 3];
            for (std::size_t i = 0; i < kSide; ++i) to[i] += weighted[i] * term[i];
        }
    }

    std::ptrdiff_t p_, q_;
    float dx_, dy_;
    const Light& light_;
    const Guides& guides_;
    TileRow weight_{};
    std::array<TileRow, 3> normal_{};
};

/// Solves the regression of one pixel for its own value, by Cholesky's decomposition. `penalty`: what steepness costs.
std::array<float, 3> solved(const Sums& sums, std::size_t pixel, float penalty) {
    std::array<std::array<float, kTerms>, kTerms> l{};
    std::size_t product = 0;
    for (std::size_t a = 0; a < kTerms; ++a)
        for (std::size_t b = a; b < kTerms; ++b) l[b][a] = sums.products[product++][pixel];
    // A position's step is the window's reach, over which light changes less than over a normal's.
    for (std::size_t a = 1; a < kTerms; ++a) l[a][a] += a < 3 ? 20 * penalty : 2 * penalty;
    std::array<std::array<float, 3>, kTerms> y{};
    // Terms in reverse order: what is asked for, the constant one, is then known without going back.
    const auto order = [](std::size_t i) { return kTerms - 1 - i; };
    const auto entry = [&](std::size_t i, std::size_t j) {
        const std::size_t a = order(i), b = order(j);
        return a >= b ? l[a][b] : l[b][a];
    };
    std::array<std::array<float, kTerms>, kTerms> c{};
    for (std::size_t i = 0; i < kTerms; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            float sum = entry(i, j);
            for (std::size_t k = 0; k < j; ++k) sum -= c[i][k] * c[j][k];
            c[i][j] = i == j ? std::sqrt(std::max(sum, 1e-6F)) : sum / c[j][j];
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            float sum = sums.values[order(i)][channel][pixel];
            for (std::size_t k = 0; k < i; ++k) sum -= c[i][k] * y[k][channel];
            y[i][channel] = sum / c[i][i];
        }
    }
    constexpr std::size_t kLast = kTerms - 1;
    return {y[kLast][0] / c[kLast][kLast], y[kLast][1] / c[kLast][kLast], y[kLast][2] / c[kLast][kLast]};
}

}  // namespace

void filter_tile(const Light& light, const Guides& guides, const Layout& layout, int tile_x, int tile_y,
                 TileLight& out) {
    const auto sums = std::make_unique<Sums>();
    const std::ptrdiff_t first = layout.at(tile_x * kSide, tile_y * kSide);
    TilePlane distances;
    for (int dy = -kReach; dy <= kReach; ++dy)
        for (int dx = -kReach; dx <= kReach; ++dx) {
            const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(dy) * layout.stride + dx;
            const bool self = dx == 0 && dy == 0;
            if (self) distances.fill(0);
            else patch_distances(light, first, offset, layout.stride, distances);
            for (int y = 0; y < kSide; ++y) {
                RowAdder row(light, guides, first + static_cast<std::ptrdiff_t>(y) * layout.stride, offset, dx, dy);
                const auto at = static_cast<std::size_t>(y) * kSide;
                if (row.weigh(distances.data() + at)) row.add(*sums, at);
            }
        }
    for (std::size_t y = 0; y < kSide; ++y)
        for (std::size_t x = 0; x < kSide; ++x) {
            const std::ptrdiff_t p =
                first + static_cast<std::ptrdiff_t>(y) * layout.stride + static_cast<std::ptrdiff_t>(x);
            const auto at = [p](const Plane& plane) { return plane[static_cast<std::size_t>(p)]; };
            const std::size_t pixel = y * kSide + x;
            if (at(guides.inside) == 0) continue;  // Beyond the picture's edge.
            float light2 = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const float mean = sums->values[0][c][pixel] / std::max(sums->products[0][pixel], 1e-6F);
                light2 += mean * mean;
            }
            // Steepness is believed as far as the noise is small beside the light.
            constexpr float kLeastPenalty = 1e-3F;
            const float penalty = kLeastPenalty + at(light.variance) / (light2 + 1e-8F);
            const std::array<float, 3> value = solved(*sums, pixel, penalty);
            for (std::size_t c = 0; c < 3; ++c) out[c][pixel] = std::max(value[c], 0.0F);
        }
}

}  // namespace sundog::denoise
