// SPDX-License-Identifier: Apache-2.0
#include "base/vec.h"

#include <gtest/gtest.h>

namespace sundog {
namespace {

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, 1e-5F);
    EXPECT_NEAR(a.y, b.y, 1e-5F);
    EXPECT_NEAR(a.z, b.z, 1e-5F);
}

// Catches a rotation that turns the wrong way round: Z by 90 degrees must take X to Y.
TEST(Vec, RotationIsCounterClockwise) {
    expect_near(transform_vector(rotation({0, 0, 1}, 90), {1, 0, 0}), {0, 1, 0});
    expect_near(transform_vector(rotation({1, 0, 0}, 90), {0, 1, 0}), {0, 0, 1});
}

// Catches an inverse that forgets the translation or transposes.
TEST(Vec, InverseUndoes) {
    const Affine3 m = translation({1, 2, 3}) * rotation({0, 0.6F, 0.8F}, 33) * scaling({2, 3, 0.5F});
    expect_near(transform_point(inverse(m) * m, {4, -5, 6}), {4, -5, 6});
    expect_near(transform_point(m * inverse(m), {4, -5, 6}), {4, -5, 6});
}

}  // namespace
}  // namespace sundog
