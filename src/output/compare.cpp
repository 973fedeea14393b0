// SPDX-License-Identifier: Apache-2.0
#include "output/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "output/filter.h"
#include "output/flip.h"
#include "output/srgb.h"

namespace sundog::output {
namespace {

void require_equal_sizes(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height)
        throw std::invalid_argument("the pictures differ in size: " + std::to_string(a.width) + "x" +
                                    std::to_string(a.height) + " and " + std::to_string(b.width) + "x" +
                                    std::to_string(b.height));
    if (a.width <= 0 || a.height <= 0) throw std::invalid_argument("the pictures have no pixels");
}

/// Luma of sRGB codes, 0..1 (ITU-R BT.601, as in Wang's own program).
Plane luma_of(const std::vector<std::uint8_t>& codes, int width, int height) {
    Plane luma(width, height);
    for (std::size_t i = 0; i < luma.values.size(); ++i) {
        const auto channel = [&](std::size_t c) { return static_cast<float>(codes[3 * i + c]) / 255; };
        luma.values[i] = 0.299F * channel(0) + 0.587F * channel(1) + 0.114F * channel(2);
    }
    return luma;
}

Plane product(const Plane& a, const Plane& b) {
    Plane p(a.width, a.height);
    std::transform(a.values.begin(), a.values.end(), b.values.begin(), p.values.begin(), std::multiplies<>());
    return p;
}

/// Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", 2004,
/// section III: the mean over all places where the 11x11 window lies inside. Smaller pictures: over all pixels, with
/// the border repeated.
double mean_ssim(const Plane& a, const Plane& b) {
    constexpr int kRadius = 5;
    constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // (K1 L)^2 and (K2 L)^2 with L = 1
    const Kernel window = gaussian(1.5F, kRadius);
    const auto mean = [&](const Plane& p) { return filtered(p, window, window); };
    const Plane mean_a = mean(a), mean_b = mean(b);
    const Plane mean_aa = mean(product(a, a)), mean_bb = mean(product(b, b)), mean_ab = mean(product(a, b));
    const int margin_x = a.width > 2 * kRadius ? kRadius : 0;
    const int margin_y = a.height > 2 * kRadius ? kRadius : 0;
    double sum = 0;
    for (int y = margin_y; y < a.height - margin_y; ++y) {
        for (int x = margin_x; x < a.width - margin_x; ++x) {
            const std::size_t i = a.index(x, y);
            const double ma = mean_a.values[i], mb = mean_b.values[i];
            const double variance_a = mean_aa.values[i] - ma * ma;
            const double variance_b = mean_bb.values[i] - mb * mb;
            const double covariance = mean_ab.values[i] - ma * mb;
            sum += (2 * ma * mb + kC1) * (2 * covariance + kC2) /
                   ((ma * ma + mb * mb + kC1) * (variance_a + variance_b + kC2));
        }
    }
    return sum / (static_cast<double>(a.width - 2 * margin_x) * (a.height - 2 * margin_y));
}

/// Colours of error 0 to 1, from black by violet and red to pale yellow, ever brighter: in the manner of the map
/// "magma". sRGB codes.
Vec3 magma(float error) {
    constexpr std::array<std::array<std::uint8_t, 3>, 9> kStops{{{0, 0, 4},
                                                                 {27, 16, 69},
                                                                 {80, 18, 122},
                                                                 {129, 37, 129},
                                                                 {181, 54, 122},
                                                                 {229, 80, 100},
                                                                 {251, 135, 97},
                                                                 {254, 194, 135},
                                                                 {252, 253, 191}}};
    const float place = std::clamp(error, 0.0F, 1.0F) * static_cast<float>(kStops.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const float t = place - static_cast<float>(below);
    Vec3 linear;
    for (std::size_t c = 0; c < 3; ++c) {
        const float code =
            static_cast<float>(kStops[below][c]) * (1 - t) + static_cast<float>(kStops[below + 1][c]) * t;
        linear[c] = static_cast<float>(linear_from_srgb(code / 255));
    }
    return linear;
}

}  // namespace

Comparison compare(const Image& a, const Image& b) {
    require_equal_sizes(a, b);
    constexpr int kSeenAsEqual = 2;
    const std::vector<std::uint8_t> codes_a = to_srgb8(a), codes_b = to_srgb8(b);
    Comparison result;
    std::uint64_t sum_of_squares = 0;
    std::size_t different = 0;
    for (std::size_t i = 0; i < codes_a.size(); i += 3) {
        int largest = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            const int difference = std::abs(codes_a[c] - codes_b[c]);
            sum_of_squares += static_cast<std::uint64_t>(difference) * static_cast<std::uint64_t>(difference);
            largest = std::max(largest, difference);
        }
        result.max_difference_8bit = std::max(result.max_difference_8bit, largest);
        different += largest > kSeenAsEqual ? 1 : 0;
    }
    const auto count = static_cast<double>(codes_a.size());
    result.rmse = std::sqrt(static_cast<double>(sum_of_squares) / count) / 255;
    result.psnr_db = sum_of_squares == 0 ? std::numeric_limits<double>::infinity() : -20 * std::log10(result.rmse);
    result.different_fraction = 3 * static_cast<double>(different) / count;
    result.ssim = mean_ssim(luma_of(codes_a, a.width, a.height), luma_of(codes_b, b.width, b.height));
    const Plane errors = flip_errors(codes_a, codes_b, a.width, a.height);
    result.flip = std::accumulate(errors.values.begin(), errors.values.end(), 0.0) / (count / 3);
    return result;
}

Image difference_image(const Image& a, const Image& b, float gain) {
    require_equal_sizes(a, b);
    const std::vector<std::uint8_t> codes_a = to_srgb8(a), codes_b = to_srgb8(b);
    Image result(a.width, a.height);
    for (std::size_t i = 0; i < codes_a.size(); ++i) {
        const auto difference = static_cast<float>(std::abs(codes_a[i] - codes_b[i])) / 255;
        result.pixels[i / 3][i % 3] = static_cast<float>(linear_from_srgb(std::clamp(difference * gain, 0.0F, 1.0F)));
    }
    return result;
}

Image flip_image(const Image& a, const Image& b) {
    require_equal_sizes(a, b);
    const Plane errors = flip_errors(to_srgb8(a), to_srgb8(b), a.width, a.height);
    Image result(a.width, a.height);
    std::transform(errors.values.begin(), errors.values.end(), result.pixels.begin(), magma);
    return result;
}

}  // namespace sundog::output
