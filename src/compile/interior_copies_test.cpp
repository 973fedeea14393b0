// SPDX-License-Identifier: Apache-2.0
#include "compile/interior_copies.h"

#include <gtest/gtest.h>

#include <random>

#include "kernel/shared.h"

namespace sundog {
namespace {

scene::Scene glass_balls(const std::vector<scene::Sphere>& balls) {
    scene::Scene scene;
    scene::Material glass;
    glass.patterned.emplace().interior_number = 1;
    scene.materials.push_back(glass);
    for (const scene::Sphere& ball : balls) {
        scene::Object object;
        object.shape = ball;
        scene.objects.push_back(object);
    }
    return scene;
}

bool overlap(const scene::Sphere& a, const scene::Sphere& b) {
    return length(a.center - b.center) < a.radius + b.radius;
}

// Two balls of one glass that shared a number would be left where a ray enters the second.
TEST(InteriorCopies, WhatOverlapsHasNumbersOfItsOwn) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(0, 10), size(0.2F, 1);
    std::vector<scene::Sphere> balls;
    for (int i = 0; i < 300; ++i) balls.push_back({{place(random), place(random), place(random)}, size(random)});
    balls.push_back({{5, 5, 5}, 40});  // Around all of them.
    const InteriorCopies copies = interior_copies(glass_balls(balls));
    int overlapping = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (!overlap(balls[i], balls[j])) continue;
            ++overlapping;
            EXPECT_NE(copies.of(i), copies.of(j));
        }
    EXPECT_GT(overlapping, 400);
    for (std::size_t i = 0; i < balls.size(); ++i) EXPECT_LT(copies.of(i), copies.count(1));
}

// A number for each of many bubbles would make each a geometry of its own.
TEST(InteriorCopies, WhatLiesApartSharesOne) {
    std::vector<scene::Sphere> balls;
    for (int i = 0; i < 1000; ++i)
        balls.push_back(
            {{static_cast<float>(i % 10), static_cast<float>(i / 10 % 10), static_cast<float>(i / 100)}, 0.4F});
    const InteriorCopies copies = interior_copies(glass_balls(balls));
    EXPECT_EQ(copies.count(1), 1);
    EXPECT_EQ(copies.of(500), 0);
}

// As povray has it: a union's interior is one, and ends where its parts overlap.
TEST(InteriorCopies, PartsOfAUnionShareTheirs) {
    scene::Scene scene = glass_balls({{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0.5F, 1, 0}, 1}});
    scene.objects[0].interior_owner = scene.objects[1].interior_owner = 1;
    const InteriorCopies copies = interior_copies(scene);
    EXPECT_EQ(copies.of(0), copies.of(1));
    EXPECT_NE(copies.of(0), copies.of(2));
}

// Rays keep 16 bits of a number: more of them would be others' interiors.
TEST(InteriorCopies, ThereAreNeverMoreThanRaysCanTell) {
    scene::Scene scene = glass_balls({});
    for (int i = 0; i < 70000; ++i) {
        scene::Object object;
        object.shape = scene::Plane{};
        scene.objects.push_back(object);
    }
    const InteriorCopies copies = interior_copies(scene);
    EXPECT_LT(copies.count(1), kernel::MAX_INTERIORS);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) ASSERT_LT(copies.of(i), copies.count(1));
}

TEST(InteriorCopies, ScenesWithoutInteriorsHaveNone) {
    scene::Scene scene = glass_balls({{{0, 0, 0}, 1}, {{1, 0, 0}, 1}});
    scene.materials[0].patterned->interior_number = 0;
    EXPECT_TRUE(interior_copies(scene).of_object.empty());
}

}  // namespace
}  // namespace sundog
