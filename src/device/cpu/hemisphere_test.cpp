// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/hemisphere.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sundog::cpu {
namespace {

/// The sample at a point in a plane of height 0, of a wall that stands at x = 0, endless, and glows below a height
/// of 1.
IrradianceSample beside_a_wall(Vec3 position, int count) {
    const Hemisphere hemisphere(count);
    const Hemisphere::Frame axes({0, 0, 1});
    std::vector<BatchAnswer> answers;
    for (const Vec3 d : hemisphere.directions()) {
        const Vec3 direction = axes.to_world(d);
        BatchAnswer answer{{0, 0, 0}, 3e38F};
        if (direction.x < 0) {
            answer.distance = -position.x / direction.x;
            if (answer.distance * direction.z < 1) answer.radiance = {1, 0.5F, 0};
        }
        answers.push_back(answer);
    }
    IrradianceSample sample{position, {0, 0, 1}, {}};
    hemisphere.integrate(answers, axes, sample);
    return sample;
}

/// A strip's form factor.
double light_at(double x) { return (1 - x / std::sqrt(x * x + 1)) / 2; }

// Catches directions that aren't unit vectors spread by the cosine (their mean is 2/3 of the normal), or turned axes.
TEST(Hemisphere, DirectionsAreSpreadByTheCosine) {
    for (const Vec3 normal : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{0.6F, 0, -0.8F}, Vec3{-0.48F, 0.6F, 0.64F}}) {
        const Hemisphere::Frame axes(normal);
        for (const int count : {1, 2, 8, 35, 200}) {
            const Hemisphere hemisphere(count);
            EXPECT_GE(static_cast<int>(hemisphere.directions().size()), count * 97 / 100);
            EXPECT_LE(static_cast<int>(hemisphere.directions().size()), count + 15);
            Vec3 sum;
            for (const Vec3 d : hemisphere.directions()) {
                EXPECT_NEAR(length(axes.to_world(d)), 1, 1e-5F);
                EXPECT_GT(dot(axes.to_world(d), normal), 0);
                sum += axes.to_world(d);
            }
            if (count < 35) continue;
            const Vec3 off = sum / static_cast<float>(hemisphere.directions().size()) - normal * (2.0F / 3);
            EXPECT_LT(length(off), 0.02F) << count;
        }
    }
}

// Catches a wrong weight of rings or sectors, and distances averaged the wrong way.
TEST(Hemisphere, LightBesideAWallIsItsFormFactor) {
    for (const float x : {0.2F, 0.5F, 1.0F, 2.0F}) {
        const IrradianceSample sample = beside_a_wall({x, 0, 0}, 4000);
        EXPECT_NEAR(sample.light.x, light_at(x), 0.01) << x;
        EXPECT_NEAR(sample.light.y, light_at(x) / 2, 0.01) << x;
        // Half the directions meet the wall; the mean of -direction.x over them is 4/(3 pi).
        EXPECT_NEAR(sample.reach, x * 1.5F * kPi, 0.03F * x) << x;
    }
}

// The gradients, against the form factor's own. Catches a sign, a factor of pi, and channels that are mixed up.
TEST(Hemisphere, GradientsSayHowLightChanges) {
    for (const float x : {0.5F, 1.0F, 2.0F}) {
        const IrradianceSample sample = beside_a_wall({x, 0, 0}, 4000);
        const double slope = (light_at(x + 0.001) - light_at(x - 0.001)) / 0.002;
        EXPECT_NEAR(sample.by_move[0].x, slope, 0.05 * std::abs(slope)) << x;
        EXPECT_NEAR(sample.by_move[1].x, slope / 2, 0.05 * std::abs(slope)) << x;
        EXPECT_NEAR(sample.by_move[0].y, 0, 0.01);
        EXPECT_FLOAT_EQ(sample.by_move[2].x, 0);
        // Turned about y by an angle, the normal (sin, 0, cos) looks away from the wall.
        EXPECT_LT(sample.by_turn[0].y, 0);
        EXPECT_NEAR(sample.by_turn[0].x, 0, 0.01);
    }
}

// Catches a gradient that makes light negative, or more than doubles it, within a sample's reach.
TEST(Hemisphere, GradientsAreLimited) {
    IrradianceSample sample{{}, {0, 0, 1}, {1, 2, 0}};
    sample.reach = 2;
    sample.by_move = {Vec3{3, 0, 4}, Vec3{0, 0.5F, 0}, Vec3{1, 0, 0}};
    sample.limit_gradients();
    EXPECT_NEAR(length(sample.by_move[0]), 0.5F, 1e-6F);
    EXPECT_FLOAT_EQ(sample.by_move[1].y, 0.5F);
    EXPECT_FLOAT_EQ(sample.by_move[2].x, 0);
}

}  // namespace
}  // namespace sundog::cpu
