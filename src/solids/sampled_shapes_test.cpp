// SPDX-License-Identifier: Apache-2.0
// Meshes, polygons and height fields.
#include <gtest/gtest.h>

#include <cmath>

#include "solids/test_solids.h"

namespace sundog::solids::tests {
namespace {

constexpr std::uint32_t kNone = scene::SolidMesh::kNoIndex;

scene::SolidMesh::Triangle triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return {{a, b, c}, {kNone, kNone, kNone}, {kNone, kNone, kNone}, kNone};
}

std::shared_ptr<scene::SolidMesh> octahedron(bool solid) {
    auto mesh = std::make_shared<scene::SolidMesh>();
    mesh->positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const std::uint32_t x : {0U, 1U})
        for (const std::uint32_t y : {2U, 3U})
            for (const std::uint32_t z : {4U, 5U}) mesh->triangles.push_back(triangle(x, y, z));
    mesh->has_inside = solid;
    mesh->inside_vector = {0.2, 1, 0.1};
    return mesh;
}

scene::Solid solid_mesh(const std::shared_ptr<const scene::SolidMesh>& mesh) { return solid_of(mesh); }

// Catches parity that is lost on shared edges and corners, which rays through the grid of midpoints meet exactly.
TEST(MeshShape, ASolidMeshIsWatertight) {
    const auto solid = compile_solid(solid_mesh(octahedron(true)), 0);
    for (int i = -8; i <= 8; ++i) {
        for (int k = -8; k <= 8; ++k) {
            const double x = i / 8.0;
            const double y = k / 8.0;
            const double reach = 1 - std::abs(x) - std::abs(y);
            if (reach == 0) continue;  // along the rim both surfaces are at one place
            const std::vector<Hit> hits = all_hits(*solid, {{x, y, -5}, {0, 0, 1}});
            EXPECT_EQ(0U, hits.size() % 2) << x << " " << y;
            if (reach > 0) {
                ASSERT_EQ(2U, hits.size()) << x << " " << y;
                EXPECT_NEAR(5 - reach, hits[0].t, 1e-12);
                EXPECT_NEAR(5 + reach, hits[1].t, 1e-12);
            }
        }
    }
    scene::Solid turned_solid = solid_mesh(octahedron(true));
    turned_solid.parent_from_shape = turned(normalize(Vec3d{1, 2, 3}), 1);
    expect_solid_properties(turned_solid, 1);
    expect_normals_agree(turned_solid, 2);
}

// Catches a mesh without inside_vector that has an inside all the same, or that can't be cut.
TEST(MeshShape, WithoutAnInsideItIsASurface) {
    const auto surface = compile_solid(solid_mesh(octahedron(false)), 0);
    EXPECT_FALSE(surface->inside({0, 0, 0}));
    EXPECT_EQ(2U, all_hits(*surface, {{0.1, 0.2, -5}, {0, 0, 1}}).size());
    const auto cut = compile_solid(*intersected({pointer_to(std::shared_ptr<const scene::SolidMesh>(octahedron(false))),
                                                 pointer_to(scene::HalfSpace{{0, 0, 1}, 0})}),
                                   0);
    EXPECT_EQ(1U, all_hits(*cut, {{0.1, 0.2, -5}, {0, 0, 1}}).size());
}

// Catches wrong interpolation of normals and texture coordinates, and a triangle's own material.
TEST(MeshShape, CornersAreInterpolated) {
    auto mesh = std::make_shared<scene::SolidMesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->normals = {{-1, 0, -1}, {1, 0, -1}, {0, 0, -1}};
    mesh->uvs = {{0, 0}, {2, 0}, {0, 4}};
    mesh->triangles = {{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, 6}};
    const auto hit = compile_solid(solid_mesh(mesh), 1)->nearest({{0.5, 0.25, -1}, {0, 0, 1}}, {});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(1, hit->u, 1e-12);
    EXPECT_NEAR(1, hit->v, 1e-12);
    EXPECT_EQ(6U, hit->material);
    EXPECT_NEAR(0.25, hit->normal.x / -hit->normal.z, 1e-9);
}

// Catches the even-odd rule taken wrongly, and points on the outlines' corners' heights counted twice.
TEST(PolygonShape, InnerOutlinesAreHoles) {
    const scene::FlatPolygon letter_p{{{{0, 0, 0}, {0, 6, 0}, {4, 6, 0}, {4, 3, 0}, {1, 3, 0}, {1, 0, 0}},
                                       {{1, 4, 0}, {1, 5, 0}, {3, 5, 0}, {3, 4, 0}}}};
    const auto solid = compile_solid(solid_of(letter_p), 0);
    const auto met = [&](double x, double y) { return solid->nearest({{x, y, -3}, {0, 0, 1}}, {}).has_value(); };
    EXPECT_TRUE(met(0.5, 0.5));
    EXPECT_TRUE(met(3.5, 4.5));
    EXPECT_TRUE(met(0.5, 4));
    EXPECT_TRUE(met(0.5, 3));
    EXPECT_FALSE(met(2, 4.5));
    EXPECT_FALSE(met(2, 2));
    EXPECT_FALSE(met(5, 3));
    EXPECT_FALSE(solid->inside({0.5, 0.5, 0}));
    EXPECT_THROW(compile_solid(solid_of(scene::FlatPolygon{{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}}), 0), InputError);
}

