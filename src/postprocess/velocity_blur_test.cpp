// SPDX-License-Identifier: Apache-2.0
#include "postprocess/velocity_blur.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <stdexcept>

namespace sundog::postprocess {
namespace {

constexpr int kSide = 96, kMiddle = kSide / 2;

struct Picture {
    std::vector<Vec3> radiance = std::vector<Vec3>(kSide * kSide);
    std::vector<float> depth = std::vector<float>(kSide * kSide, 10.0F);
    std::vector<std::uint32_t> group = std::vector<std::uint32_t>(kSide * kSide);
    std::vector<PixelPath> path = std::vector<PixelPath>(kSide * kSide);

    [[nodiscard]] static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kSide + x); }
    [[nodiscard]] MovingPicture view() const { return {kSide, kSide, radiance, depth, group, path}; }
    [[nodiscard]] std::vector<Vec3> blurred() const { return velocity_blurred(view(), {}); }
};

/// A black wall that rests, and a white thing before or behind it from column `begin` to `end`, moving to the right by
/// `length` pixels.
Picture moving_bar(int begin, int end, float length) {
    Picture picture;
    for (int y = 0; y < kSide; ++y)
        for (int x = begin; x < end; ++x) {
            const std::size_t i = Picture::at(x, y);
            picture.radiance[i] = {1, 1, 1};
            picture.depth[i] = 5;
            picture.group[i] = 1;
            picture.path[i] = {{-length / 2, 0}, {length / 2, 0}};
        }
    return picture;
}

// Catches blurs of another length than the way, and edges that are hard on one side.
TEST(VelocityBlur, AMovingEdgeIsARampAsLongAsItsWay) {
    constexpr float kLength = 20;
    const std::vector<Vec3> out = moving_bar(kMiddle, kSide, kLength).blurred();
    for (int x = kMiddle - 16; x < kMiddle + 16; ++x) {
        const float share = std::clamp((static_cast<float>(x) + 0.5F - kMiddle) / kLength + 0.5F, 0.0F, 1.0F);
        EXPECT_NEAR(out[Picture::at(x, kMiddle)].x, share, 0.04F) << "at " << x;
    }
}

// Catches light that is lost or made by what is thinner than its way is long.
TEST(VelocityBlur, AThinThingKeepsItsLight) {
    const std::vector<Vec3> out = moving_bar(kMiddle, kMiddle + 4, 20).blurred();
    double sum = 0;
    int lit = 0;
    for (int x = 0; x < kSide; ++x) {
        const float light = out[Picture::at(x, kMiddle)].y;
        sum += light;
        lit += light > 0.01F;
        EXPECT_LT(light, 0.21F);
    }
    EXPECT_NEAR(sum, 4, 0.05);
    EXPECT_NEAR(lit, 24, 1);
}

// Catches paths that are cut straight: a thing that goes round is seen halfway off the chord.
TEST(VelocityBlur, PathsBend) {
    Picture picture;
    const std::size_t i = Picture::at(kMiddle, kMiddle);
    picture.radiance[i] = {1, 1, 1};
    picture.depth[i] = 5;
    picture.group[i] = 1;
    picture.path[i] = {{-16, 8}, {16, 8}};
    const std::vector<Vec3> out = picture.blurred();
    EXPECT_GT(out[Picture::at(kMiddle, kMiddle)].x, 0.01F);
    EXPECT_GT(out[Picture::at(kMiddle - 8, kMiddle + 2)].x, 0.005F);
    EXPECT_EQ(out[Picture::at(kMiddle, kMiddle + 8)].x, 0.0F);
}

// Catches what moves behind spreading over what rests before it, and a picture at rest changing.
TEST(VelocityBlur, WhatIsBehindStaysBehind) {
    Picture picture = moving_bar(kMiddle, kSide, 20);
    for (int y = 0; y < kSide; ++y)
        for (int x = kMiddle; x < kSide; ++x) picture.depth[Picture::at(x, y)] = 50;
    EXPECT_EQ(picture.blurred(), picture.radiance);
    Picture still = moving_bar(kMiddle, kSide, 0);
    EXPECT_EQ(still.blurred(), still.radiance);
}

// Catches a pan that darkens the picture or changes plain parts of it at the border.
TEST(VelocityBlur, APanKeepsPlainPictures) {
    Picture picture;
    picture.radiance.assign(picture.radiance.size(), {1, 2, 3});
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            picture.depth[Picture::at(x, y)] = 3 + static_cast<float>(y);
            picture.path[Picture::at(x, y)] = {{30, 5}, {-30, -5}};
        }
    for (const Vec3 pixel : picture.blurred()) EXPECT_NEAR(pixel.z, 3, 1e-3F);
}

// Catches sums whose order depends on how the picture was shared out, a stop that isn't heard, and paths that have no
// end.
TEST(VelocityBlur, ThreadsDontMatterAndStoppingIsHeard) {
    Picture picture = moving_bar(kMiddle, kSide, 20);
    for (std::size_t i = 0; i < picture.radiance.size(); ++i) picture.radiance[i].z = 1.0F / static_cast<float>(i + 1);
    for (int x = 0; x < kSide; ++x) picture.path[Picture::at(x, x)] = {{-3, -40}, {5, 44}};
    picture.path[0] = {{NAN, 0}, {INFINITY, 0}};
    const std::vector<Vec3> all = picture.blurred();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(picture.blurred(), all);
    StopFlag stop;
    stop.request();
    EXPECT_TRUE(velocity_blurred(picture.view(), stop).empty());
    picture.path.pop_back();
    EXPECT_THROW((void)picture.blurred(), std::invalid_argument);
}

}  // namespace
}  // namespace sundog::postprocess
