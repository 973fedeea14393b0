// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/chunks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sundog::vulkan {
namespace {

/// How often each pixel of the region comes.
std::vector<int> covered(PixelRect region, std::uint64_t pixels, std::uint64_t& largest) {
    std::vector<int> times(static_cast<std::size_t>(region.width()) * static_cast<std::size_t>(region.height()), 0);
    largest = 0;
    for (Chunks chunks(region); !chunks.done();) {
        const PixelRect rect = chunks.next(pixels);
        EXPECT_GT(rect.width(), 0);
        EXPECT_GT(rect.height(), 0);
        largest =
            std::max(largest, static_cast<std::uint64_t>(rect.width()) * static_cast<std::uint64_t>(rect.height()));
        for (int y = rect.y0; y < rect.y1; ++y) {
            for (int x = rect.x0; x < rect.x1; ++x) {
                ++times.at(static_cast<std::size_t>(y - region.y0) * static_cast<std::size_t>(region.width()) +
                           static_cast<std::size_t>(x - region.x0));
            }
        }
    }
    return times;
}

// Catches pixels left out, computed twice or outside the region, and dispatches larger than asked for.
TEST(Chunks, CoverEachPixelOnceWithinTheBudget) {
    for (const PixelRect region : {PixelRect{0, 0, 1, 1}, PixelRect{3, 5, 103, 66}, PixelRect{0, 0, 64, 64},
                                   PixelRect{0, 0, 9, 200}, PixelRect{0, 0, 500, 7}}) {
        for (const std::uint64_t pixels : {1ULL, 64ULL, 100ULL, 800ULL, 1000ULL, 5000ULL, 1ULL << 40U}) {
            std::uint64_t largest = 0;
            for (const int times : covered(region, pixels, largest)) ASSERT_EQ(times, 1);
            EXPECT_LE(largest, std::max<std::uint64_t>(pixels, 64));
        }
    }
}

// Catches an endless loop over an empty region.
TEST(Chunks, OfNothingAreDone) {
    EXPECT_TRUE(Chunks(PixelRect{0, 0, 0, 10}).done());
    EXPECT_TRUE(Chunks(PixelRect{5, 5, 9, 5}).done());
}

// Catches dispatches that grow without bound on fast scenes, or never shrink on slow ones.
TEST(Pace, FollowsTheTimeThatPathsTake) {
    Pace pace;
    for (int i = 0; i < 20; ++i) pace.learn(pace.paths(), 1e-3 * static_cast<double>(pace.paths()));
    EXPECT_LE(pace.paths(), 1024U);
    for (int i = 0; i < 40; ++i) pace.learn(pace.paths(), 1e-6);
    const std::uint64_t most = pace.paths();
    pace.learn(most, 1e-6);
    EXPECT_EQ(pace.paths(), most);
    // A small dispatch that was fast must not lower the pace.
    pace.learn(100, 1e-6);
    EXPECT_EQ(pace.paths(), most);
}

}  // namespace
}  // namespace sundog::vulkan
