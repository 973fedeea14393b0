// SPDX-License-Identifier: Apache-2.0
// The kernel's own functions against the library's, to the errors that their declarations promise. (That several lanes
// give the bits of one is tests/parity's business.)
#include "kernel/math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sundog::kernel {
namespace {

// Catches a wrong coefficient or a range left out: relative error for power and exp2, absolute for log2 and the angle.
TEST(KernelMath, TranscendentalFunctionsAreAccurate) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> number(-2, 2);
    for (int i = 0; i < 20000; ++i) {
        const float base = std::fabs(number(random));
        const float exponent = std::fabs(number(random)) * 100;
        const double exact = std::pow(static_cast<double>(base), static_cast<double>(exponent));
        if (exact > 1e-35 && exact < 1e35) {
            EXPECT_NEAR(power(base, exponent) / exact, 1.0, 4e-5) << base << ' ' << exponent;
        }
        EXPECT_NEAR(log2_positive(base + 1e-6F), std::log2(static_cast<double>(base + 1e-6F)), 2e-6);
        const float x = number(random) * 40;
        EXPECT_NEAR(exp2_clamped(x) / std::exp2(static_cast<double>(x)), 1.0, 4e-6);
        const float a = number(random), b = number(random);
        EXPECT_NEAR(angle_of(a, b), std::atan2(a, b), 2e-6);
    }
}

// Catches NaN or infinity where a highlight's cosine is zero, and where nothing at all is asked.
TEST(KernelMath, EdgesAreDefined) {
    EXPECT_EQ(power(0, 5), 0);
    EXPECT_EQ(power(0, 0), 0);
    EXPECT_EQ(angle_of(0, 0), 0);
    EXPECT_GT(exp2_clamped(-1000), 0);
    EXPECT_TRUE(std::isfinite(exp2_clamped(1000)));
}

}  // namespace
}  // namespace sundog::kernel
