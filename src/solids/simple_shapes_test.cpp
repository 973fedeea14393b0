// SPDX-License-Identifier: Apache-2.0
// Shapes whose crossings have formulas or short polynomials.
#include <gtest/gtest.h>

#include <cmath>

#include "solids/test_solids.h"

namespace sundog::solids::tests {
namespace {

const Affine3d kPlacement = turned(normalize(Vec3d{1, 2, 3}), 0.7, {0.1, -0.2, 0.15}) * scaled({1.1, 0.7, 0.9});

template <class T>
scene::Solid placed(T shape) {
    scene::Solid solid = solid_of(std::move(shape));
    solid.parent_from_shape = kPlacement;
    return solid;
}

scene::Polynomial polynomial(std::vector<scene::Polynomial::Term> terms) { return {4, std::move(terms)}; }

/// Along x at height y, depth z: where the first two surfaces are.
void expect_interval(const scene::Solid& solid, double y, double z, double lower, double upper, double tolerance) {
    const auto compiled = compile_solid(solid, 0);
    const std::vector<Hit> hits = all_hits(*compiled, {{-10, y, z}, {1, 0, 0}});
    ASSERT_EQ(2U, hits.size());
    EXPECT_NEAR(lower, hits[0].t - 10, tolerance);
    EXPECT_NEAR(upper, hits[1].t - 10, tolerance);
}

// Catches wrong formulas: chords whose ends are known.
TEST(SimpleShapes, ChordsAreWhereTheFormulasSay) {
    expect_interval(solid_of(scene::SolidSphere{{1, 0, 0}, 2}), 1, 0, 1 - std::sqrt(3), 1 + std::sqrt(3), 1e-13);
    expect_interval(solid_of(scene::SolidBox{{-1, -1, -1}, {3, 1, 1}}), 0.5, 0, -1, 3, 1e-13);
    expect_interval(solid_of(scene::SolidCone{{0, -1, 0}, {0, 1, 0}, 2, 0}), 0.5, 0.25, -std::sqrt(0.25 - 0.0625),
                    std::sqrt(0.25 - 0.0625), 1e-13);
    expect_interval(solid_of(scene::SolidCone{{-3, 0, 0}, {4, 0, 0}, 1, 1}), 0.5, 0.5, -3, 4, 1e-13);
    // A cone along the ray: enters through the side where the radius is 0.5, leaves through the base.
    expect_interval(solid_of(scene::SolidCone{{2, 0, 0}, {-2, 0, 0}, 2, 0}), 0.5, 0, -1, 2, 1e-13);
}

// Catches corners taken the wrong way round (POV-Ray lets a box name any two opposite ones).
TEST(SimpleShapes, ABoxTakesItsCornersInAnyOrder) {
    expect_interval(solid_of(scene::SolidBox{{3, -1, 1}, {-1, 1, -1}}), 0.5, 0, -1, 3, 1e-13);
}

// Catches normals, bounds or insides that don't fit the crossings, under a placement that stretches and turns.
TEST(SimpleShapes, Properties) {
    expect_solid_properties(placed(scene::SolidSphere{{0.1, 0, 0}, 0.9}), 1);
    expect_solid_properties(placed(scene::SolidBox{{-0.8, -0.5, -0.3}, {0.4, 0.6, 0.9}}), 2);
    expect_solid_properties(placed(scene::SolidCone{{-0.5, -0.8, 0}, {0.6, 0.7, 0.1}, 0.8, 0.2}), 3);
    expect_solid_properties(placed(scene::SolidCone{{-0.5, -0.8, 0}, {0.6, 0.7, 0.1}, 0, 0.8}), 4);
    expect_solid_properties(placed(scene::SolidCone{{0, -0.8, 0}, {0, 0.7, 0.1}, 0.6, 0.6}), 5);
    expect_solid_properties(placed(scene::HalfSpace{normalize(Vec3d{1, 2, -1}), 0.2}), 6);
    expect_solid_properties(placed(scene::Torus{0.8, 0.3}), 7);
    expect_solid_properties(placed(scene::Torus{0.4, 0.6}), 8);
    for (unsigned seed = 10; seed < 20; ++seed) {
        RandomRays random(seed);
        const double radius = random.number(0.05, 0.5);
        expect_solid_properties(placed(scene::Torus{random.number(0.5, 1), radius}), seed);
    }
}

// Catches an open cone's missing end counted as a surface, or its inside lost.
TEST(SimpleShapes, AnOpenConeHasNoEndsButAnInside) {
    scene::SolidCone tube{{0, -1, 0}, {0, 1, 0}, 1, 1, true};
    const auto compiled = compile_solid(solid_of(tube), 0);
    EXPECT_TRUE(compiled->inside({0.5, 0.5, 0}));
    EXPECT_FALSE(compiled->nearest({{0.5, -5, 0}, {0, 1, 0}}, {}));
    const auto hit = compiled->nearest({{0.5, -5, 0}, {0.1, 1, 0}}, {});
    ASSERT_TRUE(hit);  // through the open end, from inside onto the wall
    EXPECT_NEAR(5, hit->t, 1e-12);
    EXPECT_GT(dot(hit->normal, Vec3d{0.1, 1, 0}), 0);
}

// Catches a wrong gradient.
TEST(SimpleShapes, NormalsPartInsideFromOutside) {
    expect_normals_agree(placed(scene::SolidSphere{{0.1, 0, 0}, 0.9}), 1);
    expect_normals_agree(placed(scene::SolidBox{{-0.8, -0.5, -0.3}, {0.4, 0.6, 0.9}}), 2);
    expect_normals_agree(placed(scene::SolidCone{{-0.5, -0.8, 0}, {0.6, 0.7, 0.1}, 0.8, 0.2}), 3);
    expect_normals_agree(placed(scene::Torus{0.8, 0.3}), 4);
}

// Catches lost roots of rays that lie in the plane of the ring, and those that graze its rim from outside or inside.
TEST(SimpleShapes, ATorusSeenEdgeOn) {
    const auto torus = compile_solid(solid_of(scene::Torus{1, 0.25}), 0);
    for (int i = -1000; i <= 1000; ++i) {
        const double z = i * 0.00125 * 0.9999999;
        const std::vector<Hit> hits = all_hits(*torus, {{-5, 0, z}, {1, 0, 0}});
        const double outer = std::sqrt(1.25 * 1.25 - z * z);
        ASSERT_EQ(std::abs(z) < 0.75 ? 4U : 2U, hits.size()) << z;
        EXPECT_NEAR(5 - outer, hits.front().t, 1e-9);
        EXPECT_NEAR(5 + outer, hits.back().t, 1e-9);
        if (hits.size() == 4) {
            EXPECT_NEAR(5 - std::sqrt(0.75 * 0.75 - z * z), hits[1].t, 1e-8);
        }
    }
    // Just below the top circle: two short passages.
    for (const double gap : {1e-3, 1e-5, 1e-7, 1e-9}) {
        EXPECT_EQ(4U, all_hits(*torus, {{-5, 0.25 - gap, 0.1}, {1, 0, 0}}).size()) << gap;
        EXPECT_EQ(0U, all_hits(*torus, {{-5, 0.25 + gap, 0.1}, {1, 0, 0}}).size()) << gap;
    }
}

// Catches precision lost far away: a torus a million of its sizes from the ray's origin.
TEST(SimpleShapes, FarAwayAndTiny) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        scene::Solid solid = solid_of(scene::Torus{1, 0.25});
        solid.parent_from_shape = scaled({scale, scale, scale});
        const auto torus = compile_solid(solid, 0);
        const std::vector<Hit> hits = all_hits(*torus, {{0, 0, -1e5 * scale}, {0, 0, 1}});
        ASSERT_EQ(4U, hits.size()) << scale;
        EXPECT_NEAR(-1.25, hits[0].t / scale - 1e5, 1e-7);
        EXPECT_NEAR(-0.75, hits[1].t / scale - 1e5, 1e-7);
    }
}

