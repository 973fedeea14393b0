// SPDX-License-Identifier: Apache-2.0
#include "output/srgb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace sundog::output {
namespace {

std::vector<std::uint8_t> codes_of(const std::vector<Vec3>& linear) {
    std::vector<std::uint8_t> codes(linear.size() * 3);
    encode_srgb8(linear, codes);
    return codes;
}

int code_of(float linear) { return codes_of({{linear, 0, 0}})[0]; }

/// The code by the formula of IEC 61966-2-1, without tables.
int rounded_code(float linear) {
    const double v = linear;
    const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return static_cast<int>(std::lround(encoded * 255));
}

// Catches a table whose bins are wrong anywhere: a code off by one, or a brighter value with a smaller code.
TEST(Srgb, CodesAreRoundedAndMonotoneEverywhere) {
    const auto last = std::bit_cast<std::uint32_t>(1.0F);
    std::vector<Vec3> linear;
    for (std::uint32_t bits = 0; bits <= last; bits += 1021)
        linear.push_back({std::bit_cast<float>(bits), 0, std::bit_cast<float>(std::min(bits + 1, last))});
    const std::vector<std::uint8_t> codes = codes_of(linear);
    int before = 0;
    for (std::size_t i = 0; i < linear.size(); ++i) {
        ASSERT_EQ(codes[3 * i], rounded_code(linear[i].x)) << linear[i].x;
        ASSERT_GE(codes[3 * i], before);
        ASSERT_GE(codes[3 * i + 2], codes[3 * i]);
        before = codes[3 * i];
    }
    EXPECT_EQ(before, 255);
}

// Catches thresholds between two codes that lie beside the exact place, which sampling would miss.
TEST(Srgb, EachCodeBeginsAtItsThreshold) {
    for (int code = 1; code <= 255; ++code) {
        const auto threshold = static_cast<float>(linear_from_srgb((code - 0.5) / 255));
        EXPECT_EQ(code_of(threshold * (1 - 1e-6F)), code - 1);
        EXPECT_EQ(code_of(threshold * (1 + 1e-6F)), code);
    }
}

// Catches values outside 0..1 that index outside the table or wrap around, and channels that are swapped.
TEST(Srgb, OutOfRangeValuesAreClamped) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<std::uint8_t> codes =
        codes_of({{-1, 0, 2}, {nan, -nan, infinity}, {-infinity, 1e-30F, 1e30F}, {0, 0.5F, 1}});
    EXPECT_EQ(codes, (std::vector<std::uint8_t>{0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 188, 255}));
}

// Catches two directions of the transfer function that are not each other's inverse.
TEST(Srgb, EveryCodeSurvivesTheRoundTrip) {
    for (int code = 0; code < 256; ++code) EXPECT_EQ(code_of(linear_of_srgb8()[static_cast<std::size_t>(code)]), code);
}

}  // namespace
}  // namespace sundog::output
