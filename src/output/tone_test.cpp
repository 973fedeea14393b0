// SPDX-License-Identifier: Apache-2.0
#include "output/tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/srgb.h"
#include "output/srgb.h"
#include "output/white_balance.h"

namespace sundog::output {
namespace {

constexpr std::array kCurves{ToneCurve::linear, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::agx, ToneCurve::gamma};
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

ToneMapper mapper(ToneCurve curve) { return ToneMapper({.curve = curve}); }

// Catches a curve that has a dip or a step back, tints gray, or lifts black.
TEST(Tone, GrayStaysGrayAndGrowsWithLight) {
    for (const ToneCurve curve : kCurves) {
        SCOPED_TRACE(kToneCurveNames[static_cast<std::size_t>(curve)]);
        const ToneMapper map = mapper(curve);
        EXPECT_EQ(map({0, 0, 0}), (Vec3{0, 0, 0}));
        float before = 0;
        for (float light = 1e-6F; light < 1e4F; light *= 1.01F) {
            const Vec3 shown = map({light, light, light});
            const float tolerance = curve == ToneCurve::agx ? 1e-3F : 2e-5F * std::max(shown.y, 1.0F);
            ASSERT_NEAR(shown.x, shown.y, tolerance) << light;
            ASSERT_NEAR(shown.z, shown.y, tolerance) << light;
            ASSERT_GE(shown.y, before) << light;
            before = shown.y;
        }
        EXPECT_GT(before, 0.99F) << "much light is white";
    }
}

// Catches a colour that gets darker when it gets more light.
TEST(Tone, ColorsDontGrowDarkerWithLight) {
    for (const ToneCurve curve : kCurves) {
        SCOPED_TRACE(kToneCurveNames[static_cast<std::size_t>(curve)]);
        const ToneMapper map = mapper(curve);
        for (const Vec3 color :
             {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0.5F, 0.1F}, Vec3{0.1F, 0.4F, 1}, Vec3{1, 0, 1}}) {
            float before = 0;
            for (float light = 1e-4F; light < 1e3F; light *= 1.05F) {
                const float shown = luminance(map(color * light));
                ASSERT_GE(shown, before - (curve == ToneCurve::agx ? 1e-3F : 1e-5F))
                    << color.x << " " << color.y << " " << color.z << " times " << light;
                before = shown;
            }
        }
    }
}

// Catches pixels that aren't numbers becoming white or spreading, and overflow that turns the brightest ones black.
TEST(Tone, AnyNumberGivesOneThatCanBeShown) {
    for (const ToneCurve curve : kCurves) {
        if (curve == ToneCurve::linear) continue;  // Encoders take what it leaves.
        SCOPED_TRACE(kToneCurveNames[static_cast<std::size_t>(curve)]);
        const ToneMapper map({.curve = curve, .white_balance_k = 3000.0F});
        for (const float odd : {kInfinity, -kInfinity, kNoNumber, -1.0F, 1e38F, 1e-42F})
            for (std::size_t c = 0; c < 3; ++c) {
                Vec3 color{0.2F, 0.2F, 0.2F};
                color[c] = odd;
                const Vec3 shown = map(color);
                for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(shown[i] >= 0 && shown[i] <= 1) << odd;
            }
        const ToneMapper plain = mapper(curve);
        EXPECT_EQ(plain({kNoNumber, kNoNumber, kNoNumber}), (Vec3{0, 0, 0}));
        EXPECT_GT(plain({kInfinity, kInfinity, kInfinity}).y, 0.99F);
    }
}

// Catches a picture that changes though nothing was asked for.
TEST(Tone, NothingAskedForChangesNothing) {
    EXPECT_TRUE(ToneMapper({}).changes_nothing());
    Image image(2, 1);
    image.pixels = {{0.1F, kInfinity, -3}, {7, 1e-30F, 0.5F}};
    EXPECT_EQ(tone_mapped(image, {}).pixels, image.pixels);
    EXPECT_EQ(tone_mapped(image, {.white_balance_k = 6504.0F}).pixels[1], image.pixels[1]);
}

// Catches constants that were mistyped, by values that their sources name or that follow from them by hand.
TEST(Tone, KnownValues) {
    const auto gray = [](const ToneMapping& mapping, float light) {
        return ToneMapper(mapping)({light, light, light}).y;
    };
    // Reinhard's equation 4: L (1 + L/w^2) / (1 + L).
    EXPECT_NEAR(gray({.curve = ToneCurve::reinhard, .white_point = 4}, 4), 1, 1e-6);
    EXPECT_NEAR(gray({.curve = ToneCurve::reinhard, .white_point = 2}, 1), 0.625, 1e-6);
    // Hill's curve of 1: 1.024488/1.654765.
    EXPECT_NEAR(gray({.curve = ToneCurve::aces}, 1), 0.61911, 1e-4);
    // AgX leaves middle gray where it is, as far as the polynomial goes; it is made around 0.18.
    EXPECT_NEAR(gray({.curve = ToneCurve::agx}, 0.18F), 0.18, 0.04);
    // 0.5 to the power 1/2.2 is 0.72974: that is the number which the file has to hold.
    EXPECT_NEAR(srgb_from_linear(gray({.curve = ToneCurve::gamma}, 0.5F)), 0.72974, 1e-5);
}

// Catches a curve whose name on the command line is another's.
TEST(Tone, Names) {
    for (const ToneCurve curve : kCurves)
        EXPECT_EQ(tone_curve_named(kToneCurveNames[static_cast<std::size_t>(curve)]), curve);
    EXPECT_THROW(tone_curve_named("filmic"), std::out_of_range);
}

// Catches mistyped coefficients: CIE 15:2004 has the daylight of 5003, 6504 and 7504 K (D50, D65, D75) and illuminant A
// (2856 K).
TEST(WhiteBalance, WhitesOfKnownIlluminants) {
    const auto expect = [](double kelvin, double x, double y, double tolerance) {
        const Chromaticity white = white_of_temperature(kelvin);
        EXPECT_NEAR(white.x, x, tolerance) << kelvin;
        EXPECT_NEAR(white.y, y, tolerance) << kelvin;
    };
    expect(5003, 0.34567, 0.35850, 2e-4);
    expect(6504, 0.31272, 0.32903, 1e-4);
    expect(7504, 0.29902, 0.31485, 2e-4);
    expect(2856, 0.44757, 0.40745, 5e-4);
    Chromaticity before = white_of_temperature(1667);
    for (double kelvin = 1677; kelvin < 25000; kelvin += 10) {
        const Chromaticity white = white_of_temperature(kelvin);
        ASSERT_LT(white.x, before.x + 1e-6) << kelvin;
        ASSERT_NEAR(white.x, before.x, 2e-3) << "a jump at " << kelvin;
        ASSERT_NEAR(white.y, before.y, 2e-3) << "a jump at " << kelvin;
        before = white;
    }
}

// Catches an adaptation the wrong way round, one that isn't to the screen's white, and one that changes what is right.
TEST(WhiteBalance, TheLightsWhiteBecomesWhite) {
    const auto identity = balance_matrix(6504);
    EXPECT_EQ(identity[0], (Vec3{1, 0, 0}));
    EXPECT_EQ(identity[1], (Vec3{0, 1, 0}));
    EXPECT_EQ(identity[2], (Vec3{0, 0, 1}));
    for (const double kelvin : {2000.0, 2856.0, 4500.0, 5003.0, 6400.0, 9000.0, 20000.0}) {
        SCOPED_TRACE(kelvin);
        const Chromaticity white = white_of_temperature(kelvin);
        const double x = white.x / white.y, z = (1 - white.x - white.y) / white.y;
        const Vec3 lamp{static_cast<float>(3.2409699 * x - 1.5373832 - 0.4986108 * z),
                        static_cast<float>(-0.9692436 * x + 1.8759675 + 0.0415551 * z),
                        static_cast<float>(0.0556301 * x - 0.2039770 + 1.0569715 * z)};
        const auto rows = balance_matrix(kelvin);
        for (const Vec3& row : rows) EXPECT_NEAR(dot(row, lamp), 1, 2e-3);
    }
    const auto warm = balance_matrix(3000);
    const Vec3 one{1, 1, 1};
    EXPECT_GT(dot(warm[2], one), dot(warm[0], one)) << "under a warm lamp's balance white is bluish";
}

}  // namespace
}  // namespace sundog::output
