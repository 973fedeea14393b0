// SPDX-License-Identifier: Apache-2.0
#include "scene/deformation.h"

#include <gtest/gtest.h>

namespace sundog::scene {
namespace {

/// An object of two vertices at (1, 0, 0) and (2, 0, 0), each with a normal along x.
Scene scene_of(const std::shared_ptr<const Deformation>& deformation) {
    Scene scene;
    Object& object = scene.objects.emplace_back();
    Mesh mesh;
    mesh.positions = deformation->positions;
    mesh.normals = deformation->normals;
    object.shape = std::move(mesh);
    object.deformation = deformation;
    return scene;
}

Deformation two_vertices() {
    Deformation d;
    d.tree = std::make_shared<NodeTree>();
    d.positions = {{1, 0, 0}, {2, 0, 0}};
    d.normals = {{1, 0, 0}, {1, 0, 0}};
    d.vertex_of_normal = {0, 1};
    return d;
}

const Mesh& mesh_of(const Scene& scene) { return *std::get<Boxed<Mesh>>(scene.objects[0].shape); }

void expect_near(Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), 1e-5F) << a.x << ' ' << a.y << ' ' << a.z; }

// Catches weights that are not interpolated, targets that add up over time, and resting ones that count as moving.
TEST(Deformation, MorphTargetsAreWeighted) {
    Deformation d = two_vertices();
    d.targets = {{{{0, 1, 0}, {0, 2, 0}}, {}}, {{{0, 0, 4}, {0, 0, 4}}, {{0, 2, 0}, {0, 0, 0}}}};
    d.weights = {0, 0.5F};
    EXPECT_FALSE(moves(d));
    Scene resting = scene_of(std::make_shared<const Deformation>(d));
    deform(resting, 3);
    expect_near(mesh_of(resting).positions[0], {1, 0, 2});
    expect_near(mesh_of(resting).normals[0], {1, 1, 0});
    d.weight_track = KeyframeTrack{KeyframeTrack::Interpolation::linear, {0, 2}, 2, {0, 0, 1, 0}};
    Scene scene = scene_of(std::make_shared<const Deformation>(d));
    EXPECT_TRUE(is_deforming(scene));
    EXPECT_TRUE(is_animated(scene));
    for (const float time_s : {2.0F, 1.0F}) deform(scene, time_s);
    expect_near(mesh_of(scene).positions[1], {2, 1, 0});
}

// Catches inverse bind matrices on the wrong side, and weights of joints that are mixed up.
TEST(Deformation, JointsCarryVertices) {
    Deformation d = two_vertices();
    auto tree = std::make_shared<NodeTree>();
    tree->nodes.resize(2);
    tree->nodes[1].translation = {1, 0, 0};
    // A quarter turn about z around (1, 0, 0), where the joint was bound.
    const float s = std::sqrt(0.5F);
    tree->nodes[1].rotations = KeyframeTrack{KeyframeTrack::Interpolation::step, {0, 1}, 4, {0, 0, 0, 1, 0, 0, s, s}};
    d.tree = tree;
    d.joints = {{0, {}}, {1, translation({-1, 0, 0})}};
    d.influences = {{{{0, 1, 0, 0}, {0.5F, 0.5F, 0, 0}}, {{1, 0, 0, 0}, {1, 0, 0, 0}}}};
    Scene scene = scene_of(std::make_shared<const Deformation>(d));
    deform(scene, 0);
    expect_near(mesh_of(scene).positions[1], {2, 0, 0});
    deform(scene, 1);
    expect_near(mesh_of(scene).positions[0], {1, 0, 0});
    expect_near(mesh_of(scene).positions[1], {1, 1, 0});
    expect_near(mesh_of(scene).normals[1], {0, 1, 0});
}

}  // namespace
}  // namespace sundog::scene
