// SPDX-License-Identifier: Apache-2.0
// The dipole of light below surfaces, against numbers that are found another way.
#include "kernel/bsdf/dipole.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sundog::kernel {
namespace {

/// The integral of the dipole's reflectance over the plane, over rings whose radii grow by the same factor.
vec3 over_the_plane(const Dipole& dipole, float length) {
    constexpr double kStep = 1.01;
    double sum[3] = {};
    for (double r = 1e-4 * length; r < 1e4 * length; r *= kStep) {
        const double middle = r * std::sqrt(kStep);
        const vec3 value = dipole_reflectance(dipole, static_cast<float>(middle * middle));
        const double ring = 3.14159265358979 * r * r * (kStep * kStep - 1);
        sum[0] += value.x * ring, sum[1] += value.y * ring, sum[2] += value.z * ring;
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

// What a medium is solved for is what its dipole reflects in all, whatever its scale and boundary. Catches a formula of
// the total that isn't the integral, a search that ends early, and lengths that aren't the medium's.
TEST(DipoleOfLight, ReflectsInAllWhatItIsSolvedFor) {
    for (const float ior : {1.0F, 1.5F, 2.5F})
        for (const float length : {1e-3F, 1.0F, 250.0F}) {
            const Dipole dipole = dipole_of({0.05F, 0.4F, 0.9F}, vec3(length), ior);
            const vec3 total = over_the_plane(dipole, length);
            EXPECT_NEAR(total.x, 0.05F, 2e-4F) << ior << " " << length;
            EXPECT_NEAR(total.y, 0.4F, 2e-3F) << ior << " " << length;
            EXPECT_NEAR(total.z, 0.9F, 5e-3F) << ior << " " << length;
        }
}

// With no boundary and an albedo of 1/2: half of (1 + exp(-4/3 s)) exp(-s) / 2 with s the root of 3/2. Catches a factor
// that is lost in both the search and the integral.
TEST(DipoleOfLight, TotalOfAHalfAbsorbingMedium) {
    const double s = std::sqrt(1.5);
    const auto total = static_cast<float>(0.25 * (1 + std::exp(-4.0 / 3 * s)) * std::exp(-s));
    EXPECT_NEAR(dipole_total(static_cast<float>(s), 1), total, 1e-6F);
    const Dipole dipole = dipole_of(vec3(total), vec3(2.0F), 1);
    EXPECT_NEAR(dipole.albedo.x, 0.5F, 2e-3F);
    EXPECT_NEAR(dipole.depth.x, 1.0F, 4e-3F);  // Twice as much is met as scatters.
    EXPECT_NEAR(dipole.fading.x, s, 5e-3F);
}

// Bad numbers: colours of 1 and more, and of 0. Catches media of no or of endless reach.
TEST(DipoleOfLight, StaysFinite) {
    const Dipole dipole = dipole_of({0, 1, 7}, vec3(1.0F), 1.5F);
    for (const float value : {dipole.albedo.x, dipole.albedo.y, dipole.depth.x, dipole.depth.z, dipole.fading.x,
                              dipole.fading.y, dipole.height.x}) {
        EXPECT_TRUE(std::isfinite(value));
        EXPECT_GT(value, 0);
    }
    EXPECT_LE(dipole.albedo.z, 1);
}

}  // namespace
}  // namespace sundog::kernel
