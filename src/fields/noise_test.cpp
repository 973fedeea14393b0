// SPDX-License-Identifier: Apache-2.0
#include "fields/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "kernel/patterns/noise.h"

namespace sundog::fields {
namespace {

class RandomPoints {
public:
    double number(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(random_); }
    Vec3d point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }

private:
    std::mt19937 random_{7};
};

// A share, a corner or a hash that isn't the kernel's: functions would not fit the picture.
TEST(FieldsNoise, IsTheKernels) {
    RandomPoints random;
    NoiseCells cells;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d p = random.point(20);
        const kernel::real3 at(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
        const Vec3d rounded{at.x, at.y, at.z};
        for (const std::uint32_t generator : {1U, 2U, 3U})
            EXPECT_NEAR(noise_at(cells, rounded, generator), kernel::noise_value(at, generator), 2e-6);
    }
}

// A term left out of the gradient.
TEST(FieldsNoise, GradientIsTheLimitOfDifferences) {
    RandomPoints random;
    NoiseCells cells;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d p = random.point(5);
        const NoiseSample n = noise_with_gradient(cells, p, 2);
        EXPECT_NEAR(noise_at(cells, p, 2), std::clamp(n.value, 0.0, 1.0), 1e-14);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Vec3d step;
            step[axis] = 1e-6;
            const double difference =
                (noise_with_gradient(cells, p + step, 2).value - noise_with_gradient(cells, p - step, 2).value) / 2e-6;
            EXPECT_NEAR(n.gradient[axis], difference, 1e-5);
        }
    }
}

// A bound that is exceeded somewhere: isosurfaces would get holes.
TEST(FieldsNoise, BoxesEncloseTheirPoints) {
    RandomPoints random;
    NoiseCells cells;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d centre = random.point(5);
        const double size = std::exp(random.number(-6, 1));
        const Vec3d half{size * random.number(0, 1), size * random.number(0, 1), size * random.number(0, 1)};
        const NoiseOverBox box = noise_over_box(cells, centre, half, 2);
        for (int k = 0; k < 10; ++k) {
            const Vec3d offset = half * random.point(1);
            const double linear = box.centre.value + dot(box.centre.gradient, offset);
            EXPECT_NEAR(noise_with_gradient(cells, centre + offset, 2).value, linear, box.error);
        }
    }
}

}  // namespace
}  // namespace sundog::fields
