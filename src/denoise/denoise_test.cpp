// SPDX-License-Identifier: Apache-2.0
#include "denoise/denoise.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace sundog::denoise {
namespace {

/// Uniform in (0, 1), by SplitMix64.
class Random {
public:
    float operator()() {
        std::uint64_t bits = state_ += 0x9e3779b97f4a7c15U;
        bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
        bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
        return (static_cast<float>((bits ^ (bits >> 31U)) >> 40U) + 0.5F) * 0x1p-24F;
    }

private:
    std::uint64_t state_ = 1;
};

/// A ball in the light over a checkered floor with a soft shadow, before a wall: known without noise.
struct Picture {
    explicit Picture(int side_) : side(side_) {
        const auto s = static_cast<float>(side);
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const float x = static_cast<float>(i) / s, y = static_cast<float>(j) / s;
                const float bx = (x - 0.6F) / 0.25F, by = (y - 0.45F) / 0.25F;
                float light = 0;
                if (bx * bx + by * by < 1) {
                    const float bz = std::sqrt(1 - bx * bx - by * by);
                    normal.push_back({bx, -by, bz});
                    depth.push_back(4 - bz);
                    albedo.push_back({0.8F, 0.3F, 0.2F});
                    light = 0.1F + std::max(0.0F, dot(normal.back(), normalize(Vec3{-0.5F, 0.7F, 0.6F})));
                } else if (y < 0.55F) {
                    normal.push_back({0, 0, 1});
                    depth.push_back(6);
                    albedo.push_back({0.5F, 0.6F, 0.7F});
                    light = 0.3F + 0.5F * x;
                } else {
                    normal.push_back({0, 1, 0});
                    depth.push_back(3.3F / y);
                    const bool dark = (static_cast<int>(x * 24) + static_cast<int>(6 / y)) % 2 == 0;
                    albedo.push_back(dark ? Vec3{0.1F, 0.1F, 0.1F} : Vec3{0.9F, 0.9F, 0.8F});
                    const float edge = (x + y - 1.3F) * 12;
                    light = 0.2F + 0.8F / (1 + std::exp(-edge));
                }
                clean.push_back(albedo.back() * light);
            }
    }

    /// Two halves of `samples` samples each whose spread is `spread` times their mean; now and then one is a hundred
    /// times as bright.
    void add_noise(int samples, float spread, float fireflies) {
        Random random;
        const auto half = [&] {
            std::vector<Vec3> out;
            for (const Vec3 mean : clean) {
                float sum = 0;
                for (int i = 0; i < samples; ++i) {
                    // Of mean 1, and of variance spread^2.
                    sum += 1 + spread * std::sqrt(12.0F) * (random() - 0.5F);
                    if (random() < fireflies) sum += 100 * random();
                }
                out.push_back(mean * (sum / static_cast<float>(samples)));
            }
            return out;
        };
        const std::vector<Vec3> half_a = half(), half_b = half();
        noisy.clear();
        variance.clear();
        for (std::size_t i = 0; i < clean.size(); ++i) {
            noisy.push_back((half_a[i] + half_b[i]) * 0.5F);
            const Vec3 apart = (half_a[i] - half_b[i]) * 0.5F;
            variance.push_back(apart * apart);
        }
    }

    [[nodiscard]] NoisyPicture planes(bool with_guides = true) const {
        NoisyPicture p;
        p.width = p.height = side;
        p.radiance = noisy;
        p.variance = variance;
        if (with_guides) p.albedo = albedo, p.normal = normal, p.depth = depth;
        return p;
    }

    [[nodiscard]] double error(const std::vector<Vec3>& picture) const {
        double sum = 0;
        for (std::size_t i = 0; i < clean.size(); ++i) {
            const Vec3 d = picture[i] - clean[i];
            sum += static_cast<double>(dot(d, d));
        }
        return sum / static_cast<double>(3 * clean.size());
    }

    int side;
    std::vector<Vec3> clean, noisy, variance, albedo, normal;
    std::vector<float> depth;
};

