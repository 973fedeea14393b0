// SPDX-License-Identifier: Apache-2.0
#include "viewer/playback.h"

#include <gtest/gtest.h>

namespace sundog::viewer {
namespace {

// Catches a clock that runs while paused, or jumps by the pause when it goes on.
TEST(Playback, RunsOnlyWhilePlaying) {
    Playback playback;
    playback.advance(0.5);
    EXPECT_FLOAT_EQ(playback.time_s(), 0.5F);
    playback.toggle();
    playback.advance(10);
    EXPECT_FLOAT_EQ(playback.time_s(), 0.5F);
    playback.toggle();
    playback.advance(0.25);
    EXPECT_FLOAT_EQ(playback.time_s(), 0.75F);
}

// Catches time before the beginning.
TEST(Playback, ScrubsToAnyMomentFromZero) {
    Playback playback;
    playback.scrub(12);
    EXPECT_FLOAT_EQ(playback.time_s(), 12);
    playback.scrub(-1);
    EXPECT_FLOAT_EQ(playback.time_s(), 0);
}

// Catches a clock in single precision, which after a day no longer moves by a 60th of a second.
TEST(Playback, KeepsTimeOverADay) {
    Playback playback;
    playback.scrub(86400);
    for (int i = 0; i < 6000; ++i) playback.advance(1.0 / 6000);
    EXPECT_NEAR(playback.time_s(), 86401, 0.01);
}

// Catches a time line that ends before the present moment.
TEST(Playback, RangeHoldsThePresent) {
    Playback playback;
    EXPECT_FLOAT_EQ(playback.range_s(), 20);
    for (const float time_s : {19.0F, 20.0F, 100.0F, 4000.0F, 1e6F}) {
        playback.scrub(time_s);
        EXPECT_GT(playback.range_s(), time_s);
    }
}

}  // namespace
}  // namespace sundog::viewer
