// SPDX-License-Identifier: Apache-2.0
#include "scene/animation.h"

#include <gtest/gtest.h>

#include "scene/scene.h"

namespace sundog::scene {
namespace {

using Interpolation = KeyframeTrack::Interpolation;

float first_at(const KeyframeTrack& track, float time_s) { return value_at(track, time_s, false)[0]; }

void expect_near(Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), 1e-5F) << a.x << ' ' << a.y << ' ' << a.z; }

// Catches keys that are off by one, and times outside of the track.
TEST(KeyframeTrack, InterpolatesBetweenKeys) {
    KeyframeTrack track{Interpolation::linear, {1, 2, 4}, 1, {10, 20, 40}};
    EXPECT_EQ(first_at(track, 0), 10);
    EXPECT_EQ(first_at(track, 1), 10);
    EXPECT_EQ(first_at(track, 1.5F), 15);
    EXPECT_EQ(first_at(track, 3), 30);
    EXPECT_EQ(first_at(track, 9), 40);
    track.interpolation = Interpolation::step;
    EXPECT_EQ(first_at(track, 1.9F), 10);
    EXPECT_EQ(first_at(track, 2), 20);
}

// Catches tangents that are taken from the wrong side of a key, or not scaled by the time between keys.
TEST(KeyframeTrack, CubicPiecesFollowTheirTangents) {
    // x(t) = t^3 on 0..2: slope 0 and 12 at the ends.
    const KeyframeTrack track{Interpolation::cubic, {0, 2}, 1, {99, 0, 0, 12, 8, 99}};
    EXPECT_FLOAT_EQ(first_at(track, 0), 0);
    EXPECT_FLOAT_EQ(first_at(track, 1), 1);
    EXPECT_FLOAT_EQ(first_at(track, 1.5F), 3.375F);
    EXPECT_FLOAT_EQ(first_at(track, 2), 8);
}

// Catches rotations that go the long way around, or lose their length half-way.
TEST(KeyframeTrack, RotationsTakeTheShorterArc) {
    const float s = std::sqrt(0.5F);
    // Half a turn's half about z; the second key is the same rotation with all signs turned.
    const KeyframeTrack track{Interpolation::linear, {0, 1}, 4, {0, 0, 0, 1, 0, 0, -s, -s}};
    const std::vector<float> q = value_at(track, 0.5F, true);
    const Affine3 turn = rotation_of(Quaternion{q[0], q[1], q[2], q[3]});
    expect_near(transform_point(turn, {1, 0, 0}), {s, s, 0});
}

// Catches parents that are applied in the wrong order, and animations that don't begin again.
TEST(NodeTree, ChildrenMoveWithTheirParents) {
    auto tree = std::make_shared<NodeTree>();
    tree->duration_s = 2;
    AnimatedNode parent;
    parent.translation = {0, 0, 5};
    const float s = std::sqrt(0.5F);
    parent.rotations = KeyframeTrack{Interpolation::step, {0, 1}, 4, {0, 0, 0, 1, 0, 0, s, s}};
    AnimatedNode child;
    child.parent = 0;
    child.scale = {2, 2, 2};
    child.translation = {1, 0, 0};
    tree->nodes = {parent, child};
    expect_near(transform_point(transform_at(*tree, 1, 0), {1, 0, 0}), {3, 0, 5});
    expect_near(transform_point(transform_at(*tree, 1, 1), {1, 0, 0}), {0, 3, 5});
    expect_near(transform_point(transform_at(*tree, 1, 2), {1, 0, 0}), {0, 3, 5});
    expect_near(transform_point(transform_at(*tree, 1, 2.5F), {1, 0, 0}), {3, 0, 5});
}

// Catches a map without an inverse, from which hits would be computed.
TEST(NodeMotion, NothingIsScaledToNothing) {
    auto tree = std::make_shared<NodeTree>();
    tree->nodes.emplace_back().scale = {0, 0, 0};
    tree->nodes[0].translation = {1, 2, 3};
    const Affine3 placed = transform_at(NodeMotion{tree, 0, {}}, 0);
    EXPECT_NE(determinant(placed), 0);
    expect_near(placed.t, {1, 2, 3});
}

// Catches cameras that are scaled with their nodes, and lights that stay behind.
TEST(NodeMotion, CarriesCamerasAndLights) {
    auto tree = std::make_shared<NodeTree>();
    tree->nodes.emplace_back().scale = {3, 3, 3};
    tree->nodes[0].translations = KeyframeTrack{Interpolation::linear, {0, 1}, 3, {0, 0, 0, 6, 0, 0}};
    Scene scene;
    EXPECT_FALSE(is_animated(scene));
    ProjectionCamera& camera = scene.projection_camera.emplace();
    camera.direction = {0, 0, -2};
    camera.motion = NodeMotion{tree, 0, {}};
    EXPECT_TRUE(is_animated(scene));
    const ProjectionCamera placed = placed_at(camera, 0.5F);
    expect_near(to_float(placed.location), {3, 0, 0});
    expect_near(to_float(placed.direction), {0, 0, -2});
    Light light;
    light.motion = NodeMotion{tree, 0, {}};
    light.point_at = {0, 0, -1};
    expect_near(placed_at(light, 1).place, {6, 0, 0});
    expect_near(placed_at(light, 1).point_at, {6, 0, -3});
}

}  // namespace
}  // namespace sundog::scene
