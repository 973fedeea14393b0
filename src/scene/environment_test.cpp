// SPDX-License-Identifier: Apache-2.0
#include "scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sundog::scene {
namespace {

/// A picture of 4 by 2, each pixel with its own red.
Environment numbered() {
    Environment environment;
    environment.width = 4;
    environment.height = 2;
    for (int i = 0; i < 8; ++i) environment.radiance.push_back({static_cast<float>(i), 0, 0});
    return environment;
}

// Catches a picture that hangs upside down, sideways or turned the wrong way in an orbit scene.
TEST(Environment, HangsUprightInAnOrbitScene) {
    Scene scene;
    hang(numbered(), 0, scene);
    const Environment& env = *scene.environment;
    EXPECT_EQ(env.up, (Vec3{0, 0, 1}));
    EXPECT_NEAR(length(direction_in(env, 0.5F, 0.5F) - Vec3{0, 1, 0}), 0, 1e-6);
    EXPECT_NEAR(length(direction_in(env, 0.75F, 0.5F) - Vec3{1, 0, 0}), 0, 1e-6) << "right of +Y is +X";
    EXPECT_NEAR(length(direction_in(env, 0.3F, 0) - Vec3{0, 0, 1}), 0, 1e-6);
    hang(numbered(), 90, scene);
    EXPECT_NEAR(length(scene.environment->middle - Vec3{-1, 0, 0}), 0, 1e-6) << "counter-clockwise from above";
}

// Catches a mirrored picture in POV-Ray's left-handed space, and an axis that isn't its up.
TEST(Environment, IsSeenAsItIsInALeftHandedScene) {
    Scene scene;
    scene.projection_camera.emplace();  // looks along +Z, +Y up, +X right
    hang(numbered(), 0, scene);
    const Environment& env = *scene.environment;
    EXPECT_EQ(env.up, (Vec3{0, 1, 0}));
    EXPECT_EQ(env.middle, (Vec3{0, 0, 1}));
    // What was right of the middle (columns 2 and 3) is where one sees right: at +X.
    const bool right_half = dot(direction_in(env, 0.75F, 0.5F), {1, 0, 0}) > 0;
    EXPECT_EQ(env.radiance[right_half ? 3 : 0].x, 3);
    EXPECT_EQ(env.radiance[right_half ? 0 : 3].x, 0);
    const Vec3 east = direction_at(compass_of(scene), 90, 0);
    EXPECT_NEAR(length(east - Vec3{1, 0, 0}), 0, 1e-6);
}

// Catches pixels that would make a whole picture's sums infinite or negative.
TEST(Environment, OddPixelsAreTamed) {
    Environment odd = numbered();
    odd.radiance[0] = {NAN, -1, INFINITY};
    Scene scene;
    hang(odd, 0, scene);
    const Vec3 tamed = scene.environment->radiance[0];
    EXPECT_EQ(tamed.x, 0);
    EXPECT_EQ(tamed.y, 0);
    EXPECT_TRUE(std::isfinite(tamed.z));
    EXPECT_GT(tamed.z, 1e6F);
}

}  // namespace
}  // namespace sundog::scene
