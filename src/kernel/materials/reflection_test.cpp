// SPDX-License-Identifier: Apache-2.0
#include "kernel/materials/reflection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sundog::kernel {
namespace {

// A surface between equal media mirrors nothing, at no angle. Catches 0/0, and grazing rays that are taken for totally
// reflected: they would be mirrored whole and go on whole, over and over.
TEST(Reflection, EqualMediaMirrorNothing) {
    for (const float cosine : {0.0F, 1e-30F, 1e-4F, 0.3F, 1.0F}) {
        EXPECT_EQ(fresnel_dielectric(real(cosine), real(1.0F)), 0) << cosine;
        EXPECT_FALSE(is_total_reflection(real(cosine), real(1.0F))) << cosine;
    }
}

// Catches a critical angle that is off, or total reflection from the thinner side.
TEST(Reflection, TotalReflectionBeginsAtTheCriticalAngle) {
    const float eta = 1.5F;
    const float critical = std::sqrt(1 - 1 / (eta * eta));  // cosine
    EXPECT_TRUE(is_total_reflection(real(critical - 1e-3F), real(eta)));
    EXPECT_EQ(fresnel_dielectric(real(critical - 1e-3F), real(eta)), 1);
    EXPECT_FALSE(is_total_reflection(real(critical + 1e-3F), real(eta)));
    EXPECT_FALSE(is_total_reflection(real(0.0F), real(1 / eta)));
    EXPECT_NEAR(fresnel_dielectric(real(1.0F), real(eta)), 0.04F, 1e-6F);
}

}  // namespace
}  // namespace sundog::kernel
