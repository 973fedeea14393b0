// SPDX-License-Identifier: Apache-2.0
#include "cost_picture.h"

#include <gtest/gtest.h>

#include "device/choose/choose.h"

namespace sundog::app {
namespace {

// Catches colours that run backwards or jump, and numbers that fall off either end of the scale.
TEST(CostPicture, ColorsFollowTheSteps) {
    const auto near = [](Vec3 a, Vec3 b) { return length(a - b) < 0.01F; };
    EXPECT_EQ(cost_color(0), (Vec3{0, 0, 0}));
    EXPECT_EQ(cost_color(1e9), (Vec3{1, 1, 1}));
    EXPECT_TRUE(near(cost_color(0.9999), cost_color(1)));
    for (double steps = 1; steps < 2e5; steps *= 1.001) EXPECT_TRUE(near(cost_color(steps), cost_color(steps * 1.001)));
    EXPECT_GT(cost_color(10).z, cost_color(10).y);
    EXPECT_GT(cost_color(100).y, cost_color(100).z);
    EXPECT_GT(cost_color(10000).x, cost_color(10000).y);
}

// Catches steps that are put down to other pixels than those whose rays took them: a ball in the left half of the
// picture costs one test there, and so does the empty right half (no structure tests everything), but its shadow rays
// start on the ball alone.
TEST(CostPicture, CountsEachPixelsOwnSteps) {
    scene::Scene scene;
    scene.materials.emplace_back().name = "matt";
    scene::Object ball;
    ball.shape = scene::Sphere{{-1, 0, 0}, 0.6F};
    scene.objects.push_back(ball);
    scene.lights.emplace_back().place = {-1, -5, 0};
    scene.camera.focus = 12;
    scene.camera.distance = 2;
    const auto compiled = compile(scene, {});
    FrameOptions options;
    options.width = 40;
    options.height = 30;
    const Frame frame = make_frame(scene, *compiled, options);
    const auto device = open_device("cpu", 2, Acceleration::none);
    device->load(compiled);
    const CostPicture picture = cost_picture(*device, frame, 1, {}, StopFlag());
    Film film({0, 0, 40, 30});
    device->render(frame, {film.bounds, 0, 1}, film, StopFlag());
    EXPECT_FALSE(picture.stopped);
    EXPECT_EQ(picture.most, 2);
    EXPECT_EQ(picture.image.at(35, 15), cost_color(1));
    EXPECT_EQ(picture.image.at(0, 0), cost_color(1));
    std::size_t costly = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            if (picture.image.at(x, y) == cost_color(2)) {
                ++costly;
                EXPECT_LT(x, 20);
                EXPECT_GT(film.mean(x, y).x, 0);
            }
    EXPECT_GT(costly, 20U);
    EXPECT_NEAR(picture.mean * 40 * 30, 40 * 30 + static_cast<double>(costly), 1e-6);
}

}  // namespace
}  // namespace sundog::app