scene::HeightField hills(std::uint32_t width, std::uint32_t height, unsigned seed) {
    RandomRays random(seed);
    auto heights = std::make_shared<std::vector<float>>();
    for (std::uint32_t i = 0; i < width * height; ++i) heights->push_back(static_cast<float>(random.number(0.1, 0.9)));
    scene::HeightField field;
    field.width = width;
    field.height = height;
    field.heights = heights;
    return field;
}

// Catches cells that are skipped, borders met twice, and an inside that the surface doesn't bound. Walls and bottom are
// not to be seen, so only rays from above are followed.
TEST(HeightFieldShape, TheSurfacePartsGroundFromAir) {
    for (const auto& [width, height] : {std::pair{2U, 2U}, {3U, 7U}, {33U, 20U}}) {
        const auto solid = compile_solid(solid_of(hills(width, height, width)), 0);
        RandomRays random(7);
        int wrong = 0;
        int met = 0;
        for (int i = 0; i < 500; ++i) {
            const Vec3d from{random.number(0.05, 0.95), 1.5, random.number(0.05, 0.95)};
            const Vec3d to{random.number(0.05, 0.95), 0.01, random.number(0.05, 0.95)};
            const Ray ray{from, to - from};
            const std::vector<Hit> hits = all_hits(*solid, ray, {0, 1});
            if (hits.size() % 2 != 1) ++wrong;  // from the air to the ground
            double last = 0;
            bool below = false;
            for (const Hit& hit : hits) {
                ++met;
                if (solid->inside(ray.at(0.5 * (last + hit.t))) != below) ++wrong;
                if ((dot(hit.normal, ray.direction) < 0) == below) ++wrong;
                below = !below;
                last = hit.t;
            }
        }
        EXPECT_EQ(0, wrong);
        EXPECT_GE(met, 500);
    }
}

// Catches smoothed normals that are turned into the face: rays that go on from there meet the same place without end.
TEST(HeightFieldShape, SmoothedNormalsLeadToTheSideThatTheRayCameFrom) {
    scene::HeightField field = hills(30, 30, 5);
    field.smooth = true;
    const auto solid = compile_solid(solid_of(field), 0);
    RandomRays random(8);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        // Nearly level, along walls that the smoothed normals look over.
        const Vec3d from{random.number(0, 1), random.number(0.3, 0.7), -0.1};
        const Ray ray{from, {random.number(-0.3, 0.3), random.number(-0.1, 0.1), 1}};
        for (const Hit& hit : all_hits(*solid, ray)) {
            const bool enters = !solid->inside(ray.at(hit.t - 1e-7));
            if (enters == solid->inside(ray.at(hit.t + 1e-7))) ++met;
            else continue;
            const Vec3d to_eye = hit.normal * (enters ? 1e-9 : -1e-9);
            EXPECT_EQ(!enters, solid->inside(ray.at(hit.t) + to_eye));
            EXPECT_EQ(enters, solid->inside(ray.at(hit.t) - to_eye));
        }
    }
    EXPECT_GE(met, 5000);
}

// Catches rows taken from the wrong end, and a diagonal in the wrong direction.
TEST(HeightFieldShape, PixelsAreWhereTheyBelong) {
    scene::HeightField field = hills(2, 2, 1);
    field.heights = std::make_shared<std::vector<float>>(std::vector<float>{1.0F, 0.25F, 0.25F, 0.5F});
    const auto solid = compile_solid(solid_of(field), 0);
    const auto height = [&](double x, double z) { return 2 - solid->nearest({{x, 2, z}, {0, -1, 0}}, {})->t; };
    EXPECT_NEAR(1, height(1e-9, 1 - 1e-9), 1e-6);    // the picture's upper left
    EXPECT_NEAR(0.5, height(1 - 1e-9, 1e-9), 1e-6);  // lower right
    EXPECT_NEAR(0.75, height(0.5, 0.5), 1e-6);       // on the diagonal between these two
    EXPECT_NEAR(0.875, height(0.25, 0.75), 1e-6);
}

// Catches ground under the water.
TEST(HeightFieldShape, NothingIsUnderTheWater) {
    scene::HeightField field = hills(20, 20, 3);
    field.water_level = 0.5;
    const auto solid = compile_solid(solid_of(field), 0);
    RandomRays random(4);
    int dry = 0;
    for (int i = 0; i < 200; ++i) {
        const auto hit = solid->nearest({{random.number(0, 1), 2, random.number(0, 1)}, {0, -1, 0}}, {});
        if (!hit) continue;
        ++dry;
        EXPECT_LT(hit->t, 1.5);
    }
    EXPECT_GT(dry, 50);
    EXPECT_LT(dry, 150);
    EXPECT_FALSE(solid->inside({0.5, 0.4, 0.5}));
}

}  // namespace
}  // namespace sundog::solids::tests
