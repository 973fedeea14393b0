// SPDX-License-Identifier: Apache-2.0
// What groups make of their children.
#include <gtest/gtest.h>

#include <cmath>

#include "solids/test_solids.h"

namespace sundog::solids::tests {
namespace {

SolidPointer sphere(Vec3d center, double radius, std::uint32_t material = scene::Solid::kInherited) {
    return pointer_to(scene::SolidSphere{center, radius}, material);
}
SolidPointer box(Vec3d lower, Vec3d upper, std::uint32_t material = scene::Solid::kInherited) {
    return pointer_to(scene::SolidBox{lower, upper}, material);
}

void expect_same(const SolidPointer& a, const SolidPointer& b, unsigned seed) {
    const auto first = compile_solid(*a, 0);
    const auto second = compile_solid(*b, 0);
    RandomRays random(seed);
    int met = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray = random.ray(3);
        const std::vector<Hit> hits = all_hits(*first, ray);
        const std::vector<Hit> others = all_hits(*second, ray);
        ASSERT_EQ(hits.size(), others.size()) << i;
        EXPECT_EQ(first->inside(ray.origin), second->inside(ray.origin));
        for (std::size_t n = 0; n < hits.size(); ++n) {
            ++met;
            EXPECT_NEAR(hits[n].t, others[n].t, 1e-9);
            EXPECT_GT(dot(hits[n].normal, others[n].normal), 1 - 1e-9);
        }
    }
    EXPECT_GT(met, 50);
}

const SolidPointer kA = pointer_to(scene::SolidBox{{-1, -0.7, -0.9}, {0.8, 0.9, 0.6}});
const SolidPointer kB = pointer_to(scene::SolidSphere{{0.6, 0.3, 0}, 0.9});
const SolidPointer kC = pointer_to(scene::Torus{1, 0.3});

// Catches a wrong combination: laws of set algebra hold along random rays.
TEST(Csg, LawsOfSets) {
    expect_same(difference({kA, kB}), intersected({kA, inverted(kB)}), 1);
    expect_same(merged({kA, kB, kC}), merged({kC, kA, kB}), 2);
    expect_same(intersected({kA, kB, kC}), intersected({kB, kC, kA}), 3);
    expect_same(inverted(merged({kA, kC})), intersected({inverted(kA), inverted(kC)}), 4);
    expect_same(inverted(intersected({kA, kB})), merged({inverted(kA), inverted(kB)}), 5);
    expect_same(difference({kA, merged({kB, kC})}), difference({kA, kB, kC}), 6);
    expect_same(intersected({kA, merged({kB, kC})}), merged({intersected({kA, kB}), intersected({kA, kC})}), 7);
    expect_same(inverted(inverted(kC)), kC, 8);
    expect_same(united({kA, kB, kC}), united({kB, kC, kA}), 9);
}

// Catches slow children that are asked for too short a part of the ray: intersections, which ask quick ones first,
// agree with merges of inverses, which ask all of them everywhere; with bounded shapes and with such that have no end.
TEST(Csg, SlowChildrenAreAskedWhereTheyCount) {
    const SolidPointer half_space = pointer_to(scene::HalfSpace{{0.6, 0.64, 0.48}, 0.2});
    const SolidPointer parabola = pointer_to(
        scene::Polynomial{4, {{4, 0, 0, 1.0}, {0, 0, 2, 0.5}, {0, 1, 0, -1.0}, {0, 0, 0, -0.3}}});  // No end along y.
    const SolidPointer pipe = pointer_to(scene::Polynomial{2, {{2, 0, 0, 1.0}, {0, 0, 2, 1.0}, {0, 0, 0, -0.64}}});
    const SolidPointer rounded = pointer_to(scene::Superellipsoid{0.6, 0.8});
    const std::vector<std::vector<SolidPointer>> groups{
        {kC, kA},
        {kC, half_space},
        {kC, inverted(half_space), kB},
        {parabola, kA},
        {parabola, half_space, inverted(pipe)},
        {inverted(parabola), kA, inverted(kB)},
        {kC, inverted(kA), inverted(kB)},
        {rounded, inverted(pipe), inverted(kB)},
        {kC, inverted(difference({kA, kC}))},
        {moved(kC, turned({1, 0, 0}, 1.1)), merged({kA, kC}), inverted(half_space)},
    };
    for (std::size_t i = 0; i < groups.size(); ++i) {
        SCOPED_TRACE(i);
        std::vector<SolidPointer> inverses;
        for (const SolidPointer& child : groups[i]) inverses.push_back(inverted(child));
        expect_same(intersected(groups[i]), inverted(merged(inverses)), 20 + static_cast<unsigned>(i));
    }
}

// Catches intervals of convex shapes that are put together another way than events of any shapes are: the same
// children, each of them a union of one, take the other way. Among them faces that coincide, and cuts that leave
// nothing.
TEST(Csg, ConvexPartsAreWhatAnyPartsAre) {
    const SolidPointer half_space = pointer_to(scene::HalfSpace{{0.6, 0.64, 0.48}, 0.2});
    const SolidPointer block = pointer_to(scene::SolidBox{{-0.8, -0.5, -0.6}, {0.8, 0.5, 0.6}});
    const SolidPointer notch = pointer_to(scene::SolidBox{{-0.8, 0, -0.6}, {0.2, 0.5, 0.3}});
    const SolidPointer cone = pointer_to(scene::SolidCone{{0, -1, 0}, {0.2, 1, 0.1}, 0.7, 0});
    const SolidPointer pipe = pointer_to(scene::Polynomial{2, {{2, 0, 0, 1.0}, {0, 0, 2, 1.0}, {0, 0, 0, -0.16}}});
    const std::vector<std::vector<SolidPointer>> groups{
        {kA, kB},
        {block, inverted(kB)},
        {block, inverted(notch), inverted(pipe)},
        {kA, half_space, inverted(cone), inverted(notch)},
        {inverted(block), kA},
        {inverted(kA), inverted(block)},
        {cone, half_space, inverted(pipe)},
    };
    for (std::size_t i = 0; i < groups.size(); ++i) {
        SCOPED_TRACE(i);
        std::vector<SolidPointer> unions;
        for (const SolidPointer& child : groups[i]) unions.push_back(united({child}));
        expect_same(intersected(groups[i]), intersected(unions), 60 + static_cast<unsigned>(i));
        const auto clipped = [](const std::vector<SolidPointer>& children) {
            auto solid = std::make_shared<scene::Solid>(*united({children[0]}));
            solid->clipped_by.assign(children.begin() + 1, children.end());
            return SolidPointer(solid);
        };
        std::vector<SolidPointer> slow = unions;
        slow[0] = groups[i][0];
        expect_same(clipped(groups[i]), clipped(slow), 80 + static_cast<unsigned>(i));
    }
}

// Catches quadrics without an end that nobody bounds, and bounds that cut them: each ray would ask them, or miss them.
TEST(Csg, QuadricsAreBoundedByWhatCutsThem) {
    const SolidPointer above = pointer_to(scene::HalfSpace{{0, -1, 0}, 0.5});
    const SolidPointer below = pointer_to(scene::HalfSpace{{0, 1, 0}, 2});
    const auto quadric = [](double y_squared, double y, double constant) {
        return pointer_to(scene::Polynomial{
            2, {{2, 0, 0, 1.0}, {0, 2, 0, y_squared}, {0, 0, 2, 1.0}, {0, 1, 0, y}, {0, 0, 0, constant}}});
    };
    struct Case {
        SolidPointer solid;
        double radius;  ///< The largest between the planes.
    };
    const Case cases[] = {{quadric(-1, 0, -1), std::sqrt(5.0)},  // hyperboloid
                          {quadric(-1, 0, 0), 2},                // cone
                          {quadric(0, -1, 0), std::sqrt(2.0)},   // paraboloid
                          {quadric(0, 0, -0.25), 0.5}};          // cylinder
    for (const Case& c : cases) {
        const auto upright = compile_solid(*intersected({c.solid, above, below}), 0);
        EXPECT_NEAR(c.radius, upright->bounds().upper.x, 1e-4);
        EXPECT_NEAR(-c.radius, upright->bounds().lower.z, 1e-4);
        EXPECT_NEAR(2, upright->bounds().upper.y, 1e-4);
        const SolidPointer slanted =
            moved(intersected({above, c.solid, below}), turned(normalize(Vec3d{1, 2, -1}), 0.8, {0.3, 0.2, -0.1}));
        const auto compiled = compile_solid(*slanted, 0);
        EXPECT_LT(compiled->bounds().upper.x - compiled->bounds().lower.x, 4 * c.radius + 4);
        expect_solid_properties(*slanted, 95, {.reach = 4});
    }
}

// Catches bounds that cut a shape without an end instead of letting rays pass by it, and such that act on others.
TEST(Csg, RaysThatPassByBoundsDontMeetWhatHasNoEnd) {
    const auto bounded = [](const SolidPointer& what) {
        auto solid = std::make_shared<scene::Solid>(*what);
        solid->bounded_by = {sphere({0, 0, 0}, 1)};
        return SolidPointer(solid);
    };
    const SolidPointer column = pointer_to(scene::Polynomial{4, {{4, 0, 0, 1.0}, {0, 0, 4, 1.0}, {0, 0, 0, -0.0625}}});
    const auto inverse = compile_solid(*inverted(bounded(column)), 0);
    const auto plain = compile_solid(*bounded(column), 0);
    const Ray beside{{-5, 3, 0}, {1, 0, 0}};       // Meets the column off the bounds.
    const Ray across{{-5, 3, 0.2}, {1, -0.6, 0}};  // Meets it at y of 0.3 and 0, and would at all heights.
    for (const auto& solid : {plain, inverse}) {
        EXPECT_EQ(0U, all_hits(*solid, beside).size());
        EXPECT_EQ(2U, all_hits(*solid, across).size());
    }
    EXPECT_EQ(2U, all_hits(*compile_solid(*column, 0), beside).size());
    // A ray that comes through the bounds sees all of it.
    const Ray along{{0.9, -2, 0.1}, {-0.2, 1, 0}};
    const std::vector<Hit> hits = all_hits(*plain, along);
    ASSERT_EQ(2U, hits.size());
    EXPECT_GT(along.at(hits[1].t).y, 1.5);
    expect_same(bounded(kB), kB, 30);
}

// Catches states that get out of step along the ray.
TEST(Csg, Properties) {
    expect_solid_properties(*difference({kA, kB, kC}), 1);
    expect_solid_properties(*merged({kA, kB, kC}), 2);
    expect_solid_properties(*intersected({kA, kC}), 3);
    expect_solid_properties(*difference({merged({kA, kB}), moved(kC, turned({1, 0, 0}, 1.1))}), 4);
    expect_solid_properties(*inverted(difference({kA, kB})), 5);
    expect_normals_agree(*difference({kA, kB, kC}), 6);
}

// Catches a union that loses inner surfaces, or a merge that keeps them.
TEST(Csg, UnionsKeepInnerSurfacesAndMergesDoNot) {
    const std::vector<SolidPointer> balls{sphere({0, 0, 0}, 1), sphere({1, 0, 0}, 1)};
    const Ray ray{{-5, 0, 0}, {1, 0, 0}};
    const std::vector<Hit> all = all_hits(*compile_solid(*united(balls), 0), ray);
    ASSERT_EQ(4U, all.size());
    EXPECT_NEAR(5, all[1].t, 1e-12);
    const std::vector<Hit> outer = all_hits(*compile_solid(*merged(balls), 0), ray);
    ASSERT_EQ(2U, outer.size());
    EXPECT_NEAR(4, outer[0].t, 1e-12);
    EXPECT_NEAR(7, outer[1].t, 1e-12);
}

// Catches speckle where a subtrahend's face lies in a face of what it is cut from, even when both were turned.
TEST(Csg, SharedPlanesOfADifferenceAreGone) {
    const SolidPointer plate = box({-1, 0, -1}, {1, 1, 1}, 1);
    const SolidPointer drill = box({-0.5, 0, -0.5}, {0.5, 1, 0.5}, 2);  // through both faces exactly
    const Affine3d place = turned(normalize(Vec3d{1, 2, 3}), 0.9, {10, 20, 30}) * scaled({3, 3, 3});
    const auto solid = compile_solid(*moved(difference({plate, drill}), place), 0);
    RandomRays random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vec3d through{random.number(-0.45, 0.45), 0.5, random.number(-0.45, 0.45)};
        const Vec3d slant{random.number(-0.02, 0.02), 1, random.number(-0.02, 0.02)};
        const Ray ray{transform_point(place, through - slant * 20.0), transform_vector(place, slant)};
        EXPECT_TRUE(all_hits(*solid, ray).empty()) << i;
    }
}