// Catches wrong expansion along the ray: the same torus and sphere as polynomials of order 4.
TEST(SimpleShapes, APolynomialAgreesWithTheShapeItDescribes) {
    const double major = 0.8, minor = 0.3;
    const double k = major * major - minor * minor;
    // About the z axis: about the y axis it would be taken for the torus that it is.
    const scene::Polynomial quartic = polynomial({{4, 0, 0, 1},
                                                  {0, 4, 0, 1},
                                                  {0, 0, 4, 1},
                                                  {2, 2, 0, 2},
                                                  {2, 0, 2, 2},
                                                  {0, 2, 2, 2},
                                                  {2, 0, 0, 2 * k - 4 * major * major},
                                                  {0, 2, 0, 2 * k - 4 * major * major},
                                                  {0, 0, 2, 2 * k},
                                                  {0, 0, 0, k * k}});
    const auto a = compile_solid(*pointer_to(quartic), 0);
    const auto b = compile_solid(*moved(pointer_to(scene::Torus{major, minor}), turned({1, 0, 0}, std::acos(0.0))), 0);
    RandomRays random(3);
    for (int i = 0; i < 500; ++i) {
        const Ray ray = random.ray(2);
        const std::vector<Hit> hits_a = all_hits(*a, ray);
        const std::vector<Hit> hits_b = all_hits(*b, ray);
        ASSERT_EQ(hits_b.size(), hits_a.size()) << i;
        for (std::size_t n = 0; n < hits_a.size(); ++n) {
            EXPECT_NEAR(hits_b[n].t, hits_a[n].t, 1e-7);
            EXPECT_GT(dot(hits_a[n].normal, hits_b[n].normal), 1 - 1e-6);
        }
    }
}

