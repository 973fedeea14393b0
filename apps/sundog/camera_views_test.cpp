// SPDX-License-Identifier: Apache-2.0
#include "camera_views.h"

#include <gtest/gtest.h>

#include <cmath>

#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr Bounds3 kBox{{-1, 2, 0}, {3, 4, 5}};
constexpr float kAspect = 1.5F;

Vec3 vec(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

scene::Compass pov_compass() { return {{0, 1, 0}, {0, 0, 1}, true}; }

/// Where a point lies in the picture: -1 to 1 to the right and upwards.
Vec2 seen_at(const kernel::Camera& camera, Vec3 point) {
    const Vec3 way = point - vec(camera.eye);
    const Vec3 ahead = vec(camera.center), right = vec(camera.right), up = vec(camera.up);
    const float depth = dot(way, ahead) / dot(ahead, ahead);
    EXPECT_GT(depth, 0) << "behind the camera";
    return {dot(way, right) / dot(right, right) / depth, dot(way, up) / dot(up, up) / depth};
}

// Catches views that cut the scene off, or show it lost in the distance, in either handedness.
TEST(CameraViews, ShowAllOfTheSceneAndLittleElse) {
    for (const scene::Compass& compass : {scene::Compass{}, pov_compass()})
        for (std::size_t view = 0; view < kViewNames.size(); ++view) {
            SCOPED_TRACE(kViewNames[view]);
            const kernel::Camera camera = camera_of(static_cast<View>(view), compass, kBox, kAspect);
            float most = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 at{(corner & 1) != 0 ? kBox.lower.x : kBox.upper.x,
                              (corner & 2) != 0 ? kBox.lower.y : kBox.upper.y,
                              (corner & 4) != 0 ? kBox.lower.z : kBox.upper.z};
                const Vec2 seen = seen_at(camera, at);
                most = std::max({most, std::abs(seen.x), std::abs(seen.y)});
            }
            EXPECT_LT(most, 1);
            EXPECT_GT(most, 0.85F);
        }
}

// Catches left and right, front and back, or up and down swapped.
TEST(CameraViews, StandWhereTheyAreCalled) {
    const auto picture_of = [](View view, const scene::Compass& compass, Vec3 towards) {
        return seen_at(camera_of(view, compass, {{-1, -1, -1}, {1, 1, 1}}, 1), towards * 0.5F);
    };
    const scene::Compass orbit;
    EXPECT_LT(vec(camera_of(View::front, orbit, kBox, 1).eye).y, 2) << "the front is at -Y";
    EXPECT_GT(vec(camera_of(View::right, orbit, kBox, 1).eye).x, 3);
    EXPECT_GT(picture_of(View::front, orbit, {1, 0, 0}).x, 0.1F);
    EXPECT_LT(picture_of(View::back, orbit, {1, 0, 0}).x, -0.1F);
    EXPECT_GT(picture_of(View::front, orbit, {0, 0, 1}).y, 0.1F);
    EXPECT_GT(picture_of(View::top, orbit, {0, 1, 0}).y, 0.1F);
    EXPECT_GT(picture_of(View::top, orbit, {1, 0, 0}).x, 0.1F);
    EXPECT_GT(picture_of(View::iso, orbit, {0, 0, 1}).y, 0.1F);
    // POV-Ray's scenes: +X to the right as seen along +Z, +Y up.
    EXPECT_GT(picture_of(View::front, pov_compass(), {1, 0, 0}).x, 0.1F);
    EXPECT_GT(picture_of(View::front, pov_compass(), {0, 1, 0}).y, 0.1F);
    EXPECT_GT(vec(camera_of(View::right, pov_compass(), kBox, 1).eye).x, 3);
}

// Catches a turn about another point, the wrong way round, or one that doesn't end where it began.
TEST(CameraViews, GoRoundTheScene) {
    const scene::Compass compass;
    const kernel::Camera front = camera_of(View::front, compass, kBox, kAspect);
    const kernel::Camera quarter = turned(front, compass, kBox.center(), 90);
    EXPECT_GT(vec(quarter.eye).x, kBox.upper.x) << "from -Y, counter-clockwise from above, to +X";
    EXPECT_NEAR(seen_at(quarter, kBox.center()).x, 0, 1e-5);
    EXPECT_NEAR(length(vec(quarter.eye) - kBox.center()), length(vec(front.eye) - kBox.center()), 1e-4);
    const kernel::Camera whole = turned(front, compass, kBox.center(), 360);
    EXPECT_NEAR(length(vec(whole.eye) - vec(front.eye)), 0, 1e-4);
}

// Catches a camera at no distance, or infinitely far away.
TEST(CameraViews, NeedSomethingToLookAt) {
    EXPECT_THROW(camera_of(View::front, {}, {}, 1), UsageError);
    EXPECT_THROW(camera_of(View::front, {}, {{1, 1, 1}, {1, 1, 1}}, 1), UsageError);
    EXPECT_THROW(camera_of(View::front, {}, {{0, 0, 0}, {INFINITY, 1, 1}}, 1), UsageError);
}

// Catches names that are taken for numbers, and the other way round.
TEST(CameraViews, NamesAndNumbers) {
    EXPECT_EQ(std::get<View>(parse_camera("iso")), View::iso);
    EXPECT_EQ(std::get<kernel::Camera>(parse_camera("1,2,3,0,1,0,1,0,0,0,0,1")).eye.y, 2);
    for (const char* bad : {"", "fornt", "1,2,3", "front,back"}) EXPECT_THROW(parse_camera(bad), UsageError) << bad;
}

}  // namespace
}  // namespace sundog::app