// Catches speckle where two solids share a face: the one written first counts, everywhere alike.
TEST(Csg, OfCoincidingFacesTheFirstCounts) {
    const SolidPointer red = moved(box({-1, -1, -1}, {1, 1, 1}, 1), turned({0, 1, 0}, 0.3));
    const SolidPointer blue = moved(box({-1, -2, -1}, {1, 1, 1}, 2), turned({0, 1, 0}, 0.3));
    for (const SolidPointer& solid : {united({red, blue}), merged({red, blue}), intersected({red, blue})}) {
        const auto compiled = compile_solid(*solid, 0);
        RandomRays random(6);
        for (int i = 0; i < 500; ++i) {
            const Vec3d target{random.number(-0.6, 0.6), 1, random.number(-0.6, 0.6)};
            const Vec3d from{random.number(-3, 3), 7, random.number(-3, 3)};
            const auto hit = compiled->nearest({from, target - from}, {});
            ASSERT_TRUE(hit);
            EXPECT_EQ(1U, hit->material);
        }
    }
}

// Catches a merge that leaves a wall between two solids that touch.
TEST(Csg, MergedNeighboursHaveNoWallBetweenThem) {
    const auto solid = compile_solid(*merged({box({-1, -1, -1}, {0, 1, 1}), box({0, -1, -1}, {1, 1, 1})}), 0);
    const std::vector<Hit> hits = all_hits(*solid, {{-5, 0.1, 0.2}, {1, 0, 0}});
    ASSERT_EQ(2U, hits.size());
    EXPECT_NEAR(6, hits[1].t, 1e-12);
}

