// SPDX-License-Identifier: Apache-2.0
#include "compile/compile.h"

#include <gtest/gtest.h>

#include "compile/mesh.h"

namespace sundog {
namespace {

scene::Mesh::Triangle triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    constexpr std::uint32_t none = scene::kNone;
    return {{a, b, c}, {none, none, none}, {none, none, none}, 0};
}

/// A unit right triangle in the XY plane, with `copies` triangles without area behind it.
scene::Scene scene_with_degenerates(int copies) {
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
    mesh.triangles = {triangle(0, 1, 2)};
    for (int i = 0; i < copies; ++i) mesh.triangles.push_back(i % 2 ? triangle(0, 1, 3) : triangle(1, 1, 2));
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.objects.push_back({"sheet", {}, mesh, 0, {}});
    return scene;
}

// Catches zero-area triangles that reach the devices, and a warning for each of a million of them.
TEST(Compile, DropsTrianglesWithoutAreaWithOneWarning) {
    std::vector<std::string> warnings;
    const auto compiled =
        compile(scene_with_degenerates(20000), [&](const Diagnostic& d) { warnings.push_back(d.message); });
    EXPECT_EQ(compiled->triangles.size(), 1U);
    ASSERT_EQ(compiled->geometries.size(), 1U);
    EXPECT_EQ(compiled->geometries[0].primitive_count, 1U);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("'sheet'"), std::string::npos);
    EXPECT_NE(warnings[0].find("20000 of 20001"), std::string::npos);
}

// Catches parallel compaction that loses, repeats or reorders triangles across its blocks.
TEST(Compile, KeepsTheOrderOfTriangles) {
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i < 30000; ++i) {
        const auto x = static_cast<float>(i);
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
        mesh.triangles.push_back(i % 7 == 3 ? triangle(3 * i, 3 * i, 3 * i) : triangle(3 * i, 3 * i + 1, 3 * i + 2));
    }
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.objects.push_back({"strip", {}, mesh, 0, {}});
    const auto compiled = compile(scene, {});
    std::vector<std::uint32_t> want;
    for (std::uint32_t i = 0; i < 30000; ++i)
        if (i % 7 != 3) want.push_back(3 * i);
    std::vector<std::uint32_t> got;
    for (const kernel::Triangle& t : compiled->triangles) got.push_back(t.p0);
    EXPECT_EQ(got, want);
}

// Catches a second mesh whose indices still count from the first one's vertices.
TEST(Compile, OffsetsTheIndicesOfLaterMeshes) {
    scene::Scene scene = scene_with_degenerates(0);
    scene.objects.push_back(scene.objects[0]);
    auto& second = *std::get<Boxed<scene::Mesh>>(scene.objects[1].shape);
    second.normals = {{0, 0, 2}, {0, 0, 0}};
    second.triangles[0].normal[0] = second.triangles[0].normal[1] = second.triangles[0].normal[2] = 0;
    second.triangles.push_back(second.triangles[0]);
    second.triangles[1].normal[2] = 1;
    const auto compiled = compile(scene, {});
    ASSERT_EQ(compiled->triangles.size(), 3U);
    EXPECT_EQ(compiled->triangles[1].p1, 5U);
    ASSERT_EQ(compiled->triangle_normals.size(), 3U);
    EXPECT_EQ(compiled->triangle_normals[0].a, kernel::NONE);
    EXPECT_EQ(compiled->triangle_normals[1].a, 0U);
    EXPECT_FLOAT_EQ(compiled->normals[0].z, 1) << "normals are unit vectors";
    EXPECT_EQ(compiled->triangle_normals[2].a, kernel::NONE) << "a normal without direction makes the triangle flat";
    EXPECT_NE(compiled->features & kernel::FEATURE_SMOOTH, 0U);
    EXPECT_EQ(compiled->positions.size(), 9U) << "two meshes of four vertices and the spare element";
}

