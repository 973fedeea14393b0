// SPDX-License-Identifier: Apache-2.0
#include "session/eye_hits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sundog {
namespace {

constexpr std::uint32_t kWidth = 80, kHeight = 60;

/// Looks along +Y from the origin, 90 degrees high.
Frame frame_of() {
    Frame frame;
    frame.params.width = kWidth;
    frame.params.height = kHeight;
    frame.params.camera = {{0, 0, 0}, {0, 1, 0}, {4.0F / 3, 0, 0}, {0, 0, 1}};
    frame.params.camera_kind = kernel::CAMERA_PERSPECTIVE;
    frame.instances.push_back({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}});
    return frame;
}

Frame moved_object(float x) {
    Frame frame = frame_of();
    frame.instances[0].world_from_object_t = {x, 0, 0};
    frame.instances[0].object_from_world_t = {-x, 0, 0};
    return frame;
}

/// Turned about Z, to the left.
Frame turned(float angle_deg) {
    Frame frame = frame_of();
    const float c = std::cos(radians(angle_deg)), s = std::sin(radians(angle_deg));
    frame.params.camera.center = {-s, c, 0};
    frame.params.camera.right = {c * 4 / 3, s * 4 / 3, 0};
    return frame;
}

EyeHits hits_of(float depth, std::uint32_t instance) {
    constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;
    return {std::vector<float>(kPixels, depth), std::vector<float>(kPixels, depth),
            std::vector<std::uint32_t>(kPixels, instance), std::vector<std::uint32_t>(kPixels)};
}

constexpr std::size_t kMiddle = std::size_t{kWidth} * (kHeight / 2) + kWidth / 2;

// Catches velocities of another scale than the picture's: half of it is 30 pixels, at distance 10 that is 10 units.
TEST(EyeHits, AMovingThingsPathIsItsProjection) {
    const auto paths = paths_on_screen(hits_of(10, 0), moved_object(-1), moved_object(0), moved_object(2));
    EXPECT_NEAR(paths[kMiddle].opens.x, -3, 0.01);
    EXPECT_NEAR(paths[kMiddle].closes.x, 6, 0.01);
    EXPECT_NEAR(paths[kMiddle].closes.y, 0, 0.01);
    // What rests stays exactly where it is.
    const auto resting = paths_on_screen(hits_of(10, kernel::NONE), moved_object(-1), moved_object(0), moved_object(2));
    for (const auto& path : resting) {
        EXPECT_EQ(path.opens, Vec2{});
        EXPECT_EQ(path.closes, Vec2{});
    }
}

// Catches a sky that stands still while the camera turns, and the wrong way of turning.
TEST(EyeHits, ATurningCameraMovesAllByItsAngle) {
    const float shift = 30 * std::tan(radians(3));
    for (const float depth : {7.0F, std::numeric_limits<float>::infinity()}) {
        const std::uint32_t instance = std::isinf(depth) ? kNoInstance : kernel::NONE;
        const auto paths = paths_on_screen(hits_of(depth, instance), turned(-3), turned(0), turned(3));
        EXPECT_NEAR(paths[kMiddle].opens.x, -shift, 0.05);
        EXPECT_NEAR(paths[kMiddle].closes.x, shift, 0.05);
    }
    // Turned round, it is behind the eye: its way is guessed from the other end.
    const auto behind = paths_on_screen(hits_of(7, kernel::NONE), turned(-180), turned(0), turned(3));
    EXPECT_NEAR(behind[kMiddle].opens.x, -shift, 0.05);
}

// Catches a lens other than the traced one: a camera of other rays is no pinhole.
TEST(EyeHits, OnlyPinholesCount) {
    Frame frame = frame_of();
    frame.camera_normal = kernel::NONE;
    EXPECT_TRUE(has_pinhole(frame));
    frame.params.camera_kind = kernel::CAMERA_FISHEYE;
    EXPECT_FALSE(has_pinhole(frame));
}

}  // namespace
}  // namespace sundog