// Catches clips that show their own surface, or whose inside is not cut.
TEST(Csg, ClippedByCutsWithoutCapping) {
    scene::Solid ball = solid_of(scene::SolidSphere{{0, 0, 0}, 1});
    ball.clipped_by.push_back(pointer_to(scene::HalfSpace{{0, 1, 0}, 0}));
    const auto bowl = compile_solid(ball, 0);
    EXPECT_TRUE(bowl->inside({0, -0.5, 0}));
    EXPECT_FALSE(bowl->inside({0, 0.5, 0}));
    const std::vector<Hit> hits = all_hits(*bowl, {{0.2, 5, 0.1}, {0, -1, 0}});
    ASSERT_EQ(1U, hits.size());  // into the open top, onto the bottom from inside
    EXPECT_NEAR(5 + std::sqrt(0.95), hits[0].t, 1e-12);
    EXPECT_GT(dot(hits[0].normal, Vec3d{0, -1, 0}), 0);
    EXPECT_NEAR(0, bowl->bounds().upper.y, 1e-8);
}

// Catches clips that move with the object's own transform: they are in the parent's space, and move with that.
TEST(Csg, ClipsAreInTheParentsSpace) {
    scene::Solid ball = solid_of(scene::SolidSphere{{0, 0, 0}, 1});
    ball.parent_from_shape.t = {0, 5, 0};
    ball.clipped_by.push_back(pointer_to(scene::HalfSpace{{0, 1, 0}, 5.5}));
    scene::Solid outer = solid_of(scene::SolidGroup{{}, {std::make_shared<scene::Solid>(ball)}});
    outer.parent_from_shape.t = {0, 100, 0};
    const auto solid = compile_solid(outer, 0);
    EXPECT_FALSE(solid->inside({0, 105.7, 0}));
    EXPECT_TRUE(solid->inside({0, 105.3, 0}));
}

