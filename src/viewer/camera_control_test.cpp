// SPDX-License-Identifier: Apache-2.0
#include "viewer/camera_control.h"

#include <gtest/gtest.h>

namespace sundog::viewer {
namespace {

Vec3 host(kernel::vec3 v) { return {v.x, v.y, v.z}; }

void expect_near(Vec3 a, Vec3 b, float tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

// Ten units before the origin, looking along +Y, 90 degrees of field of view.
kernel::Camera front_camera() { return {{0, -10, 0}, {0, 1, 0}, {1.5F, 0, 0}, {0, 0, 1}}; }

// Looks down, rolled, with an oblique window, at nothing in particular.
kernel::Camera odd_camera() { return {{3, -7, 5}, {0.2F, 0.9F, -0.6F}, {1.2F, 0.1F, 0.3F}, {-0.2F, 0.5F, 0.8F}}; }

CameraControl control_of(const kernel::Camera& camera) {
    CameraControl control;
    Bounds3 bounds;
    bounds.include(Vec3{-1, -1, -1});
    bounds.include(Vec3{1, 1, 1});
    control.set_bounds(bounds);
    control.follow(camera);
    return control;
}

// Where a world point appears: -1..1 from left to right and from top to bottom.
Vec2 seen_at(const kernel::Camera& camera, Vec3 point) {
    const Affine3 world_from_view{host(camera.right), host(camera.up), host(camera.center), host(camera.eye)};
    const Vec3 view = transform_point(inverse(world_from_view), point);
    return {view.x / view.z, -view.y / view.z};
}

// Catches a camera that is rebuilt from angles and so changes (here: loses its roll) the moment the user touches it.
TEST(CameraControl, StartsFromTheScenesCameraWithoutAJump) {
    CameraControl control = control_of(odd_camera());
    const kernel::Camera before = control.camera(1.2F);
    control.orbit({0.001F, 0}, 480);
    EXPECT_TRUE(control.is_free());
    const float aspect = length(host(before.right)) / length(host(before.up));
    const kernel::Camera after = control.camera(aspect);
    expect_near(host(after.eye), host(before.eye), 1e-4F);
    expect_near(host(after.center), host(before.center), 1e-5F);
    expect_near(host(after.right), host(before.right), 1e-5F);
    expect_near(host(after.up), host(before.up), 1e-5F);
}

// POV-Ray's axes: x to the right, y up, z forwards, which is a left-handed system.
kernel::Camera pov_camera() { return {{0, 0, -10}, {0, 0, 1}, {1.5F, 0, 0}, {0, 1, 0}}; }

// Catches controls that work the wrong way round, or roll the picture, in scenes whose up is y.
TEST(CameraControl, TurnsTheSameWayWhereYIsUp) {
    CameraControl control = control_of(pov_camera());
    control.set_up({0, 1, 0});
    control.orbit({120, 0}, 480);
    expect_near(host(control.camera(1).up), {0, 1, 0}, 1e-5F);
    EXPECT_LT(host(control.camera(1).eye).x, -1) << "what is in front follows the mouse to the right";
    control.orbit({0, 60}, 480);
    EXPECT_GT(host(control.camera(1).eye).y, 1) << "what is in front follows the mouse down: the eye rises";
    control.fly({0, 0, 1}, 1);
    EXPECT_GT(host(control.camera(1).eye).y, 2);
}

// Catches a camera of parallel rays that jumps to another size when the user takes it over.
TEST(CameraControl, ParallelRaysBecomeAPinholeThatShowsTheSame) {
    CameraControl control;
    Bounds3 bounds;
    bounds.include(Vec3{-1, -1, -1});
    bounds.include(Vec3{1, 1, 1});
    control.set_bounds(bounds);
    control.follow({{0, 0, -10}, {0, 0, 1}, {4, 0, 0}, {0, 3, 0}}, true);
    control.pan({0, 0}, 480);
    const Vec2 place = seen_at(control.camera(4.0F / 3), {4, 3, 0});
    EXPECT_NEAR(place.x, 1, 1e-5F);
    EXPECT_NEAR(place.y, -1, 1e-5F);
}

// Catches an orbit that changes the distance, lets the pivot wander over the picture, or turns the wrong way.
TEST(CameraControl, OrbitTurnsAboutThePivot) {
    CameraControl control = control_of(front_camera());
    expect_near(control.pivot(), {0, 0, 0}, 1e-5F);
    control.orbit({240, 0}, 480);  // half the height: 90 degrees
    expect_near(control.pivot(), {0, 0, 0}, 1e-4F);
    // What is in front follows the mouse to the right, so the eye goes to the left.
    expect_near(host(control.camera(1.5F).eye), {-10, 0, 0}, 1e-3F);
    control.orbit({0, 80}, 480);  // down: the eye rises by 30 degrees
    EXPECT_NEAR(control.camera(1.5F).eye.z, 5, 1e-3F);
    EXPECT_NEAR(length(host(control.camera(1.5F).eye)), 10, 1e-3F);
}

// Catches a camera that tips over the pole and then turns the wrong way.
TEST(CameraControl, OrbitStopsAtThePoles) {
    for (const float direction : {1.0F, -1.0F}) {
        CameraControl control = control_of(front_camera());
        for (int i = 0; i < 50; ++i) control.orbit({0, direction * 100}, 480);
        const kernel::Camera camera = control.camera(1.5F);
        EXPECT_GT(camera.up.z, 0);
        EXPECT_GT(-direction * camera.center.z, 0.99F);  // dragged down: it looks down from above
    }
}

// Catches panning that doesn't keep what is under the mouse there (wrong scale, or an axis swapped).
TEST(CameraControl, PanKeepsThePivotPlaneUnderTheMouse) {
    CameraControl control = control_of(front_camera());
    const Vec3 point{1, 0, 2};  // in the plane through the pivot
    const Vec2 before = seen_at(control.camera(1.5F), point);
    control.pan({72, -24}, 480);  // the window is 720 x 480
    const Vec2 after = seen_at(control.camera(1.5F), point);
    EXPECT_NEAR(after.x - before.x, 72.0F / 360, 1e-4F);
    EXPECT_NEAR(after.y - before.y, -24.0F / 240, 1e-4F);
}

// Catches a zoom that passes through the pivot or never comes back.
TEST(CameraControl, ZoomApproachesThePivot) {
    CameraControl control = control_of(front_camera());
    control.zoom(1);
    EXPECT_NEAR(control.camera(1.5F).eye.y, -8.75F, 1e-4F);
    control.zoom(-1);
    EXPECT_NEAR(control.camera(1.5F).eye.y, -10, 1e-4F);
    control.zoom(1000);
    EXPECT_LT(control.camera(1.5F).eye.y, 0);
    expect_near(control.pivot(), {0, 0, 0}, 1e-4F);
}

// Catches looking about that moves the eye or goes against the mouse.
TEST(CameraControl, LookTurnsAboutTheEye) {
    CameraControl control = control_of(front_camera());
    control.look({240, 0}, 480);  // 90 degrees of view are 480 px high
    const kernel::Camera camera = control.camera(1.5F);
    expect_near(host(camera.eye), {0, -10, 0}, 1e-5F);
    EXPECT_NEAR(camera.center.x, std::sqrt(0.5F), 1e-4F);
    EXPECT_NEAR(camera.center.y, std::sqrt(0.5F), 1e-4F);
}

// Catches flying along the wrong axes, or a speed that doesn't fit the scene's size.
TEST(CameraControl, FliesAlongTheViewByTheScenesSize) {
    CameraControl control = control_of(front_camera());
    control.fly({0, 0, 0}, 1);
    EXPECT_FALSE(control.is_free());
    control.fly({0, 1, 0}, 1);
    EXPECT_NEAR(control.camera(1.5F).eye.y, -10 + std::sqrt(3.0F), 1e-4F);
    control.fly({1, 0, -1}, 2);
    EXPECT_NEAR(control.camera(1.5F).eye.x, 2 * std::sqrt(3.0F), 1e-4F);
    EXPECT_NEAR(control.camera(1.5F).eye.z, -2 * std::sqrt(3.0F), 1e-4F);
}

// Catches a free camera that the moving scene still drags along, and a Home key that doesn't give it back.
TEST(CameraControl, FollowsTheSceneOnlyWhileNotFree) {
    CameraControl control = control_of(front_camera());
    control.zoom(1);
    control.follow(odd_camera());
    EXPECT_NEAR(control.camera(1.5F).eye.x, 0, 1e-6F);
    control.go_home();
    control.follow(odd_camera());
    EXPECT_FALSE(control.is_free());
    expect_near(host(control.camera(1.5F).eye), {3, -7, 5}, 0);
}

// Catches a picture stretched after the window was resized.
TEST(CameraControl, WidthFollowsTheWindow) {
    CameraControl control = control_of(front_camera());
    control.zoom(1);
    EXPECT_NEAR(control.camera(3).right.x, 3, 1e-5F);
    EXPECT_NEAR(control.camera(3).up.z, 1, 1e-5F);
}

// Catches NaN where the scene has no bounds (only planes, or nothing).
TEST(CameraControl, WorksWithoutBounds) {
    CameraControl control;
    control.set_bounds(Bounds3{});
    control.follow(front_camera());
    control.orbit({10, 10}, 480);
    control.pan({10, 10}, 480);
    control.zoom(2);
    const kernel::Camera camera = control.camera(1.5F);
    EXPECT_TRUE(is_finite(host(camera.eye)));
    EXPECT_TRUE(is_finite(host(camera.center)));
}

}  // namespace
}  // namespace sundog::viewer
