// SPDX-License-Identifier: Apache-2.0
// Parts of pictures with their means, and how sure these are: what methods that are biased by design are held to.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scenes/scene_builder.h"

namespace sundog::test {

/// Columns and rows, the last ones not included.
struct Region {
    std::string name;
    int left, right, top, bottom;
};

inline Vec3 mean_of(const Film& film, const Region& r) {
    Vec3 sum;
    for (int y = r.top; y < r.bottom; ++y)
        for (int x = r.left; x < r.right; ++x) sum += film.mean(x, y);
    return sum / static_cast<float>((r.right - r.left) * (r.bottom - r.top));
}

/// Means of regions by paths, from pictures of several seeds, and the standard errors of these means.
class PathMeans {
public:
    PathMeans(Device& device, const scene::Scene& s, FrameOptions options, std::uint32_t samples,
              const std::vector<Region>& regions)
        : means_(regions.size()), errors_(regions.size()) {
        options.integrator = kernel::INTEGRATOR_PATH;
        for (int i = 0; i < kPictures; ++i) {
            options.seed = static_cast<std::uint32_t>(i + 1);
            const Film film = render_on(device, s, options, samples).film;
            for (std::size_t k = 0; k < regions.size(); ++k) {
                const Vec3 mean = mean_of(film, regions[k]);
                means_[k] += mean / static_cast<float>(kPictures);
                errors_[k] += mean * mean / static_cast<float>(kPictures);
            }
        }
        for (std::size_t k = 0; k < regions.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c)
                errors_[k][c] =
                    std::sqrt(std::max(errors_[k][c] - means_[k][c] * means_[k][c], 0.0F) / (kPictures - 1));
    }

    /// Holds a picture's region to within `share` of the reference, and three standard errors of that, which must
    /// themselves be small beside what is allowed.
    void expect_near(const Film& film, const std::vector<Region>& regions, float share) const {
        for (std::size_t k = 0; k < regions.size(); ++k) {
            const Vec3 mean = mean_of(film, regions[k]);
            for (std::size_t c = 0; c < 3; ++c) {
                SCOPED_TRACE(regions[k].name + ", channel " + std::to_string(c));
                EXPECT_LT(3 * errors_[k][c], share * means_[k][c]) << "the reference is too noisy";
                EXPECT_NEAR(mean[c] / means_[k][c], 1, share + 3 * errors_[k][c] / means_[k][c]) << mean[c];
            }
        }
    }
    /// That a picture made without the method is farther off somewhere than `expect_near` would allow by far: else the
    /// method needn't have brought anything.
    void expect_off(const Film& film, const std::vector<Region>& regions, float share, const char* without) const {
        float off = 0;
        for (std::size_t k = 0; k < regions.size(); ++k)
            off = std::max(off, std::abs(mean_of(film, regions[k]).y / means_[k].y - 1));
        EXPECT_GT(off, 3 * share) << without;
    }

private:
    static constexpr int kPictures = 16;
    std::vector<Vec3> means_, errors_;
};

}  // namespace sundog::test