// Catches quadrics whose leading coefficient vanishes along some rays, and their bounds.
TEST(SimpleShapes, Quadrics) {
    const scene::Polynomial paraboloid = polynomial({{2, 0, 0, 1}, {0, 0, 2, 1}, {0, 1, 0, -1}});
    expect_solid_properties(placed(paraboloid), 1);
    const auto compiled = compile_solid(solid_of(paraboloid), 0);
    const std::vector<Hit> hits = all_hits(*compiled, {{0.5, -3, 0}, {0, 1, 0}});
    ASSERT_EQ(1U, hits.size());
    EXPECT_NEAR(3.25, hits[0].t, 1e-12);
    expect_solid_properties(placed(polynomial({{2, 0, 0, 1}, {0, 2, 0, -1}, {0, 0, 2, 1}, {0, 0, 0, -0.1}})), 2);
    expect_solid_properties(placed(polynomial({{1, 1, 0, 1}, {0, 0, 2, 1}, {0, 0, 0, -0.1}})), 3);
    const auto ellipsoid = compile_solid(
        solid_of(polynomial({{2, 0, 0, 1}, {0, 2, 0, 4}, {0, 0, 2, 1}, {1, 0, 0, -2}, {0, 0, 0, 0.75}})), 0);
    EXPECT_NEAR(0.5, ellipsoid->bounds().lower.x, 1e-9);
    EXPECT_NEAR(0.25, ellipsoid->bounds().upper.y, 1e-9);
}

