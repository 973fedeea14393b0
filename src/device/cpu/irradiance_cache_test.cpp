// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/irradiance_cache.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sundog::cpu {
namespace {

constexpr Vec3 kUp{0, 0, 1};

// Catches a sample that reaches further than its bound, and one that cells lose.
TEST(IrradianceCache, SamplesReachAsFarAsTheirError) {
    IrradianceCache cache(0.5F);
    cache.add({{10, -3, 0.25F}, kUp, {1, 2, 3}, 4});
    for (const Vec3 way : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.6F, -0.8F, 0}}) {
        const Vec3 near = Vec3{10, -3, 0.25F} + way * 1.99F;
        const Vec3 far = Vec3{10, -3, 0.25F} + way * 2.01F;
        EXPECT_EQ(cache.lookup(near, kUp, 0.5F).count, 1);
        EXPECT_EQ(cache.lookup(far, kUp, 0.5F).count, 0);
        EXPECT_EQ(cache.lookup(near, kUp, 0.25F).count, 0) << "a tighter bound";
    }
    EXPECT_TRUE(cache.lookup({10, -3, 0.25F}, kUp, 0.5F).light == (Vec3{1, 2, 3}));
}

// Catches light that leaks through thin walls, round edges, and under what stands on a floor.
TEST(IrradianceCache, SurfacesThatFaceElsewhereShareNothing) {
    IrradianceCache cache(1.8F);
    cache.add({{0, 0, 0}, kUp, {1, 1, 1}, 1});
    EXPECT_EQ(cache.lookup({0, 0, -0.001F}, {0, 0, -1}, 1.8F).count, 0) << "a wall's other side";
    EXPECT_EQ(cache.lookup({0.1F, 0, 0}, {1, 0, 0}, 1.8F).count, 0) << "round a corner";
    EXPECT_EQ(cache.lookup({0.1F, 0, -0.3F}, kUp, 1.8F).count, 0) << "the sample lies above the point";
    EXPECT_EQ(cache.lookup({0.1F, 0, 0}, kUp, 1.8F).count, 1);
}

// Nearer samples count more, and one's weight ends smoothly where its reach does. Catches steps at that rim.
TEST(IrradianceCache, WeightsFallToZeroAtTheRim) {
    IrradianceCache cache(1);
    cache.add({{0, 0, 0}, kUp, {1, 0, 0}, 1});
    cache.add({{1, 0, 0}, kUp, {0, 1, 0}, 1});
    EXPECT_GT(cache.lookup({0.3F, 0, 0}, kUp, 1).light.x, 0.6F);
    EXPECT_NEAR(cache.lookup({0.999F, 0, 0}, kUp, 1).light.y, 1, 0.01F);
    EXPECT_FLOAT_EQ(cache.lookup({0.5F, 0, 0}, kUp, 1).light.x, 0.5F);
}

// Samples of very different reach lie in cells of different sizes, each of which is asked.
TEST(IrradianceCache, ReachesOfAnySizeAreFound) {
    IrradianceCache cache(1);
    for (int e = -20; e <= 20; ++e) cache.add({{0, 0, 0}, kUp, {1, 1, 1}, std::ldexp(1.0F, e)});
    EXPECT_EQ(cache.lookup({0, 0, 0}, kUp, 1).count, 41);
    EXPECT_EQ(cache.lookup({0.75F, 0, 0}, kUp, 1).count, 21);
    EXPECT_EQ(cache.lookup({3e30F, 0, 0}, kUp, 1).count, 0) << "out of all cells";
}

}  // namespace
}  // namespace sundog::cpu
