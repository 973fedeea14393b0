// SPDX-License-Identifier: Apache-2.0
// Shapes made from splines and fields.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solids/test_solids.h"

namespace sundog::solids::tests {
namespace {

const Affine3d kPlacement = turned(normalize(Vec3d{2, -1, 3}), 0.8, {0.1, -0.2, 0.15}) * scaled({1.1, 0.8, 0.9});

template <class T>
scene::Solid placed(T shape) {
    scene::Solid solid = solid_of(std::move(shape));
    solid.parent_from_shape = kPlacement;
    return solid;
}

/// Both solids' surfaces along random rays agree.
void expect_same_hits(const scene::Solid& a, const scene::Solid& b, unsigned seed, double tolerance = 1e-7) {
    const auto first = compile_solid(a, 0);
    const auto second = compile_solid(b, 0);
    RandomRays random(seed);
    int met = 0;
    for (int i = 0; i < 400; ++i) {
        const Ray ray = random.ray(2.5);
        const std::vector<Hit> hits = all_hits(*first, ray);
        const std::vector<Hit> others = all_hits(*second, ray);
        ASSERT_EQ(others.size(), hits.size()) << "ray " << i;
        for (std::size_t n = 0; n < hits.size(); ++n) {
            ++met;
            EXPECT_NEAR(others[n].t, hits[n].t, tolerance);
            EXPECT_GT(dot(hits[n].normal, others[n].normal), 1 - 1e-4) << "ray " << i;
        }
    }
    EXPECT_GT(met, 40);
}

// Catches a wrong formula: with e = n = 1 it is the sphere, with small exponents nearly the cube.
TEST(Superellipsoid, LimitsAreSphereAndCube) {
    expect_same_hits(placed(scene::Superellipsoid{1, 1}), placed(scene::SolidSphere{{}, 1}), 1, 1e-9);
    const auto cube = compile_solid(solid_of(scene::Superellipsoid{0.01, 0.01}), 0);
    EXPECT_TRUE(cube->inside({0.98, -0.98, 0.98}));
    const auto hit = cube->nearest({{-5, 0.5, 0.3}, {1, 0, 0}}, {});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(4, hit->t, 1e-9);
    EXPECT_NEAR(-1, hit->normal.x, 1e-9);
}

// Catches lost or doubled roots of rounded (convex) and pinched (concave) ones.
TEST(Superellipsoid, Properties) {
    unsigned seed = 1;
    for (const double e : {0.1, 0.5, 1.0, 1.7, 2.5, 4.0})
        for (const double n : {0.05, 0.6, 1.3, 2.0, 3.0}) {
            SCOPED_TRACE(testing::Message() << e << ", " << n);
            Expectations expectations;
            expectations.rays = 150;
            expect_solid_properties(placed(scene::Superellipsoid{e, n}), seed++, expectations);
        }
    expect_normals_agree(placed(scene::Superellipsoid{0.3, 0.5}), 1);
    expect_normals_agree(placed(scene::Superellipsoid{1.5, 0.2}), 2);
}

scene::Blob three_balls() {
    scene::Blob blob{0.6, {}};
    for (const Vec3d center : {Vec3d{0.75, 0, 0}, {-0.375, 0.64952, 0}, {-0.375, -0.64952, 0}})
        blob.components.push_back({false, center, {}, 1, 1, {}});
    return blob;
}

// Catches a wrong field: one ball is a sphere of radius R*sqrt(1 - sqrt(threshold/strength)), one rod a capsule.
TEST(Blob, OneComponentIsASphereOrACapsule) {
    scene::Blob ball{0.25, {{false, {0.2, 0, 0}, {}, 1, 1, {}}}};
    expect_same_hits(placed(ball), placed(scene::SolidSphere{{0.2, 0, 0}, std::sqrt(0.5)}), 1);
    scene::Blob rod{0.25, {{true, {-0.5, 0, 0}, {0.5, 0.5, 0}, 0.8, 1, {}}}};
    const double radius = 0.8 * std::sqrt(0.5);
    const scene::Solid capsule = *merged({pointer_to(scene::SolidSphere{{-0.5, 0, 0}, radius}),
                                          pointer_to(scene::SolidSphere{{0.5, 0.5, 0}, radius}),
                                          pointer_to(scene::SolidCone{{-0.5, 0, 0}, {0.5, 0.5, 0}, radius, radius})});
    expect_same_hits(solid_of(rod), capsule, 2);
}

// Catches surfaces lost where fields begin, end, or repel each other.
TEST(Blob, Properties) {
    expect_solid_properties(placed(three_balls()), 1);
    expect_normals_agree(placed(three_balls()), 2);
    scene::Blob dented = three_balls();
    dented.components.push_back({false, {0, 0, -0.3}, {}, 0.6, -1.5, {}});
    dented.components.push_back({true, {-1, -1, 0}, {1, 1, 0.3}, 0.4, 1.2, {}});
    dented.components.back().blob_from_component = scaled({1, 0.7, 1});
    expect_solid_properties(placed(dented), 3);
    expect_normals_agree(placed(dented), 4);
    RandomRays random(5);
    scene::Blob many{0.3, {}};
    for (int i = 0; i < 60; ++i)
        many.components.push_back({i % 3 == 0, random.point(1), random.point(1), random.number(0.1, 0.4), 1, {}});
    expect_solid_properties(placed(many), 6);
}

// Catches components' materials at the wrong places.
TEST(Blob, TheStrongestComponentsMaterialShows) {
    scene::Blob blob{0.3, {{false, {-0.4, 0, 0}, {}, 1, 1, {}}, {false, {0.4, 0, 0}, {}, 1, 1, {}}}};
    blob.components[1].material = 5;
    const auto solid = compile_solid(solid_of(blob), 2);
    EXPECT_EQ(2U, solid->nearest({{-5, 0, 0}, {1, 0, 0}}, {})->material);
    EXPECT_EQ(5U, solid->nearest({{5, 0, 0}, {-1, 0, 0}}, {})->material);
    EXPECT_EQ((std::vector<std::uint32_t>{2, 5}), solid->materials());
}

// Catches wrong polynomials: straight lathes are made of cones, a half circle of splines is nearly a sphere.
TEST(Lathe, StraightOnesAreCones) {
    const scene::Lathe vase{scene::SplineKind::linear, {{0, -1}, {0.8, -0.6}, {0.4, 0.5}, {0.4, 0.9}, {0, 0.9}}};
    const scene::Solid cones = *merged({pointer_to(scene::SolidCone{{0, -1, 0}, {0, -0.6, 0}, 0, 0.8}),
                                        pointer_to(scene::SolidCone{{0, -0.6, 0}, {0, 0.5, 0}, 0.8, 0.4}),
                                        pointer_to(scene::SolidCone{{0, 0.5, 0}, {0, 0.9, 0}, 0.4, 0.4})});
    expect_same_hits(solid_of(vase), cones, 1, 1e-6);
}

// Catches surfaces lost on curved and closed outlines, for rays in all directions, horizontal ones among them.
TEST(Lathe, Properties) {
    const scene::Lathe ring{scene::SplineKind::linear, {{0.5, -0.3}, {0.9, -0.3}, {0.9, 0.3}, {0.5, 0.2}, {0.5, -0.3}}};
    expect_solid_properties(placed(ring), 1);
    const scene::Lathe cubic{scene::SplineKind::cubic,
                             {{-0.5, -1}, {0, -0.9}, {0.9, -0.5}, {0.3, 0.1}, {0.6, 0.6}, {0, 0.9}, {-0.5, 0.8}}};
    expect_solid_properties(placed(cubic), 2);
    expect_normals_agree(placed(cubic), 3);
    const scene::Lathe bezier{
        scene::SplineKind::bezier,
        {{0.6, -0.5}, {1.1, -0.5}, {1.1, 0.5}, {0.6, 0.5}, {0.6, 0.5}, {0.2, 0.5}, {0.2, -0.5}, {0.6, -0.5}}};
    expect_solid_properties(placed(bezier), 4);
    expect_solid_properties(
        solid_of(scene::Lathe{scene::SplineKind::quadratic, {{0, -1.2}, {0, -1}, {0.7, 0}, {0, 0.9}}}), 5);
}

// Catches rays that run square to the axis, where both crossings of a wall have one parameter on the curve.
TEST(Lathe, HorizontalRays) {
    const auto ball = compile_solid(solid_of(scene::Lathe{scene::SplineKind::linear, {{0, -1}, {1, 0}, {0, 1}}}), 0);
    for (const double slope : {0.0, 1e-12, 1e-9, 1e-7, 2e-7, 1e-6, 1e-4, 1e-2}) {
        const std::vector<Hit> hits = all_hits(*ball, {{-5, 0.3, 0.1}, {1, slope, 0}});
        ASSERT_EQ(2U, hits.size()) << slope;
        EXPECT_NEAR(5 - std::sqrt(0.49 - 0.01), hits[0].t, 6 * slope + 1e-6);
        EXPECT_NEAR(5 + std::sqrt(0.49 - 0.01), hits[1].t, 8 * slope + 1e-6);
    }
}

// Catches an open end that closes itself or loses the inside.
TEST(Lathe, OpenEndsAreOpen) {
    const auto tube = compile_solid(solid_of(scene::Lathe{scene::SplineKind::linear, {{1, -1}, {1, 1}}}), 0);
    EXPECT_FALSE(tube->nearest({{0.3, -5, 0.2}, {0, 1, 0}}, {}));
    EXPECT_EQ(2U, all_hits(*tube, {{-5, 0, 0.2}, {1, 0, 0}}).size());
    const auto hit = tube->nearest({{0.3, -5, 0.2}, {0.15, 1, 0}}, {});
    ASSERT_TRUE(hit);
    EXPECT_GT(dot(hit->normal, Vec3d{0.15, 1, 0}), 0);
}

// Catches wrong cubics: the square of the radius of a straight profile's is known, and the curve passes its points.
TEST(SurfaceOfRevolution, PassesItsPointsAndHasProperties) {
    const scene::SurfaceOfRevolution vase{{{0.0, -1.2}, {0.3, -1.0}, {0.8, -0.3}, {0.3, 0.4}, {0.5, 0.9}, {0.6, 1.1}},
                                          false};
    const auto solid = compile_solid(solid_of(vase), 0);
    for (std::size_t i = 1; i + 1 < vase.points.size(); ++i) {
        const double y = std::clamp(vase.points[i][1], -1 + 1e-9, 0.9 - 1e-9);
        const std::vector<Hit> hits = all_hits(*solid, {{-5, y, 0}, {1, 0, 0}});
        ASSERT_EQ(2U, hits.size());
        EXPECT_NEAR(5 - vase.points[i][0], hits[0].t, 1e-7);
    }
    const auto cap = solid->nearest({{0.1, 5, 0}, {0, -1, 0}}, {});
    ASSERT_TRUE(cap);
    EXPECT_NEAR(4.1, cap->t, 1e-12);
    EXPECT_NEAR(1, cap->normal.y, 1e-12);
    expect_solid_properties(placed(vase), 1);
    expect_normals_agree(placed(vase), 2);
    scene::SurfaceOfRevolution open = vase;
    open.open = true;
    const auto inner = compile_solid(solid_of(open), 0)->nearest({{0.1, 5, 0}, {0, -1, 0}}, {});
    EXPECT_FALSE(inner);
}

// Catches points that are no function of the height.
TEST(SurfaceOfRevolution, RefusesPointsThatTurnBack) {
    EXPECT_THROW(
        compile_solid(solid_of(scene::SurfaceOfRevolution{{{0, 0}, {1, 1}, {1, 0.5}, {1, 2}, {0, 3}}, false}), 0),
        InputError);
    EXPECT_THROW(compile_solid(solid_of(scene::SurfaceOfRevolution{{{0, 0}, {1, 1}, {1, 2}}, false}), 0), InputError);
}

// Catches walls that part from the box and the holes that are meant.
TEST(Prism, ARectangleIsABoxAndInnerLoopsAreHoles) {
    const scene::Prism box{
        scene::SplineKind::linear, false, -0.5, 0.8, {{-1, -0.7}, {0.6, -0.7}, {0.6, 0.9}, {-1, 0.9}, {-1, -0.7}}};
    expect_same_hits(placed(box), placed(scene::SolidBox{{-1, -0.5, -0.7}, {0.6, 0.8, 0.9}}), 1);
    const scene::Prism frame{scene::SplineKind::linear,
                             false,
                             0,
                             1,
                             {{0, 0}, {6, 0}, {6, 8}, {0, 8}, {0, 0}, {1, 1}, {5, 1}, {5, 7}, {1, 7}, {1, 1}}};
    const auto solid = compile_solid(solid_of(frame), 0);
    EXPECT_FALSE(solid->inside({3, 0.5, 4}));
    EXPECT_TRUE(solid->inside({0.5, 0.5, 4}));
    EXPECT_FALSE(solid->nearest({{3, 5, 4}, {0, -1, 0}}, {}));
    EXPECT_EQ(4U, all_hits(*solid, {{-1, 0.5, 4}, {1, 0, 0}}).size());
    EXPECT_EQ(4U, all_hits(*solid, {{-1, 0.5, 1 + 1e-9}, {1, 0, 0}}).size());
}

// Catches parity that is lost where pieces join, for all kinds of splines and both sweeps.
TEST(Prism, Properties) {
    const std::vector<std::array<double, 2>> star{{-0.3, -0.4}, {0, -0.9}, {0.3, -0.3}, {0.9, 0},
                                                  {0.3, 0.3},   {0, 0.9},  {-0.3, 0.3}, {-0.9, 0},
                                                  {-0.3, -0.3}, {0, -0.9}, {0.3, -0.3}};
    const std::vector<std::array<double, 2>> corners(star.begin() + 1, star.begin() + 10);
    expect_solid_properties(placed(scene::Prism{scene::SplineKind::cubic, false, -0.6, 0.5, star}), 1);
    expect_normals_agree(placed(scene::Prism{scene::SplineKind::cubic, false, -0.6, 0.5, star}), 2);
    expect_solid_properties(placed(scene::Prism{scene::SplineKind::quadratic, false, -0.6, 0.5, star}), 3);
    expect_solid_properties(placed(scene::Prism{scene::SplineKind::linear, false, -0.6, 0.5, corners}), 4);
    expect_solid_properties(placed(scene::Prism{scene::SplineKind::linear, true, 0.2, 1, corners}), 5);
    expect_solid_properties(placed(scene::Prism{scene::SplineKind::cubic, true, -1, 1, star}), 6);
    expect_normals_agree(placed(scene::Prism{scene::SplineKind::linear, true, 0.2, 1, corners}), 7);
    const scene::Prism drop{scene::SplineKind::bezier,
                            false,
                            -0.5,
                            0.5,
                            {{0, -0.8}, {1, 0}, {0.5, 0.8}, {0, 0.8}, {0, 0.8}, {-0.5, 0.8}, {-1, 0}, {0, -0.8}}};
    expect_solid_properties(placed(drop), 8);
}

// Catches rays through an outline's corner, which belongs to two walls: met by both, it would be no wall at all.
TEST(Prism, RaysThroughCorners) {
    const auto solid = compile_solid(
        solid_of(scene::Prism{scene::SplineKind::linear, false, -1, 1, {{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}}),
        0);
    EXPECT_EQ(2U, all_hits(*solid, {{-5, 0, 0}, {1, 0, 0}}).size());
    EXPECT_EQ(2U, all_hits(*solid, {{0, 0.2, -5}, {0, 0, 1}}).size());
}

// Catches wrong envelopes: a straight sweep of one radius is a capsule; a growing one is spheres and the cone that
// touches them.
TEST(SphereSweep, StraightOnesAreCapsules) {
    const scene::SphereSweep rod{scene::SphereSweep::Kind::linear, {{{-0.8, 0, 0}, 0.4}, {{0.7, 0.5, 0.2}, 0.4}}};
    const scene::Solid capsule = *merged({pointer_to(scene::SolidSphere{{-0.8, 0, 0}, 0.4}),
                                          pointer_to(scene::SolidSphere{{0.7, 0.5, 0.2}, 0.4}),
                                          pointer_to(scene::SolidCone{{-0.8, 0, 0}, {0.7, 0.5, 0.2}, 0.4, 0.4})});
    expect_same_hits(solid_of(rod), capsule, 1);
    const scene::SphereSweep growing{scene::SphereSweep::Kind::linear, {{{-1, 0, 0}, 0.2}, {{1, 0, 0}, 0.8}}};
    const double sine = 0.3;  // (0.8 - 0.2)/2
    const double cosine = std::sqrt(1 - sine * sine);
    const scene::Solid cone = *merged(
        {pointer_to(scene::SolidSphere{{-1, 0, 0}, 0.2}), pointer_to(scene::SolidSphere{{1, 0, 0}, 0.8}),
         pointer_to(scene::SolidCone{{-1 - 0.2 * sine, 0, 0}, {1 - 0.8 * sine, 0, 0}, 0.2 * cosine, 0.8 * cosine})});
    expect_same_hits(solid_of(growing), cone, 2, 1e-6);
}

// Catches a ray square to the path, where the two derivatives vanish together.
TEST(SphereSweep, SquareToThePath) {
    const auto rod = compile_solid(
        solid_of(scene::SphereSweep{scene::SphereSweep::Kind::linear, {{{-1, 0, 0}, 0.5}, {{1, 0, 0}, 0.5}}}), 0);
    for (const double tilt : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
        const auto hit = rod->nearest({{0.2 - 5 * tilt, 0, -5}, {tilt, 0, 1}}, {});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(4.5, hit->t, 1e-5);
    }
}

// Catches envelopes with holes or wrong insides on curved paths.
TEST(SphereSweep, Properties) {
    const std::vector<scene::SphereSweep::Point> path{{{-1, -0.5, 0}, 0.3},    {{-0.5, 0.6, 0.2}, 0.25},
                                                      {{0, -0.4, -0.3}, 0.35}, {{0.5, 0.5, 0.1}, 0.15},
                                                      {{0.9, -0.2, 0.3}, 0.3}, {{0.2, 0, 0.8}, 0.2}};
    expect_solid_properties(placed(scene::SphereSweep{scene::SphereSweep::Kind::linear, path}), 1);
    expect_solid_properties(placed(scene::SphereSweep{scene::SphereSweep::Kind::b_spline, path}), 2);
    expect_solid_properties(placed(scene::SphereSweep{scene::SphereSweep::Kind::cubic, path}), 3);
    expect_normals_agree(placed(scene::SphereSweep{scene::SphereSweep::Kind::cubic, path}), 4);
}

// Catches shapes made of too few points.
TEST(Splines, TooFewPointsAreRefused) {
    EXPECT_THROW(compile_solid(solid_of(scene::Lathe{scene::SplineKind::cubic, {{0, 0}, {1, 1}, {2, 2}}}), 0),
                 InputError);
    EXPECT_THROW(compile_solid(solid_of(scene::Prism{scene::SplineKind::linear, false, 0, 1, {{0, 0}}}), 0),
                 InputError);
    EXPECT_THROW(compile_solid(solid_of(scene::SphereSweep{scene::SphereSweep::Kind::b_spline, {{}, {}, {}}}), 0),
                 InputError);
}

}  // namespace
}  // namespace sundog::solids::tests