// Catches materials that don't pass down, or override a child's own; and interior_texture.
TEST(Csg, MaterialsPassDownToThoseWithoutOne) {
    auto parent = std::make_shared<scene::Solid>(*united({sphere({0, 0, 0}, 1, 4), sphere({5, 0, 0}, 1)}));
    parent->material = 9;
    auto hollow = std::make_shared<scene::Solid>(*sphere({10, 0, 0}, 1));
    hollow->interior_material = 3;
    const auto solid = compile_solid(*united({parent, hollow}), 1);
    const std::vector<Hit> hits = all_hits(*solid, {{-5, 0, 0}, {1, 0, 0}});
    ASSERT_EQ(6U, hits.size());
    EXPECT_EQ(4U, hits[0].material);
    EXPECT_EQ(9U, hits[2].material);
    EXPECT_EQ(1U, hits[4].material);
    EXPECT_EQ(3U, hits[5].material);
    EXPECT_EQ((std::vector<std::uint32_t>{1, 3, 4, 9}), solid->materials());
}

// Catches discs whose inside isn't the half of space behind them: what they cut away, and what they hide.
TEST(Csg, DiscsInGroups) {
    const SolidPointer disc = pointer_to(scene::Disc{{0, 0, 0}, {0, 1, 0}, 2});
    const Ray inner{{0.5, 5, 0}, {0, -1, 0}};
    const Ray outer{{1.5, 5, 0}, {0, -1, 0}};
    const auto cut = compile_solid(*intersected({disc, inverted(sphere({0, 0, 0}, 1))}), 0);
    EXPECT_TRUE(cut->nearest(outer, {}));
    EXPECT_NEAR(5 + std::sqrt(0.75), cut->nearest(inner, {})->t, 1e-9);  // the hollow's ground, under the disc
    const auto dome = compile_solid(*difference({sphere({0, 0, 0}, 1), disc}), 0);
    EXPECT_EQ(2U, all_hits(*dome, inner).size());  // onto its top, and out through the cut
    EXPECT_FALSE(dome->inside({0, -0.5, 0}));
    // Under the disc nothing of the other is left to be seen.
    const auto joined_up = compile_solid(*merged({disc, sphere({0, 0, 0}, 1)}), 0);
    EXPECT_EQ(1U, all_hits(*joined_up, inner).size());
    EXPECT_EQ(1U, all_hits(*joined_up, outer).size());
    EXPECT_EQ(3U, all_hits(*compile_solid(*united({disc, sphere({0, 0, 0}, 1)}), 0), inner).size());
}