// Catches lost roots of higher orders: a sextic's properties, and an order of 12.
// Catches bounds of closed polynomials that cut something off, or are far too wide: a torus written as a quartic, moved
// off the origin by its odd terms, and one of the sixth order.
TEST(SimpleShapes, ClosedPolynomialsHaveFiniteBounds) {
    const auto torus = polynomial({{4, 0, 0, 1},
                                   {0, 4, 0, 1},
                                   {0, 0, 4, 1},
                                   {2, 2, 0, 2},
                                   {2, 0, 2, 2},
                                   {0, 2, 2, 2},
                                   {2, 0, 0, -2 * (64 + 2.25)},
                                   {0, 0, 2, -2 * (64 + 2.25)},
                                   {0, 2, 0, 2 * (64 - 2.25)},
                                   {0, 0, 0, (64 - 2.25) * (64 - 2.25)}});
    const auto expect_bounds = [](const scene::Polynomial& p, Vec3d lower, Vec3d upper) {
        const Bounds3d b = compile_solid(placed(p), 0)->bounds();
        const double room = 0.3 * length(upper - lower);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_LE(b.lower[axis], lower[axis]) << axis;
            EXPECT_GE(b.lower[axis], lower[axis] - room) << axis;
            EXPECT_GE(b.upper[axis], upper[axis]) << axis;
            EXPECT_LE(b.upper[axis], upper[axis] + room) << axis;
        }
    };
    expect_bounds(torus, {-9.5, -1.5, -9.5}, {9.5, 1.5, 9.5});
    // (x - 1)^4 + y^4 + z^4 = 16
    expect_bounds(polynomial({{4, 0, 0, 1},
                              {3, 0, 0, -4},
                              {2, 0, 0, 6},
                              {1, 0, 0, -4},
                              {0, 0, 0, 1 - 16.0},
                              {0, 4, 0, 1},
                              {0, 0, 4, 1}}),
                  {-1, -2, -2}, {3, 2, 2});
    expect_bounds({6, {{6, 0, 0, 1}, {0, 6, 0, 64}, {0, 0, 6, 1}, {0, 0, 0, -1}}}, {-1, -0.5, -1}, {1, 0.5, 1});
    EXPECT_FALSE(
        is_finite(compile_solid(placed(polynomial({{4, 0, 0, 1}, {0, 4, 0, 1}, {0, 0, 2, -1}})), 0)->bounds()));
    EXPECT_FALSE(is_finite(
        compile_solid(placed(polynomial({{4, 0, 0, 1}, {0, 4, 0, 1}, {0, 0, 4, 1}, {1, 3, 0, -3}})), 0)->bounds()));
}

TEST(SimpleShapes, PolynomialsOfHigherOrder) {
    expect_solid_properties(
        placed(polynomial({{6, 0, 0, 1}, {0, 6, 0, 1}, {0, 0, 6, 1}, {2, 2, 2, -3}, {0, 0, 0, -0.3}})), 1);
    expect_solid_properties(placed(polynomial({{12, 0, 0, 1}, {0, 12, 0, 2}, {0, 0, 12, 1}, {0, 0, 0, -0.3}})), 2);
    expect_solid_properties(placed(polynomial({{3, 0, 0, 1}, {0, 3, 0, 1}, {0, 0, 3, 1}, {1, 1, 0, -2}})), 3);
}

// Catches a disc with the wrong hole, or with its inside on the wrong side.
TEST(SimpleShapes, DiscsHaveHolesAndAnInsideBehindThem) {
    const auto disc = compile_solid(solid_of(scene::Disc{{0, 1, 0}, {0, 2, 0}, 1, 0.5}), 0);
    EXPECT_TRUE(disc->nearest({{0.7, 5, 0}, {0, -1, 0}}, {}));
    EXPECT_FALSE(disc->nearest({{0.3, 5, 0}, {0, -1, 0}}, {}));
    EXPECT_FALSE(disc->nearest({{1.1, 5, 0}, {0, -1, 0}}, {}));
    EXPECT_TRUE(disc->inside({0.7, 0.5, 0}));
    EXPECT_FALSE(disc->inside({0.7, 1.5, 0}));
    EXPECT_NEAR(1, disc->bounds().upper.y, 1e-9);
    EXPECT_NEAR(-1, disc->bounds().lower.x, 1e-9);
}

}  // namespace
}  // namespace sundog::solids::tests
