// SPDX-License-Identifier: Apache-2.0
#include "viewer/frame_budget.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace sundog::viewer {
namespace {

constexpr double kTarget_s = 1.0 / 60;
constexpr PixelSize kWindow{1920, 1080};

// Renders pictures on an imaginary device of the given speed until the size has settled.
PixelSize settle(FrameBudget& budget, double s_per_pixel, int pictures = 60) {
    PixelSize size;
    for (int i = 0; i < pictures; ++i) {
        size = budget.size_for(kWindow);
        budget.report(size, s_per_pixel * static_cast<double>(size.pixels()));
    }
    return size;
}

// Catches a controller that misses its target: pictures too slow, or far smaller than affordable.
TEST(FrameBudget, SettlesJustUnderTheTarget) {
    for (const double s_per_pixel : {2e-8, 5e-8, 2e-7}) {
        FrameBudget budget(kTarget_s);
        const double seconds = s_per_pixel * static_cast<double>(settle(budget, s_per_pixel).pixels());
        EXPECT_LE(seconds, kTarget_s * 1.05) << s_per_pixel;
        EXPECT_GE(seconds, kTarget_s * 0.65) << s_per_pixel;
    }
}

// Catches one that never gives the full size where it is affordable.
TEST(FrameBudget, FullSizeWhereAffordable) {
    FrameBudget budget(kTarget_s);
    EXPECT_EQ(settle(budget, 1e-9), kWindow);
}

// Catches a first picture at full size of a scene that may take seconds.
TEST(FrameBudget, BeginsSmall) {
    FrameBudget budget(kTarget_s);
    EXPECT_LE(budget.size_for(kWindow).pixels(), 320 * 240 * 1.1);
    settle(budget, 1e-9);
    budget.forget();
    EXPECT_LE(budget.size_for(kWindow).pixels(), 320 * 240 * 1.1);
}

// Catches empty pictures on hopelessly slow devices and in tiny windows.
TEST(FrameBudget, NeverTooSmall) {
    FrameBudget budget(kTarget_s);
    const PixelSize smallest = settle(budget, 1);
    EXPECT_EQ(smallest, (PixelSize{240, 136}));
    const PixelSize tiny = budget.size_for({3, 2});
    EXPECT_GE(tiny.width, 1);
    EXPECT_GE(tiny.height, 1);
}

// Catches a size that flickers between two values when timings vary by a few percent.
TEST(FrameBudget, StandsStillUnderNoise) {
    FrameBudget budget(kTarget_s);
    settle(budget, 1e-7);
    std::set<std::pair<int, int>> sizes;
    for (int i = 0; i < 100; ++i) {
        const PixelSize size = budget.size_for(kWindow);
        sizes.insert({size.width, size.height});
        budget.report(size, 1e-7 * (i % 3 == 0 ? 1.06 : 0.97) * static_cast<double>(size.pixels()));
    }
    EXPECT_EQ(sizes.size(), 1U);
}

// Catches one that takes many slow pictures to notice that the view has become expensive.
TEST(FrameBudget, AnswersToASlowPictureAtOnce) {
    FrameBudget budget(kTarget_s);
    const PixelSize before = settle(budget, 2e-8);
    budget.report(before, 20e-8 * static_cast<double>(before.pixels()));
    EXPECT_LE(20e-8 * static_cast<double>(budget.size_for(kWindow).pixels()), kTarget_s);
}

}  // namespace
}  // namespace sundog::viewer