// Catches a tree over children that loses some, or that changes what a group of many is.
TEST(Csg, ManyChildrenAreLikeFew) {
    RandomRays random(8);
    std::vector<SolidPointer> balls;
    for (int i = 0; i < 300; ++i) balls.push_back(sphere(random.point(1), random.number(0.05, 0.15)));
    expect_solid_properties(*merged(balls), 1);
    std::vector<SolidPointer> cheese{box({-1, -1, -1}, {1, 1, 1})};
    cheese.insert(cheese.end(), balls.begin(), balls.end());
    expect_solid_properties(*difference(cheese), 2);
    const auto solid = compile_solid(*difference(cheese), 0);
    int wrong = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d p = random.point(1.1);
        bool expected = std::abs(p.x) < 1 && std::abs(p.y) < 1 && std::abs(p.z) < 1;
        for (const SolidPointer& ball : balls) {
            const auto& s = std::get<scene::SolidSphere>(ball->shape);
            expected = expected && length(p - s.center) > s.radius;
        }
        if (solid->inside(p) != expected) ++wrong;
    }
    EXPECT_EQ(0, wrong);
    EXPECT_NEAR(1, solid->bounds().upper.x, 1e-8);
}

// Catches infinite shapes that make a finite intersection infinite: six planes bound a box.
TEST(Csg, PlanesBoundWhatTheyEnclose) {
    std::vector<SolidPointer> planes;
    for (const Vec3d n : {Vec3d{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
        planes.push_back(pointer_to(scene::HalfSpace{n, 0.75}));
    const auto solid = compile_solid(*intersected(planes), 0);
    EXPECT_NEAR(-0.75, solid->bounds().lower.z, 1e-8);
    EXPECT_NEAR(0.75, solid->bounds().upper.x, 1e-8);
    expect_same(intersected(planes), box({-0.75, -0.75, -0.75}, {0.75, 0.75, 0.75}), 1);
    EXPECT_FALSE(is_finite(compile_solid(*planes[0], 0)->bounds()));
}

// Catches rays that start inside seen as if they came from outside.
TEST(Csg, RaysThatStartInside) {
    const auto solid = compile_solid(*difference({sphere({0, 0, 0}, 2), sphere({0, 0, 0}, 1)}), 0);
    const auto from_shell = solid->nearest({{1.5, 0, 0}, {-1, 0, 0}}, {});
    ASSERT_TRUE(from_shell);
    EXPECT_NEAR(0.5, from_shell->t, 1e-12);
    EXPECT_NEAR(-1, from_shell->normal.x, 1e-12);
    const auto from_cavity = solid->nearest({{0, 0, 0}, {1, 0, 0}}, {});
    ASSERT_TRUE(from_cavity);
    EXPECT_NEAR(1, from_cavity->t, 1e-12);
    EXPECT_NEAR(-1, from_cavity->normal.x, 1e-12);
}

// Catches nesting that overflows the stack: a chain of unions is one group, a chain that can't be is refused.
TEST(Csg, DeepNesting) {
    SolidPointer chain = sphere({0, 0, 0}, 1);
    for (int i = 0; i < 1000; ++i) chain = united({chain, sphere({static_cast<double>(i), 0, 0}, 0.3)});
    EXPECT_EQ(1002U, compile_solid(*chain, 0)->nodes().size());
    SolidPointer alternating = sphere({0, 0, 0}, 1);
    for (int i = 0; i < 1000; ++i)
        alternating = i % 2 == 0 ? united({alternating, kA}) : intersected({alternating, kA});
    EXPECT_THROW(compile_solid(*alternating, 0), InputError);
}

// Catches scales of 0, which have no inverse.
TEST(Csg, FlattenedObjectsAreRefused) {
    EXPECT_THROW(compile_solid(*moved(sphere({0, 0, 0}, 1), scaled({1, 0, 1})), 0), InputError);
}

// Catches groups taken for flat unions that are not.
TEST(Csg, OnlyPlainUnionsCanBeSplit) {
    EXPECT_TRUE(can_be_split(*united({kA, kB})));
    EXPECT_FALSE(can_be_split(*merged({kA, kB})));
    EXPECT_FALSE(can_be_split(*inverted(united({kA, kB}))));
    EXPECT_FALSE(can_be_split(*kA));
    scene::Solid clipped = *united({kA, kB});
    clipped.clipped_by.push_back(kC);
    EXPECT_FALSE(can_be_split(clipped));
}

}  // namespace
}  // namespace sundog::solids::tests
