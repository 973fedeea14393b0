// SPDX-License-Identifier: Apache-2.0
#include "postprocess/lens_blur.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace sundog::postprocess {
namespace {

constexpr int kSide = 65, kMiddle = kSide / 2;
constexpr ThinLens kLens{100, 10};  ///< A blur of -10 at infinity, of 10 at depth 5.

struct Picture {
    std::vector<Vec3> radiance = std::vector<Vec3>(kSide * kSide);
    std::vector<float> depth = std::vector<float>(kSide * kSide, kLens.focus);

    [[nodiscard]] static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kSide + x); }
    [[nodiscard]] std::vector<Vec3> blurred(Spread spread) const {
        return lens_blurred({kSide, kSide, radiance, depth}, kLens, spread, {});
    }
};

/// Sum of light, mean squared distance from the middle in one direction, and the farthest that gets any.
struct Spot {
    double sum = 0, moment = 0, reach = 0;
};

Spot spot_of(const std::vector<Vec3>& picture) {
    Spot spot;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double light = picture[Picture::at(x, y)].y;
            const double dx = x - kMiddle, dy = y - kMiddle;
            spot.sum += light;
            spot.moment += light * (dx * dx + dy * dy) / 2;
            if (light > 0) spot.reach = std::max(spot.reach, std::hypot(dx, dy));
        }
    spot.moment /= spot.sum;
    return spot;
}

// Catches discs of another radius than the lens's, and light that is lost or made.
TEST(LensBlur, APointBecomesADiscOfTheLensesRadius) {
    for (const float depth : {5.0F, 8.0F, 20.0F, std::numeric_limits<float>::infinity()}) {
        Picture picture;
        picture.depth.assign(picture.depth.size(), depth);
        picture.radiance[Picture::at(kMiddle, kMiddle)] = {0, 3, 0};
        const double radius = std::abs(100.0 / depth - 10.0);
        EXPECT_NEAR(std::abs(signed_blur_px(kLens, depth)), radius, 1e-4);
        const Spot disc = spot_of(picture.blurred(Spread::disc));
        EXPECT_NEAR(disc.sum, 3, 1e-4);
        EXPECT_NEAR(disc.reach, radius, 0.75);
        EXPECT_NEAR(disc.moment, radius * radius / 4, 0.03 * radius * radius + 0.1);
        const Spot gaussian = spot_of(picture.blurred(Spread::gaussian));
        EXPECT_NEAR(gaussian.sum, 3, 1e-4);
        EXPECT_NEAR(gaussian.moment, radius * radius / 4, 0.01 * radius * radius);
    }
}

// Catches what is in focus losing its sharpness, and plane pictures gaining an edge at their border.
TEST(LensBlur, WhatIsInFocusAndWhatIsPlainStays) {
    Picture sharp;
    for (std::size_t i = 0; i < sharp.radiance.size(); ++i) sharp.radiance[i] = {i % 2 ? 1.0F : 0.0F, 0, 0.5F};
    EXPECT_EQ(sharp.blurred(Spread::disc), sharp.radiance);
    Picture plain;
    plain.radiance.assign(plain.radiance.size(), {1, 2, 3});
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            plain.depth[Picture::at(x, y)] = x < 30 ? 5.0F : 4.0F + 0.3F * static_cast<float>(y);
    for (const Spread spread : {Spread::disc, Spread::gaussian})
        for (const Vec3 pixel : plain.blurred(spread)) {
            EXPECT_NEAR(pixel.x, 1, 1e-4);
            EXPECT_NEAR(pixel.z, 3, 3e-4);
        }
}

/// Black at `left_depth` in the left half, white at `right_depth` in the right one.
Picture halves(float left_depth, float right_depth) {
    Picture picture;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            picture.depth[Picture::at(x, y)] = x < kMiddle ? left_depth : right_depth;
            if (x >= kMiddle) picture.radiance[Picture::at(x, y)] = {1, 1, 1};
        }
    return picture;
}

// Catches light from far behind on what is sharp before it.
TEST(LensBlur, FarThingsDontSpreadOverSharpOnes) {
    const std::vector<Vec3> out = halves(10, std::numeric_limits<float>::infinity()).blurred(Spread::disc);
    for (int x = 0; x < kSide; ++x)
        EXPECT_NEAR(out[Picture::at(x, kMiddle)].x, x < kMiddle ? 0 : 1, 1e-3) << "at " << x;
}

// Catches near things with a hard edge, on either side of it: the share of a disc that is beyond a straight edge.
TEST(LensBlur, NearThingsSpreadOverSharpOnesLikeADisc) {
    constexpr double kRadius = 10, kPi64 = 3.14159265358979323846;
    const std::vector<Vec3> out = halves(10, 5).blurred(Spread::disc);
    for (int x = kMiddle - 14; x < kMiddle + 14; ++x) {
        const double s = std::clamp((x + 0.5 - kMiddle) / kRadius, -1.0, 1.0);
        const double share = 0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / kPi64;
        EXPECT_NEAR(out[Picture::at(x, kMiddle)].x, share, 0.03) << "at " << x;
    }
}

// Catches sums whose order depends on how the picture was shared out, and a stop that isn't heard.
TEST(LensBlur, ThreadsDontMatterAndStoppingIsHeard) {
    Picture picture = halves(4, 30);
    for (std::size_t i = 0; i < picture.radiance.size(); ++i) picture.radiance[i].z = 1.0F / static_cast<float>(i + 1);
    const std::vector<Vec3> all = picture.blurred(Spread::gaussian);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(picture.blurred(Spread::gaussian), all);
    StopFlag stop;
    stop.request();
    EXPECT_TRUE(lens_blurred({kSide, kSide, picture.radiance, picture.depth}, kLens, Spread::disc, stop).empty());
    EXPECT_THROW(lens_blurred({kSide, kSide, picture.radiance, {}}, kLens, Spread::disc, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sundog::postprocess