// Catches empty arrays, which no device can bind, and features of things that no primitive uses.
TEST(Compile, AnEmptySceneHasNoEmptyArrays) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.materials.back().mtl->illum = 3;
    scene.materials.back().mtl->specular = {1, 1, 1};
    const auto compiled = compile(scene, {});
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) EXPECT_FALSE(compiled->name.empty()) << #name;
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
    EXPECT_EQ(compiled->features, 0U);
    EXPECT_TRUE(compiled->bounds.empty());
    EXPECT_EQ(compiled->tables.size(), 256U);
    EXPECT_EQ(compiled->tables[255], 1);
    EXPECT_NEAR(compiled->tables[128], 0.2158605F, 1e-6F);
}

// Catches planes that are not normalised or that name another geometry than their own.
TEST(Compile, AnalyticShapes) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.objects.push_back({"ball", {}, scene::Sphere{{1, 2, 3}, 2}, 0, {}});
    scene.objects.push_back({"dot", {}, scene::Sphere{{1, 2, 3}, 0}, 0, {}});
    scene.objects.push_back({"floor", {}, scene::Plane{{0, 0, 2}, 4}, 0, {}});
    int warnings = 0;
    const auto compiled = compile(scene, [&](const Diagnostic&) { ++warnings; });
    EXPECT_EQ(warnings, 1);
    ASSERT_EQ(compiled->geometries.size(), 2U);
    EXPECT_EQ(compiled->geometry_objects, (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(compiled->planes[0].geometry, 1U);
    EXPECT_FLOAT_EQ(compiled->planes[0].normal.z, 1);
    EXPECT_FLOAT_EQ(compiled->planes[0].offset, 2);
    EXPECT_EQ(compiled->bounds.lower, (Vec3{-1, 0, 1}));
    EXPECT_EQ(compiled->features, kernel::FEATURE_ANALYTIC);
}

/// A tetrahedron around (0.25, 0.25, 0.25) whose corners are written anew for each triangle, as files do.
scene::Mesh tetrahedron() {
    const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    scene::Mesh mesh;
    mesh.positions = {o, y, x, o, x, z, o, z, y, x, y, z};
    mesh.positions[3].x = -0.0F;  // The same place.
    for (std::uint32_t i = 0; i < 4; ++i) mesh.triangles.push_back(triangle(3 * i, 3 * i + 1, 3 * i + 2));
    return mesh;
}

// Catches closed meshes that are looked into for their backs, open or inverted ones that are not, and the eye inside.
TEST(Compile, BacksAreLookedForWhereTheyCanBeSeen) {
    scene::Scene scene;
    scene.materials.emplace_back().principled.emplace();
    scene.objects.push_back({"body", {}, tetrahedron(), 0, {}});
    const auto features = [&](Vec3 eye) {
        FrameOptions options;
        options.camera = kernel::Camera{{eye.x, eye.y, eye.z}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
        return make_frame(scene, *compile(scene, {}), options).params.features & kernel::FEATURE_ONE_SIDED;
    };
    EXPECT_TRUE(is_closed(tetrahedron()));
    EXPECT_EQ(features({0, -5, 0}), 0U);
    EXPECT_NE(features({0.2F, 0.2F, 0.2F}), 0U);
    scene::Mesh& mesh = *std::get<Boxed<scene::Mesh>>(scene.objects[0].shape);
    mesh.triangles.pop_back();
    EXPECT_FALSE(is_closed(mesh));
    EXPECT_NE(features({0, -5, 0}), 0U);
    mesh = tetrahedron();
    for (scene::Mesh::Triangle& t : mesh.triangles) std::swap(t.position[1], t.position[2]);
    EXPECT_FALSE(is_closed(mesh));
    scene.materials[0].principled->double_sided = true;
    EXPECT_EQ(features({0.2F, 0.2F, 0.2F}), 0U);
}

}  // namespace
}  // namespace sundog
