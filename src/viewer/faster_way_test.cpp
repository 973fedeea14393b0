// SPDX-License-Identifier: Apache-2.0
#include "viewer/faster_way.h"

#include <gtest/gtest.h>

namespace sundog::viewer {
namespace {

/// Makes pictures the way it is told; how many of them were refined.
int refined_of(FasterWay& way, int pictures, double refined_s, double share, double traced_s) {
    int refined = 0;
    for (int i = 0; i < pictures; ++i) {
        if (way.refine_next()) {
            ++refined;
            way.report_refined(refined_s, share);
        } else {
            way.report_traced(traced_s);
        }
    }
    return refined;
}

// Catches slow pictures that are made only to find out what is known: they would stutter.
TEST(FasterWay, FewPointsNeedNoTrial) {
    FasterWay way;
    EXPECT_EQ(500, refined_of(way, 500, 1, 0.1, 5));
}

// Catches scenes of glass that are refined although that is slower, and trials that never end or never come again.
TEST(FasterWay, TheFasterWayIsFoundAndTriedAgain) {
    FasterWay glass;
    const int refined = refined_of(glass, 500, 1.3, 0.3, 1);
    EXPECT_GT(refined, 4);
    EXPECT_LT(refined, 20);
    FasterWay mirrors;
    EXPECT_GT(refined_of(mirrors, 500, 1, 0.4, 1.6), 480);
    // The view turns to where little has to be traced.
    EXPECT_GT(refined_of(glass, 500, 0.3, 0.1, 1), 430);
    glass.forget();
    EXPECT_TRUE(glass.refine_next());
}

}  // namespace
}  // namespace sundog::viewer
