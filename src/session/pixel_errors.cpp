// SPDX-License-Identifier: Apache-2.0
#include "session/pixel_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "session/error_driven.h"

namespace sundog {
namespace {

/// The 97.5% quantile of Student's t with `freedom` degrees of freedom, by Hill's expansion around the normal one
/// (Abramowitz and Stegun, 26.7.5); off by less than 1% from 3 degrees on.
float t_quantile(float freedom) {
    constexpr float kZ = 1.959964F;
    constexpr float kZ3 = kZ * kZ * kZ, kZ5 = kZ3 * kZ * kZ, kZ7 = kZ5 * kZ * kZ;
    const float n = freedom;
    return kZ + (kZ3 + kZ) / (4 * n) + (5 * kZ5 + 16 * kZ3 + 3 * kZ) / (96 * n * n) +
           (3 * kZ7 + 19 * kZ5 + 17 * kZ3 - 15 * kZ) / (384 * n * n * n);
}

/// Square roots' slope is cut off below this: 1/400 of white, where sRGB's own curve grows straight.
constexpr float kDarkest = 0.0025F;

}  // namespace

PixelErrors::PixelErrors(const PixelRect& bounds, float gain)
    : width_(static_cast<std::size_t>(bounds.width())),
      height_(static_cast<std::size_t>(bounds.height())),
      gain_(gain),
      pixels_(width_ * height_),
      errors_(pixels_.size(), std::numeric_limits<float>::infinity()) {}

void PixelErrors::add_blocks(const Film& film, std::span<const std::uint32_t> pixels) {
    for (const std::uint32_t i : pixels) {
        Pixel& pixel = pixels_[i];
        const std::array<float, 4>& sum = film.radiance[i];
        if (sum == pixel.film) continue;  // Nothing came: the work was stopped before.
        const float weight = sum[3] - pixel.film[3];
        const auto number = static_cast<float>(++pixel.blocks);
        for (std::size_t c = 0; c < 3; ++c) {
            const float block = (sum[c] - pixel.film[c]) / weight;
            const float step = block - pixel.mean[c];  // Welford, Technometrics 1962
            pixel.mean[c] += step / number;
            pixel.squares[c] += step * (block - pixel.mean[c]);
        }
        pixel.film = sum;
        errors_[i] = error_of(pixel);
    }
}

float PixelErrors::error_of(const Pixel& pixel) const {
    if (pixel.blocks < kFewestBlocks) return std::numeric_limits<float>::infinity();
    const auto number = static_cast<float>(pixel.blocks);
    const float scale = t_quantile(number - 1) * gain_ / std::sqrt(number * (number - 1));
    float worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const float half_width = std::sqrt(pixel.squares[c]) * scale;
        const float mean = pixel.mean[c] * gain_;
        if (mean - half_width > 1) continue;
        worst = std::max(worst, half_width / (2 * std::sqrt(std::max(mean, kDarkest))));
    }
    return worst;
}

std::vector<Vec3> PixelErrors::variances() const {
    std::vector<Vec3> out;
    out.reserve(pixels_.size());
    for (const Pixel& pixel : pixels_) {
        const auto number = static_cast<float>(pixel.blocks);
        Vec3 variance;
        for (std::size_t c = 0; c < 3; ++c)
            variance[c] = pixel.blocks < 2 ? pixel.mean[c] * pixel.mean[c] : pixel.squares[c] / (number * (number - 1));
        out.push_back(variance);
    }
    return out;
}

float PixelErrors::error_around(std::size_t pixel) const {
    const std::size_t x = pixel % width_, y = pixel / width_;
    float worst = 0;
    for (std::size_t row = y > 0 ? y - 1 : 0; row <= std::min(y + 1, height_ - 1); ++row)
        for (std::size_t column = x > 0 ? x - 1 : 0; column <= std::min(x + 1, width_ - 1); ++column)
            worst = std::max(worst, errors_[row * width_ + column]);
    return worst;
}

}  // namespace sundog
