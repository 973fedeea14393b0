// SPDX-License-Identifier: Apache-2.0
#include "solids/lazy_cells.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace sundog::solids {
namespace {

const Bounds3d kBox{{-1, 0, 2}, {1, 3, 4}};
const Vec3d kHeld{0.3, 1.7, 2.6};

bool holds(const Bounds3d& cell) { return contains(cell, kHeld); }

std::vector<Ray> some_rays(int count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 1);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Vec3d through = i % 2 == 0 ? kHeld : Vec3d{place(random), 1.5 + 1.5 * place(random), 3 + place(random)};
        const Vec3d direction{place(random), place(random), place(random)};
        rays.push_back({through - 5.0 * direction, direction});
    }
    rays.push_back({{0.3, -5, 2.6}, {0, 1, 0}});  // Along an axis, two of whose planes it never meets.
    return rays;
}

std::vector<Range> parts_along(const LazyCells& cells, const Ray& ray) {
    std::vector<Range> parts;
    const Range within = clip(kBox, ray, {-kInfinity, kInfinity});
    if (!within.empty()) cells.along(0, kBox, ray, within, holds, [&](const Range& part) { parts.push_back(part); });
    return parts;
}

// A part that is left out loses the surface in it.
TEST(LazyCells, WhatARayPassesIsInAPart) {
    const LazyCells cells(1);
    int met = 0;
    for (const Ray& ray : some_rays(200)) {
        const double t = dot(kHeld - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
        const Vec3d off = ray.at(t) - kHeld;
        if (dot(off, off) > 1e-20) continue;
        ++met;
        bool in_a_part = false;
        for (const Range& part : parts_along(cells, ray))
            in_a_part = in_a_part || (part.lower <= t + 1e-9 && t - 1e-9 <= part.upper);
        EXPECT_TRUE(in_a_part);
    }
    EXPECT_GT(met, 90);
}

// Most of a box is empty: parts that cover it all would help nobody.
TEST(LazyCells, PartsAreOfTheCellsThatHoldSomething) {
    const LazyCells cells(1);
    for (const Ray& ray : some_rays(200))
        for (const Range& part : parts_along(cells, ray)) {
            const Vec3d middle = ray.at(0.5 * (part.lower + part.upper)) - kHeld;
            EXPECT_LT(std::abs(middle.x), 0.51);
            EXPECT_LT(std::abs(middle.y), 0.76);
            EXPECT_LT(std::abs(middle.z), 0.51);
        }
}

// Pictures would depend on the order in which threads come by.
TEST(LazyCells, AnswersDontDependOnWhoCameBefore) {
    const LazyCells used(1);
    const std::vector<Ray> rays = some_rays(200);
    for (auto ray = rays.rbegin(); ray != rays.rend(); ++ray) parts_along(used, *ray);
    for (const Ray& ray : rays) {
        const LazyCells fresh(1);
        const std::vector<Range> first = parts_along(fresh, ray), later = parts_along(used, ray);
        ASSERT_EQ(first.size(), later.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            EXPECT_EQ(first[i].lower, later[i].lower);
            EXPECT_EQ(first[i].upper, later[i].upper);
        }
    }
}

}  // namespace
}  // namespace sundog::solids
