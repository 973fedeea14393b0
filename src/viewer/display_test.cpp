// SPDX-License-Identifier: Apache-2.0
#include "viewer/display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace sundog::viewer {
namespace {

Film film_of(const std::vector<std::array<float, 4>>& sums) {
    Film film(PixelRect{0, 0, static_cast<int>(sums.size()), 1});
    film.radiance = sums;
    return film;
}

std::vector<std::uint32_t> shown(const Film& film, float exposure_ev = 0, const output::ToneMapping& tone = {}) {
    std::vector<std::uint32_t> argb(film.radiance.size());
    to_display(film, {exposure_ev, tone}, argb);
    return argb;
}

// IEC 61966-2-1, written from the standard rather than taken from the code under test.
double srgb8(double linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

// Catches a wrong curve, a hole in the table, or codes off by more than one, over 40 000 values from 1e-6 to 4.
TEST(Display, EncodesSrgb) {
    std::vector<std::array<float, 4>> sums;
    for (int i = 0; i < 40000; ++i) {
        const float value = 1e-6F * std::pow(4e6F, static_cast<float>(i) / 39999);
        sums.push_back({value, value, value, 1});
    }
    const std::vector<std::uint32_t> argb = shown(film_of(sums));
    int inexact = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const int code = static_cast<int>(argb[i] & 0xff);
        const double exact = srgb8(sums[i][0]);
        ASSERT_NEAR(code, exact, 1.0) << sums[i][0];
        inexact += code != std::lround(exact);
    }
    EXPECT_LT(inexact, 400);  // within a table's step of a boundary between two codes only
}

// Catches an 8-bit picture that doesn't come back as it was: 0.5 must be 188, and the ends 0 and 255.
TEST(Display, EveryCodeComesBack) {
    for (int code = 0; code < 256; ++code) {
        const double s = code / 255.0;
        const auto linear = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
        EXPECT_EQ(shown(film_of({{linear, 0, 0, 1}}))[0], 0xff000000U | static_cast<unsigned>(code) << 16);
    }
    EXPECT_EQ(shown(film_of({{0.5F, 0.5F, 0.5F, 1}}))[0], 0xffbcbcbcU);
}

// Catches channels in the wrong order.
TEST(Display, RedIsHighest) { EXPECT_EQ(shown(film_of({{1, 0.5F, 0, 1}}))[0], 0xffffbc00U); }

// Catches sums shown instead of means, and an exposure that isn't in steps of two.
TEST(Display, MeanTimesExposure) {
    const Film film = film_of({{1, 1, 1, 8}});
    EXPECT_EQ(shown(film)[0], shown(film_of({{0.125F, 0.125F, 0.125F, 1}}))[0]);
    EXPECT_EQ(shown(film, 2)[0], 0xffbcbcbcU);
    EXPECT_FLOAT_EQ(to_image(film, {2, {}}).at(0, 0).x, 0.5F);
}

// Catches table accesses out of range: no samples, NaN, infinities, negative and huge values.
TEST(Display, OddValues) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInf = std::numeric_limits<float>::infinity();
    const auto argb = shown(film_of({{0, 0, 0, 0}, {kNan, kInf, -kInf, 1}, {-1, 1e30F, 1e-30F, 1}}));
    EXPECT_EQ(argb[0], 0xff000000U);
    EXPECT_EQ(argb[1], 0xff00ff00U);
    EXPECT_EQ(argb[2], 0xff00ff00U);
}

// Catches a window that shows other tones than the pictures saved from it, and codes in the wrong places.
TEST(Display, ShowsTheTonesThatAreSaved) {
    std::vector<std::array<float, 4>> sums;
    for (int i = 0; i < 500; ++i) {
        const auto light = 0.03F * static_cast<float>(i);
        sums.push_back({light, 2 * light, 0.5F, 2});
    }
    const Film film = film_of(sums);
    const output::ToneMapping agx{.curve = output::ToneCurve::agx, .white_balance_k = 4000.0F};
    const auto codes = output::to_srgb8(to_image(film, {1, agx}));
    const auto argb = shown(film, 1, agx);
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(static_cast<int>(argb[i] >> (16 - 8 * c) & 0xff), codes[3 * i + c], 1) << i;
}

// Catches rows or blocks that are left out: a film of a size that no block divides.
TEST(Display, CoversEveryPixel) {
    Film film(PixelRect{0, 0, 331, 47});
    for (auto& sum : film.radiance) sum = {1, 1, 1, 1};
    for (const std::uint32_t pixel : shown(film)) ASSERT_EQ(pixel, 0xffffffffU);
}

}  // namespace
}  // namespace sundog::viewer
