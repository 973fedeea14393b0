// SPDX-License-Identifier: Apache-2.0
#include "bake/bake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>

#include "bake/write_glb.h"
#include "bake_scenes.h"
#include "base/test_folder.h"

namespace sundog::bake {
namespace {

using namespace test;

// In a closed room whose walls shine with e and reflect the share r, radiosity is e / (1 - r) everywhere, up to its
// corners. Catches vertices that see the other side of a wall, and light that is counted without its pi.
TEST(Bake, AFurnace) {
    scene::Scene s = empty_scene();
    add_shape(s, scene::Box{{-1, -1, -1}, {1, 1, 1}}, add_material(s, shining({0.5F, 0.25F, 0}, {0.6F, 0.6F, 0.6F})));
    BakeOptions options;
    options.longest_edge = 0.5F;
    options.samples = 1024;
    const BakedScene room = baked(s, options);
    ASSERT_EQ(room.parts.size(), 1U);
    EXPECT_GT(room.vertices, 150U);
    double mean = 0;
    for (const Vec3& light : room.parts[0].light) {
        mean += light.x / static_cast<double>(room.vertices);
        EXPECT_NEAR(light.x, 1.25F, 0.12F);
        EXPECT_NEAR(light.y, light.x / 2, 1e-4F);
        EXPECT_EQ(light.z, 0);
    }
    EXPECT_NEAR(mean, 1.25, 0.01);
}

// In such a room a matt ball is as bright as the room, times what it reflects. Catches vertices between a ball's own
// ones that lie below it, where rays begin inside, and rays that are lost because they were taken for coherent.
TEST(Bake, ABallInAFurnace) {
    scene::Scene s = empty_scene();
    add_shape(s, scene::Box{{-2, -2, -2}, {2, 2, 2}}, add_material(s, shining({1, 1, 1}, {0, 0, 0})));
    add_shape(s, scene::Sphere{{0.3F, 0, 0}, 0.75F}, add_material(s, matt({0.9F, 0.9F, 0.9F})));
    BakeOptions options;
    options.longest_edge = 0.15F;
    options.samples = 16;
    for (const Method method : {Method::paths, Method::radiosity}) {
        options.method = method;
        const BakedScene scene = baked(s, options);
        const Part& ball = scene.parts.back();
        EXPECT_GT(ball.positions.size(), 500U);
        for (std::size_t i = 0; i < ball.positions.size(); ++i) {
            const Vec3 out = (ball.positions[i] - Vec3{0.3F, 0, 0}) / 0.75F;
            EXPECT_NEAR(length(out), 1, 1e-5F);
            EXPECT_GT(dot(out, ball.normals[i]), 0.9999F);
            EXPECT_NEAR(ball.light[i].x, 0.9F, 0.03F);
        }
    }
}

// Opposite a shining rectangle's middle, light is r L times the share of the view that it takes (Howell, A Catalog of
// Radiation Heat Transfer Configuration Factors, B-3). Catches a measure of light that differs from form factors'.
TEST(Bake, AFormFactor) {
    scene::Scene s = empty_scene();
    add_quad(s, {-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, add_material(s, shining({3, 3, 3}, {0, 0, 0})));
    // Written the wrong way round: its back is what is lit.
    add_quad(s, {-4, -4, 0}, {-4, 4, 0}, {4, 4, 0}, {4, -4, 0}, add_material(s, matt({0.5F, 0.5F, 0.5F})));
    BakeOptions options;
    options.longest_edge = 0.4F;
    options.samples = 1024;
    const BakedScene scene = baked(s, options);
    ASSERT_EQ(scene.parts.size(), 2U);
    const double a = 0.5, r = std::sqrt(1 + a * a);
    const double share = 4 / (2 * std::numbers::pi) * 2 * (a / r * std::atan(a / r));
    const Part& floor = scene.parts[1];
    int seen = 0;
    for (std::size_t i = 0; i < floor.positions.size(); ++i) {
        EXPECT_GT(floor.normals[i].z, 0.99F);
        if (length(floor.positions[i]) > 0.01F) continue;
        EXPECT_NEAR(floor.light[i].x, 0.5 * 3 * share, 0.02 * share);
        ++seen;
    }
    EXPECT_GT(seen, 0);
}

// Catches triangles that are lost or overlap where edges are divided, and edges that stay too long.
TEST(Bake, PatchesCoverWhatTheyDivide) {
    scene::Scene s = empty_scene();
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {5, 0, 0}, {0.3F, 2, 0}, {5, 3, 0}};
    constexpr scene::Index n = scene::kNone;
    mesh.triangles = {{{0, 1, 2}, {n, n, n}, {n, n, n}, 0}, {{1, 3, 2}, {n, n, n}, {n, n, n}, 0}};
    add_shape(s, mesh, add_material(s, matt({1, 1, 1})));
    const std::vector<Part> parts = parts_of(s, 0, 0.3F, {});
    ASSERT_EQ(parts.size(), 1U);
    double area = 0;
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : parts[0].triangles) {
        const Vec3 a = parts[0].positions[t[0]], b = parts[0].positions[t[1]], c = parts[0].positions[t[2]];
        for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
        EXPECT_LE(std::max({length(a - b), length(b - c), length(c - a)}), 0.3F);
        area += cross(b - a, c - a).z / 2;
    }
    EXPECT_NEAR(area, (cross(Vec3{5, 0, 0}, Vec3{0.3F, 2, 0}).z + cross(Vec3{0, 3, 0}, Vec3{-4.7F, 2, 0}).z) / 2, 1e-3);
    // An edge is two triangles', or one's on the rim: more or other middles would be cracks.
    for (const auto& edge : edges) {
        const auto on_rim = [&](std::uint32_t v) {
            const Vec3 p = parts[0].positions[v];
            const auto beside = [&](Vec3 a, Vec3 b) { return length(cross(p - a, b - a)) < 1e-4F * length(b - a); };
            return std::array{beside({0, 0, 0}, {5, 0, 0}), beside({5, 0, 0}, {5, 3, 0}),
                              beside({5, 3, 0}, {0.3F, 2, 0}), beside({0.3F, 2, 0}, {0, 0, 0})};
        };
        const auto a = on_rim(edge.first), b = on_rim(edge.second);
        bool rim = false;
        for (std::size_t k = 0; k < 4; ++k) rim |= a[k] && b[k];
        EXPECT_EQ(edges.count(edge), rim ? 1U : 2U);
    }
}

// Catches sums that depend on who was first.
TEST(Bake, ThreadsDontChangeBits) {
    const scene::Scene s = cornell_box();
    BakeOptions options;
    options.longest_edge = 1;
    options.samples = 4;
    const BakedScene one = baked(s, options, 1), three = baked(s, options, 3);
    ASSERT_EQ(one.parts.size(), three.parts.size());
    for (std::size_t p = 0; p < one.parts.size(); ++p) {
        ASSERT_EQ(one.parts[p].light.size(), three.parts[p].light.size());
        for (std::size_t i = 0; i < one.parts[p].light.size(); ++i)
            EXPECT_EQ(length(one.parts[p].light[i] - three.parts[p].light[i]), 0);
    }
}

/// The mean of a picture's pixels.
Vec3 mean_of(const Film& film) {
    Vec3 sum{0, 0, 0};
    for (int y = 0; y < film.bounds.height(); ++y)
        for (int x = 0; x < film.bounds.width(); ++x) sum = sum + film.mean(x, y);
    return sum * (1.0F / static_cast<float>(film.bounds.width() * film.bounds.height()));
}

// A matt room with a lamp of triangles: what is written, read again and seen without any light looks, on average, as
// paths see the room itself. Catches light that is lost on its way through the file, axes and cameras that are
// turned, and triangles that are missing.
TEST(Bake, IsReadAsWhatPathsSee) {
    scene::Scene s = empty_scene();
    const scene::Index white = add_material(s, matt({0.7F, 0.7F, 0.7F}));
    add_quad(s, {-2, 0, -2}, {2, 0, -2}, {2, 5, -2}, {-2, 5, -2}, white);
    add_quad(s, {-2, 5, -2}, {2, 5, -2}, {2, 5, 2}, {-2, 5, 2}, add_material(s, matt({0.7F, 0.2F, 0.1F})));
    add_quad(s, {-2, 0, -2}, {-2, 5, -2}, {-2, 5, 2}, {-2, 0, 2}, white);
    add_shape(s, scene::Sphere{{0.7F, 3, -1.2F}, 0.8F}, add_material(s, matt({0.2F, 0.3F, 0.7F})));
    add_quad(s, {-1, 2, 2.5F}, {-1, 4, 2.5F}, {1, 4, 2.5F}, {1, 2, 2.5F},
             add_material(s, shining({9, 9, 9}, {0, 0, 0})));
    BakeOptions options;
    options.longest_edge = 0.2F;
    const BakedScene scene = baked(s, options);
    const TestFolder folder;
    const std::filesystem::path file = folder.path() / "room.glb";
    FrameOptions view = size(48, 48);
    write_glb(file, s, scene, make_frame(s, *compile(s, {}), view));

    const scene::Scene read = import::import_scene(file, {});
    const auto device = make_cpu_device({.threads = 2});
    const Film walked = render_on(*device, read, view, 4).film;
    view.integrator = kernel::INTEGRATOR_PATH;
    const Film traced = render_on(*device, s, view, 64).film;
    const Vec3 a = mean_of(walked), b = mean_of(traced);
    EXPECT_NEAR(a.x, b.x, 0.03F * b.x);
    EXPECT_NEAR(a.y, b.y, 0.03F * b.y);
    EXPECT_NEAR(a.z, b.z, 0.03F * b.z);
    // Left and right, above and below are where they were.
    double apart = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) apart += std::abs(walked.mean(x, y).x - traced.mean(x, y).x);
    EXPECT_LT(apart / (48 * 48), 0.12 * b.x);
}

}  // namespace
}  // namespace sundog::bake
