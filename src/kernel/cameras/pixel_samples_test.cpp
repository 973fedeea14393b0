// SPDX-License-Identifier: Apache-2.0
#include "kernel/cameras/pixel_samples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace sundog::kernel {
namespace {

/// The filters' values by their papers' formulas, in double precision, at x radii from the middle; 1 or so there.
double filter_value(uint pixel_filter, double x) {
    constexpr double kPi = std::numbers::pi;
    const double a = std::abs(x);
    if (a > 1) return 0;
    switch (pixel_filter) {
        case FILTER_TENT:
            return 1 - a;
        case FILTER_GAUSSIAN:
            return std::exp(-0.5 * 9 * a * a);
        case FILTER_MITCHELL: {
            const double y = 2 * a;
            return y < 1 ? (7 * y * y * y - 12 * y * y + 16.0 / 3) / 6
                         : (-7.0 / 3 * y * y * y + 12 * y * y - 20 * y + 32.0 / 3) / 6;
        }
        case FILTER_BLACKMAN_HARRIS:
            return 0.35875 + 0.48829 * std::cos(kPi * a) + 0.14128 * std::cos(2 * kPi * a) +
                   0.01168 * std::cos(3 * kPi * a);
        default:
            return 1;
    }
}

// Catches a wrong integral, a wrong inverse or a wrong sign: the weighted histogram of places is the filter itself.
TEST(PixelSamples, AreDistributedAsTheFilter) {
    constexpr int kBins = 40, kSamples = 1 << 14;
    for (uint filter = FILTER_BOX; filter <= FILTER_BLACKMAN_HARRIS; ++filter) {
        std::array<double, kBins> across{}, down{};
        double all = 0;
        for (uint i = 0; i < kSamples; ++i) {
            const PixelSample at = pixel_sample({SAMPLES_SOBOL, 0, filter, 2.0F}, 17, 4, i);
            ASSERT_GE(at.x, 0.5F - 2.0F);
            ASSERT_LE(at.x, 0.5F + 2.0F);
            const auto bin = [](float place) {
                return static_cast<std::size_t>(std::fmin((place + 1.5F) / 4 * kBins, kBins - 1));
            };
            across[bin(at.x)] += at.weight;
            down[bin(at.y)] += at.weight;
            all += at.weight;
        }
        EXPECT_NEAR(all / kSamples, 1, 2e-3) << filter;
        double integral = 0;
        constexpr int kSteps = 100;
        std::array<double, kBins> exact{};
        for (int i = 0; i < kBins * kSteps; ++i) {
            const double value = filter_value(filter, (i + 0.5) / (kBins * kSteps) * 2 - 1);
            exact[static_cast<std::size_t>(i / kSteps)] += value;
            integral += value;
        }
        for (std::size_t bin = 0; bin < kBins; ++bin) {
            EXPECT_NEAR(across[bin] / all, exact[bin] / integral, 1.5e-3) << filter << ' ' << bin;
            EXPECT_NEAR(down[bin] / all, exact[bin] / integral, 1.5e-3) << filter << ' ' << bin;
        }
    }
}

// Catches scrambling that isn't Owen's, or direction numbers that are wrong: each block of 2^(a+b) samples has one in
// each of the 2^a by 2^b boxes that divide the pixel, for all a and b.
TEST(PixelSamples, SobolFillsEveryElementaryBox) {
    for (uint pixel = 0; pixel < 50; ++pixel)
        for (uint a = 0; a <= 6; ++a) {
            const uint b = 6 - a;
            std::set<std::pair<int, int>> boxes;
            for (uint i = 0; i < 64; ++i) {
                const PixelSample at = pixel_sample({SAMPLES_SOBOL, 0, FILTER_PIXEL, 0}, pixel, 3 * pixel, 64 + i);
                boxes.insert({static_cast<int>(at.x * std::exp2(static_cast<float>(a))),
                              static_cast<int>(at.y * std::exp2(static_cast<float>(b)))});
            }
            ASSERT_EQ(boxes.size(), 64U) << pixel << ' ' << a;
        }
}

// Catches blocks that repeat each other (their spread would tell nothing of the error), and pixels that do.
TEST(PixelSamples, BlocksAndPixelsAreIndependent) {
    const PixelSampling sampling{SAMPLES_SOBOL, 4, FILTER_PIXEL, 0};
    std::set<std::pair<float, float>> places;
    for (uint y = 0; y < 8; ++y)
        for (uint x = 0; x < 8; ++x)
            for (uint i = 0; i < 64; ++i) {
                const PixelSample at = pixel_sample(sampling, x, y, i);
                places.insert({at.x, at.y});
            }
    EXPECT_GE(places.size(), 8U * 8 * 64 - 2);
    double mean = 0;
    for (const auto& [x, y] : places) mean += x;
    EXPECT_NEAR(mean / static_cast<double>(places.size()), 0.5, 0.01);
}

// Catches samples outside of their cell, cells left out, and jitter that is the same everywhere.
TEST(PixelSamples, GridsHaveOneSampleACell) {
    for (const uint pattern : {SAMPLES_REGULAR, SAMPLES_JITTERED}) {
        std::set<int> cells;
        std::set<float> places;
        for (uint i = 0; i < 25; ++i) {
            const PixelSample at = pixel_sample({pattern, 5, FILTER_PIXEL, 0}, 9, 2, i);
            cells.insert(static_cast<int>(at.y * 5) * 5 + static_cast<int>(at.x * 5));
            places.insert(at.x * 5 - std::floor(at.x * 5));
        }
        EXPECT_EQ(cells.size(), 25U);
        if (pattern == SAMPLES_JITTERED) {
            EXPECT_GT(places.size(), 20U);
        }
    }
    EXPECT_EQ(pixel_sample({SAMPLES_R2, 0, FILTER_PIXEL, 0}, 3, 3, 0).x, 0.5F);
}

}  // namespace
}  // namespace sundog::kernel
