// SPDX-License-Identifier: Apache-2.0
#include "compile/solid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compile/compile.h"
#include "solids/compiled_solid.h"

namespace sundog {
namespace {

using SolidPointer = std::shared_ptr<const scene::Solid>;

template <class T>
std::shared_ptr<scene::Solid> solid_of(T shape) {
    auto solid = std::make_shared<scene::Solid>();
    solid->shape = std::move(shape);
    return solid;
}

scene::Scene scene_of(std::vector<SolidPointer> solids) {
    scene::Scene scene;
    scene.materials.resize(3);
    for (SolidPointer& solid : solids) {
        scene::Object object;
        object.shape = std::move(solid);
        object.material = 1;
        scene.objects.push_back(std::move(object));
    }
    return scene;
}

// Catches plain shapes that take the slow path: what Embree or the kernel can do by itself needs no exact solid.
TEST(CompileSolid, PlainShapesBecomePrimitives) {
    auto sphere = solid_of(scene::SolidSphere{{1, 2, 3}, 2});
    sphere->parent_from_shape = {{0, 0, 3}, {0, 3, 0}, {-3, 0, 0}, {10, 0, 0}};  // turned and scaled alike
    auto box = solid_of(scene::SolidBox{{-1, -2, -3}, {1, 2, 3}});
    box->parent_from_shape = {{0, 2, 0}, {-1, 0, 0}, {0, 0, 1}, {}};  // a quarter turn
    auto plane = solid_of(scene::HalfSpace{{0, 1, 0}, 2});
    plane->parent_from_shape = {{1, 0, 0}, {0, 2, 0}, {0, 0, 1}, {0, 1, 0}};
    const auto compiled = compile(scene_of({sphere, box, plane}), {});
    EXPECT_TRUE(compiled->solids.empty());
    ASSERT_EQ(3U, compiled->geometries.size());
    EXPECT_FLOAT_EQ(6, compiled->spheres[0].radius);
    EXPECT_FLOAT_EQ(1, compiled->spheres[0].center.x);
    EXPECT_FLOAT_EQ(6, compiled->spheres[0].center.y);
    EXPECT_FLOAT_EQ(3, compiled->spheres[0].center.z);
    EXPECT_FLOAT_EQ(-2, compiled->boxes[0].lower.x);
    EXPECT_FLOAT_EQ(2, compiled->boxes[0].upper.y);
    EXPECT_FLOAT_EQ(5, compiled->planes[0].offset);
    EXPECT_FLOAT_EQ(1, compiled->planes[0].normal.y);
    EXPECT_EQ(1U, compiled->planes[0].material);
    EXPECT_EQ(2U, compiled->planes[0].geometry);
}

// Catches an ellipsoid, a turned box, an inverted or clipped shape drawn as the primitive that it isn't.
TEST(CompileSolid, WhatAPrimitiveCanNotBeIsExact) {
    auto ellipsoid = solid_of(scene::SolidSphere{{}, 1});
    ellipsoid->parent_from_shape.x = {2, 0, 0};
    auto turned = solid_of(scene::SolidBox{{-1, -1, -1}, {1, 1, 1}});
    turned->parent_from_shape = {{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}, {}};
    auto inverted = solid_of(scene::SolidSphere{{}, 1});
    inverted->inverted = true;
    auto clipped = solid_of(scene::SolidSphere{{}, 1});
    clipped->clipped_by.push_back(solid_of(scene::HalfSpace{{0, 1, 0}, 0}));
    auto lined = solid_of(scene::SolidSphere{{}, 1});
    lined->interior_material = 2;
    const auto compiled = compile(scene_of({ellipsoid, turned, inverted, clipped, lined}), {});
    ASSERT_EQ(5U, compiled->solids.size());
    for (std::uint32_t i = 0; i < 5; ++i) {
        EXPECT_EQ(kernel::GEOMETRY_SOLID, compiled->geometries[i].kind);
        EXPECT_EQ(i, compiled->solids[i].geometry);
    }
    EXPECT_NE(0U, compiled->features & kernel::FEATURE_ANALYTIC);
    EXPECT_NEAR(2, compiled->bounds.upper.x, 1e-5);
}

// Catches flat unions kept whole (Embree's tree then sees one big box), and clips that lose their place when split.
TEST(CompileSolid, FlatUnionsAreSplit) {
    auto clipped = solid_of(scene::SolidSphere{{}, 1});
    clipped->clipped_by.push_back(solid_of(scene::HalfSpace{{0, 1, 0}, 0}));
    auto inner = solid_of(scene::SolidGroup{{}, {solid_of(scene::Torus{2, 0.5}), clipped}});
    inner->parent_from_shape.t = {0, 10, 0};
    inner->material = 2;
    auto outer = solid_of(scene::SolidGroup{{}, {inner, solid_of(scene::SolidSphere{{5, 0, 0}, 1})}});
    outer->parent_from_shape.t = {100, 0, 0};
    const auto compiled = compile(scene_of({outer}), {});
    ASSERT_EQ(3U, compiled->geometries.size());
    ASSERT_EQ(2U, compiled->solids.size());
    EXPECT_EQ(std::vector<std::uint32_t>{2}, compiled->solids[0].solid->materials());
    EXPECT_TRUE(compiled->solids[1].solid->inside({100, 9.5, 0}));
    EXPECT_FALSE(compiled->solids[1].solid->inside({100, 10.5, 0}));
    EXPECT_FLOAT_EQ(105, compiled->spheres[0].center.x);
    EXPECT_EQ(1U, compiled->spheres[0].material);
    EXPECT_EQ((std::vector<std::uint32_t>{0, 0, 0}), compiled->geometry_objects);
}

// Catches a geometry, a name and a list entry for each of a million spheres.
TEST(CompileSolid, RunsOfNamelessPrimitivesAreOneGeometry) {
    std::vector<SolidPointer> balls;
    for (int i = 0; i < 100; ++i) balls.push_back(solid_of(scene::SolidSphere{{static_cast<double>(i), 0, 0}, 0.4}));
    scene::Scene scene = scene_of(balls);
    scene.objects[50].casts_shadow = false;
    scene.objects[70].name = "special";
    const auto compiled = compile(scene, {});
    ASSERT_EQ(5U, compiled->geometries.size());
    EXPECT_EQ(50U, compiled->geometries[0].primitive_count);
    EXPECT_EQ(19U, compiled->geometries[2].primitive_count);
    EXPECT_EQ("special", compiled->geometry_names[3]);
    EXPECT_EQ(kernel::RAY_SHADOW, compiled->geometries[1].hidden_from);
    EXPECT_EQ(100U, compiled->spheres.size());
}

// Catches a plane that hides from some rays put among those that all rays ask.
TEST(CompileSolid, PlanesWithoutShadowAreSolids) {
    scene::Scene scene = scene_of({solid_of(scene::HalfSpace{{0, 1, 0}, 2})});
    scene.objects[0].casts_shadow = false;
    const auto compiled = compile(scene, {});
    ASSERT_EQ(1U, compiled->solids.size());
    EXPECT_EQ(kernel::GEOMETRY_SOLID, compiled->geometries[0].kind);
    EXPECT_TRUE(compiled->bounds.empty());
}

// Catches meshes whose vertices or normals are not carried to their place, and triangles that lose their material.
TEST(CompileSolid, MeshesBecomeTriangles) {
    constexpr std::uint32_t none = scene::SolidMesh::kNoIndex;
    auto mesh = std::make_shared<scene::SolidMesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh->normals = {{0, 1, 1}};
    mesh->triangles = {{{0, 1, 2}, {0, 0, 0}, {none, none, none}, none},
                       {{1, 3, 2}, {none, none, none}, {none, none, none}, 2}};
    auto placed = solid_of(std::shared_ptr<const scene::SolidMesh>(mesh));
    placed->parent_from_shape = {{2, 0, 0}, {0, 4, 0}, {0, 0, 1}, {5, 0, 0}};
    const auto compiled = compile(scene_of({placed}), {});
    ASSERT_EQ(2U, compiled->triangles.size());
    EXPECT_FLOAT_EQ(7, compiled->positions[1].x);
    EXPECT_EQ(1U, compiled->triangles[0].material);
    EXPECT_EQ(2U, compiled->triangles[1].material);
    EXPECT_NEAR(1 / std::sqrt(17), compiled->normals[0].y, 1e-6);  // stretched along y, the normal leans away from it
    EXPECT_NE(0U, compiled->features & kernel::FEATURE_SMOOTH);
}

}  // namespace
}  // namespace sundog