std::vector<Vec3> denoised(const NoisyPicture& picture) { return denoise::denoised(picture, StopFlag{}); }

// Catches a filter that leaves noise, or blurs what it should keep.
TEST(Denoise, LowersTheErrorAtLeastFourfold) {
    Picture picture(128);
    picture.add_noise(4, 0.8F, 0);
    const double before = picture.error(picture.noisy);
    EXPECT_LT(picture.error(denoised(picture.planes())), before / 15);
    EXPECT_LT(picture.error(denoised(picture.planes(false))), before / 4) << "without guides";
}

// Catches single bright samples that are smeared over their surroundings.
TEST(Denoise, CutsFirefliesDown) {
    Picture picture(128);
    picture.add_noise(4, 0.3F, 2e-4F);
    const std::vector<Vec3> out = denoised(picture.planes());
    EXPECT_LT(picture.error(out), picture.error(picture.noisy) / 50);
    for (std::size_t i = 0; i < out.size(); ++i)
        EXPECT_LT(out[i].x, 2 * picture.clean[i].x + 0.3F) << i % 128 << " " << i / 128;
}

// Catches blur where there is nothing to remove: textures, edges and highlights of one pixel.
TEST(Denoise, LeavesAPictureWithoutNoise) {
    Picture picture(128);
    picture.clean[64 * 128 + 20] = {50, 60, 70};
    picture.noisy = picture.clean;
    picture.variance.assign(picture.clean.size(), {0, 0, 0});
    const std::vector<Vec3> out = denoised(picture.planes());
    for (std::size_t i = 0; i < out.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(out[i][c], picture.clean[i][c], 1e-3F * std::max(1.0F, picture.clean[i][c])) << i;
}

// Catches sums whose order depends on who does the work.
TEST(Denoise, SameBitsForAnyNumberOfThreads) {
    Picture picture(100);
    picture.add_noise(2, 0.7F, 1e-3F);
    const std::vector<Vec3> all = denoised(picture.planes());
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(denoised(picture.planes()), all);
}

// Catches a number that is none spreading over the picture, and pictures smaller than what the filter reaches.
TEST(Denoise, OddPicturesComeBackFinite) {
    constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Picture picture(40);
    picture.add_noise(2, 0.7F, 0);
    picture.noisy[100] = {kNoNumber, kInfinity, -kInfinity};
    picture.variance[100] = {kInfinity, kNoNumber, -1};
    picture.albedo[200] = picture.normal[300] = {kNoNumber, 0, kInfinity};
    picture.depth[400] = kInfinity;
    picture.depth[401] = kNoNumber;
    picture.depth[402] = 0;
    for (const Vec3 pixel : denoised(picture.planes())) ASSERT_TRUE(is_finite(pixel));
    const std::vector<Vec3> one{{0.5F, 0.25F, 2}};
    EXPECT_NEAR(denoised({.width = 1, .height = 1, .radiance = one, .variance = one})[0].z, 2, 1e-4);
}

// Catches a window that waits for a picture which nobody wants any more.
TEST(Denoise, StopsWhenAsked) {
    Picture picture(64);
    picture.add_noise(2, 0.7F, 0);
    StopFlag stop;
    stop.request();
    EXPECT_TRUE(denoise::denoised(picture.planes(), stop).empty());
}

// Catches planes that are read beyond their end.
TEST(Denoise, RefusesPlanesOfAnotherSize) {
    const std::vector<Vec3> four(4), three(3);
    EXPECT_THROW(denoised({.width = 2, .height = 2, .radiance = four, .variance = three}), std::invalid_argument);
    EXPECT_THROW(denoised({.width = 2, .height = 2, .radiance = four, .variance = four, .albedo = three}),
                 std::invalid_argument);
    EXPECT_THROW(denoised({.width = 0, .height = 2, .radiance = {}, .variance = {}}), std::invalid_argument);
}

}  // namespace
}  // namespace sundog::denoise
