// SPDX-License-Identifier: Apache-2.0
#include "import/obj/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sundog::import {
namespace {

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - a) * 0.5F; }

struct Cut {
    std::size_t triangles = 0;
    float area_sum = 0;    ///< Sum of the triangles' areas.
    Vec3 area_vector_sum;  ///< Sum of their oriented areas: equals the polygon's whatever the cut.
    bool against = false;  ///< Some triangle faces the other way.
    bool approximate = false;
};

Cut cut(const std::vector<Vec3>& polygon) {
    PolygonCutter cutter;
    Cut result;
    Vec3 normal;
    for (std::size_t i = 2; i < polygon.size(); ++i) normal += area_vector(polygon[0], polygon[i - 1], polygon[i]);
    for (const auto& [a, b, c] : cutter.cut(polygon)) {
        const Vec3 area = area_vector(polygon[a], polygon[b], polygon[c]);
        ++result.triangles;
        result.area_sum += length(area);
        result.area_vector_sum += area;
        result.against |= dot(area, normal) < -1e-5F * dot(normal, normal);
    }
    result.approximate = cutter.approximate();
    return result;
}

/// A polygon in a tilted plane, so that no coordinate can be left out by chance.
std::vector<Vec3> tilted(const std::vector<Vec2>& flat) {
    std::vector<Vec3> polygon;
    const Affine3 tilt = rotation(normalize(Vec3{1, 2, 3}), 40);
    for (const Vec2 p : flat) polygon.push_back(transform_point(tilt, {p.x, p.y, 5}));
    return polygon;
}

/// Triangles that neither overlap nor leave out anything have the polygon's area in sum.
void expect_exact(const std::vector<Vec2>& flat, float area) {
    const Cut result = cut(tilted(flat));
    EXPECT_EQ(result.triangles, flat.size() - 2);
    EXPECT_NEAR(result.area_sum, area, 1e-3F * area);
    EXPECT_NEAR(length(result.area_vector_sum), area, 1e-3F * area);
    EXPECT_FALSE(result.against);
    EXPECT_FALSE(result.approximate);
}

// Catches a fan where the polygon is concave: the triangles would cover the dents.
TEST(PolygonCutter, ConcavePolygonsKeepTheirArea) {
    expect_exact({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, 4);                                  // arrow head
    expect_exact({{1, 1}, {0, 4}, {0, 0}, {4, 0}}, 4);                                  // the same from its dent
    expect_exact({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 7);  // U
    expect_exact({{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 0}}, 7);  // U, clockwise
    std::vector<Vec2> star;
    for (int i = 0; i < 1000; ++i) {
        const float radius = i % 2 == 0 ? 2.0F : 1.0F;
        const float angle = 2 * kPi * static_cast<float>(i) / 1000;
        star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    expect_exact(star, 1000 * 0.5F * 2 * std::sin(2 * kPi / 1000));
}

// Catches convex polygons whose straight corners turn into slivers without area while there is another way.
TEST(PolygonCutter, StraightCornersGetAreas) {
    const std::vector<Vec3> square = tilted({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}});
    PolygonCutter cutter;
    for (const auto& [a, b, c] : cutter.cut(square))
        EXPECT_GT(length(area_vector(square[a], square[b], square[c])), 0.1F);
    const std::vector<Vec3> kite = tilted({{0, 0}, {1, 0}, {2, 0}, {1, 2}});
    for (const auto& [a, b, c] : cutter.cut(kite)) EXPECT_GT(length(area_vector(kite[a], kite[b], kite[c])), 0.1F);
}

// Catches a search for ears that misses a hole which is joined to the outline by a doubled edge (how exporters write
// holes, since OBJ has none).
TEST(PolygonCutter, BridgedHolesStayHoles) {
    expect_exact({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}, 32);
}

// Catches endless loops and wrong counts where there is no right answer.
TEST(PolygonCutter, DegenerateInputGivesTheRightCount) {
    const std::vector<std::vector<Vec2>> cases = {
        {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}},          // a point
        {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 0}},  // a line
        {{0, 0}, {2, 2}, {2, 0}, {0, 2}, {1, 5}},          // crosses itself
        {{0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}, {0, 0}},  // doubled corners
        {{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}},  // a spike
    };
    for (const std::vector<Vec2>& flat : cases) EXPECT_EQ(cut(tilted(flat)).triangles, flat.size() - 2);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1, 1);
    for (int i = 0; i < 300; ++i) {
        std::vector<Vec3> polygon(3 + random() % 40);
        for (Vec3& p : polygon) p = {place(random), place(random), place(random)};
        EXPECT_EQ(cut(polygon).triangles, polygon.size() - 2);
    }
}

// Catches time that grows with the square or cube of a hostile polygon's corners.
TEST(PolygonCutter, HugePolygonsEnd) {
    std::vector<Vec2> comb;
    for (int i = 0; i < 50000; ++i) comb.push_back({static_cast<float>(i), i % 2 == 0 ? 1.0F : 100.0F});
    comb.push_back({50000, -1});
    comb.push_back({0, -1});
    EXPECT_EQ(cut(tilted(comb)).triangles, comb.size() - 2);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-1, 1);
    std::vector<Vec3> tangle(20000);
    for (Vec3& p : tangle) p = {place(random), place(random), 0};
    const Cut result = cut(tangle);
    EXPECT_EQ(result.triangles, tangle.size() - 2);
    EXPECT_TRUE(result.approximate);
}

}  // namespace
}  // namespace sundog::import
