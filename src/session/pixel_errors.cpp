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

/// The largest of each value and its two neighbours in a row or column of `count`, `stride` apart.
void spread_largest(float* values, std::size_t count, std::size_t stride) {
    float before = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float here = values[i * stride];
        const float after = i + 1 < count ? values[(i + 1) * stride] : 0;
        values[i * stride] = std::max({before, here, after});
        before = here;
    }
}

}  // namespace

PixelErrors::PixelErrors(const PixelRect& bounds, float gain)
    : width_(bounds.width()),
      height_(bounds.height()),
      gain_(gain),
      pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

void PixelErrors::add_blocks(const Film& film, const std::vector<std::uint8_t>& marks) {
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        if (marks[i] == 0) continue;
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
    }
}

float PixelErrors::error(std::size_t i) const {
    const Pixel& pixel = pixels_[i];
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

std::vector<float> PixelErrors::errors_around() const {
    std::vector<float> errors(pixels_.size());
    for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = error(i);
    const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    for (std::size_t y = 0; y < height; ++y) spread_largest(&errors[y * width], width, 1);
    for (std::size_t x = 0; x < width; ++x) spread_largest(&errors[x], height, width);
    return errors;
}

}  // namespace sundog
