// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "compile/compile.h"
#include "compile/lights.h"

namespace sundog {
namespace {

constexpr float kNear = 1e-5F;

void expect_near(const kernel::vec3& got, Vec3 want) {
    EXPECT_NEAR(got.x, want.x, kNear);
    EXPECT_NEAR(got.y, want.y, kNear);
    EXPECT_NEAR(got.z, want.z, kNear);
}

scene::Motion constant(float value) { return {scene::Motion::Kind::constant, value, 0, 0}; }

// Catches a field of view that is horizontal, or off by the window being 1 high instead of 2.
TEST(Camera, Focus12Is90DegreesHigh) {
    const kernel::Camera c = camera_at({}, 0, 2);
    expect_near(c.eye, {0, 0, 0});
    expect_near(c.center, {0, 1, 0});
    expect_near(c.right, {2, 0, 0});
    expect_near(c.up, {0, 0, 1});  // The upper edge is at 45 degrees: 90 degrees in all.
}

// Catches a distance that is applied after the turns, or turns about the world's origin instead of the camera's.
TEST(Camera, MovesBackThenTurnsAboutOrigin) {
    scene::OrbitCamera camera;
    camera.origin = {10, 20, 30};
    camera.distance = 5;
    camera.focus = 24;
    expect_near(camera_at(camera, 0, 1).eye, {10, 15, 30});
    // A quarter turn about X takes -Y to -Z: the eye ends below the origin and looks up.
    camera.rot_x_deg = constant(90);
    kernel::Camera c = camera_at(camera, 0, 1);
    expect_near(c.eye, {10, 20, 25});
    expect_near(c.center, {0, 0, 2});
    // A quarter turn about Z takes -Y to +X.
    camera.rot_x_deg = constant(0);
    camera.rot_z_deg = constant(90);
    c = camera_at(camera, 0, 1);
    expect_near(c.eye, {15, 20, 30});
    expect_near(c.center, {-2, 0, 0});
    // X first, then Z: the eye that X left on the axis stays there, only the window's right turns on.
    camera.rot_x_deg = constant(90);
    c = camera_at(camera, 0, 1);
    expect_near(c.eye, {10, 20, 25});
    expect_near(c.right, {0, 1, 0});
}

// Catches linear and wave motions that use another unit than the format's (degrees, and sin of radians).
TEST(Camera, Moves) {
    scene::OrbitCamera camera;
    camera.distance = 1;
    camera.rot_z_deg = {scene::Motion::Kind::linear, 0, 45, 0};
    expect_near(camera_at(camera, 2, 1).eye, {1, 0, 0});
    camera.rot_z_deg = {scene::Motion::Kind::wave, 60, kPi / 2, 30};
    expect_near(camera_at(camera, 1, 1).eye, {1, 0, 0});
}

// Catches a lamp's path with sine and cosine swapped, and a sun whose direction is not a unit vector.
TEST(Frame, LightsMove) {
    scene::Scene scene;
    scene::Light lamp;
    lamp.place = {1, 2, 3};
    lamp.moving = true;
    lamp.speed = {1, 2, 3};
    lamp.amplitude = {10, 20, 30};
    scene::Light sun;
    sun.kind = scene::Light::Kind::sun;
    sun.place = {0, 3, 4};
    scene.lights = {lamp, sun};
    const auto compiled = compile(scene, {});
    FrameOptions options;
    const Frame at_0 = make_frame(scene, *compiled, options);
    expect_near(at_0.lights[0].place, {11, 2, 33});
    expect_near(at_0.lights[1].place, {0, 0.6F, 0.8F});
    options.time_s = 0.5F;
    expect_near(make_frame(scene, *compiled, options).lights[0].place,
                {1 + 10 * std::cos(0.5F), 2 + 20 * std::sin(1.0F), 3 + 30 * std::cos(1.5F)});
    scene.settings.freeze_s = 0.0F;
    expect_near(make_frame(scene, *compiled, options).lights[0].place, {11, 2, 33});
}

// Catches the wrong precedence: command line over scene over defaults.
TEST(Frame, OptionsOverruleSettingsOverruleDefaults) {
    scene::Scene scene;
    const auto compiled = compile(scene, {});
    FrameOptions options;
    Frame frame = make_frame(scene, *compiled, options);
    EXPECT_EQ(frame.params.width, 640U);
    EXPECT_EQ(frame.params.height, 480U);
    EXPECT_EQ(frame.params.max_depth, 5U);
    EXPECT_TRUE(std::isinf(frame.params.far_z));
    EXPECT_EQ(frame.params.light_count, 0U);
    EXPECT_EQ(frame.lights.size(), 1U);
    EXPECT_EQ(frame.instances.size(), 1U);
    scene.settings.width = 100;
    scene.settings.max_depth = 2;
    options.max_depth = 9;
    frame = make_frame(scene, *compiled, options);
    EXPECT_EQ(frame.params.width, 100U);
    EXPECT_EQ(frame.params.max_depth, 9U);
}

// Catches shadow rays where nothing casts shadows or where they were switched off.
TEST(Frame, ShadowsNeedALightThatCastsThem) {
    scene::Scene scene;
    const auto compiled = compile(scene, {});
    FrameOptions options;
    const auto shadows = [&] {
        return (make_frame(scene, *compiled, options).params.features & kernel::FEATURE_SHADOWS) != 0;
    };
    EXPECT_FALSE(shadows());
    scene.lights.emplace_back();
    EXPECT_TRUE(shadows());
    scene.lights[0].shadows = false;
    EXPECT_FALSE(shadows());
    scene.lights[0].shadows = true;
    scene.settings.shadows = false;
    EXPECT_FALSE(shadows());
    options.shadows = true;
    EXPECT_TRUE(shadows());
}

// Catches instances in another order than the geometries refer to them, and maps that aren't inverse to each other.
TEST(Frame, InstancesFollowTheirObjects) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene::ObjectMotion motion;
    motion.move_speed = {kPi / 2, 0, 0};
    motion.move_amplitude = {7, 0, 0};
    scene.objects.push_back({"still", {}, scene::Sphere{{0, 0, 0}, 1}, 0, {}});
    scene.objects.push_back({"gone", {}, scene::Sphere{{0, 0, 0}, 0}, 0, scene::ObjectMotion{}});
    scene.objects.push_back({"moving", {}, scene::Sphere{{0, 0, 0}, 1}, 0, motion});
    const auto compiled = compile(scene, {});
    EXPECT_EQ(compiled->geometries[0].instance, kernel::NONE);
    EXPECT_EQ(compiled->geometries[1].instance, 0U);
    EXPECT_NE(compiled->features & kernel::FEATURE_INSTANCES, 0U);
    FrameOptions options;
    options.time_s = 1;
    const Frame frame = make_frame(scene, *compiled, options);
    ASSERT_EQ(frame.instances.size(), 1U);
    expect_near(frame.instances[0].world_from_object_t, {7, 0, 0});
    expect_near(frame.instances[0].object_from_world_t, {-7, 0, 0});
}

// Areas whose lights light one by one cost more: no other light may say so.
TEST(Lights, OnlyAnIlluminatingAreaLightsInParts) {
    scene::Light light;
    light.area = scene::LightArea{{2, 0, 0}, {0, 4, 0}, 3, 2};
    EXPECT_EQ(light_at(light, 0).flags & kernel::LIGHT_ILLUMINATES, 0U);
    light.area->illuminates = true;
    EXPECT_NE(light_at(light, 0).flags & kernel::LIGHT_ILLUMINATES, 0U);
}

}  // namespace
}  // namespace sundog
