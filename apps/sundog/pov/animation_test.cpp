// SPDX-License-Identifier: Apache-2.0
// The expected numbers are what povray 3.7 printed for the same switches.
#include "animation.h"

#include <gtest/gtest.h>

#include "../usage_error.h"
#include "command_line.h"

namespace sundog::app {
namespace {

PovAnimation animation(const std::vector<std::string>& words) {
    return animation_of(read_command_line(words, {"/nowhere", {}, {}, {}}, {}));
}

// Catches stills that count as animations, and a clock that is lost.
TEST(Animation, Stills) {
    for (const auto& words : std::vector<std::vector<std::string>>{{}, {"+KI2"}, {"+KFF0"}, {"+KC"}, {"+SF3"}}) {
        const PovAnimation still = animation(words);
        EXPECT_FALSE(still.animated);
        EXPECT_EQ(still.count(), 1);
        EXPECT_EQ(still.clock_of(0).clock, 0);
        EXPECT_FALSE(still.clock_of(0).clock_on);
        EXPECT_EQ(still.clock_of(0).final_clock, 0);
    }
    const PovAnimation clocked = animation({"+K2.5"});
    EXPECT_FALSE(clocked.animated);
    EXPECT_EQ(clocked.clock_of(0).clock, 2.5);
    EXPECT_EQ(clocked.clock_of(0).initial_clock, 0);
    EXPECT_TRUE(clocked.clock_of(0).clock_on);
    EXPECT_TRUE(animation({"+K0"}).clock_on);
}

// Catches a clock that runs from the wrong value, or not to the last frame's.
TEST(Animation, ClockRunsOverTheFrames) {
    const PovAnimation three = animation({"+KFF3"});
    EXPECT_EQ(three.first, 1);
    EXPECT_EQ(three.last, 3);
    EXPECT_EQ(three.clock_of(1).clock, 0);
    EXPECT_EQ(three.clock_of(2).clock, 0.5);
    EXPECT_EQ(three.clock_of(3).clock, 1);
    EXPECT_EQ(three.clock_of(2).clock_delta, 0.5);
    EXPECT_EQ(three.clock_of(2).frame_number, 2);
    EXPECT_TRUE(three.clock_of(2).clock_on);
    const PovAnimation scaled = animation({"+KFF3", "+KI2", "+KF8", "+K7"});
    EXPECT_EQ(scaled.clock_of(2).clock, 5);
    EXPECT_EQ(scaled.clock_delta, 3);
    const PovAnimation later = animation({"+KFI11", "+KFF20"});
    EXPECT_EQ(later.clock_of(11).clock, 0);
    EXPECT_EQ(later.clock_of(20).clock, 1);
}

// Catches a cyclic animation whose last frame repeats its first, and other frame counts than povray's.
TEST(Animation, CyclicEndsOneStepEarly) {
    const PovAnimation cyclic = animation({"+KFI0", "+KFF3", "+KC"});
    EXPECT_EQ(cyclic.count(), 4);
    EXPECT_EQ(cyclic.clock_delta, 0.25);
    EXPECT_EQ(cyclic.clock_of(3).clock, 0.75);
    EXPECT_EQ(cyclic.clock_of(3).final_frame, 4) << "as povray tells the scene";
    EXPECT_EQ(animation({"+KFF3", "+KI2", "+KF8", "+KC"}).clock_of(2).clock, 4);
}

// Catches division by zero where there is one frame, and negative or backward ranges.
TEST(Animation, OddRanges) {
    const PovAnimation one = animation({"+KFF1", "+KI3"});
    EXPECT_TRUE(one.animated);
    EXPECT_EQ(one.count(), 1);
    EXPECT_EQ(one.clock_of(1).clock, 3);
    EXPECT_EQ(animation({"+KFI5", "+KFF3"}).first, 5);
    EXPECT_EQ(animation({"+KFI5", "+KFF3"}).last, 5);
    EXPECT_EQ(animation({"+KFI-2", "+KFF2"}).first, 0);
    EXPECT_EQ(animation({"+KFI3"}).last, 3);
}

// Catches subsets that change the clock, or begin or end elsewhere than povray's.
TEST(Animation, Subsets) {
    const PovAnimation some = animation({"+KFF10", "+SF0.333", "+EF0.667"});
    EXPECT_EQ(some.first, 3);
    EXPECT_EQ(some.last, 6);
    EXPECT_DOUBLE_EQ(some.clock_of(3).clock, 2 / 9.0);
    EXPECT_EQ(animation({"+KFF100", "+SF2", "+EF3"}).last, 3);
    EXPECT_EQ(animation({"+KFF4", "+SF0"}).first, 1);
    EXPECT_EQ(animation({"+KFF4", "+EF2.7"}).last, 2);
    EXPECT_EQ(animation({"+KFF20", "+SF1.0", "+EF1"}).last, 1) << "1 is a frame's number, not all of them";
    EXPECT_EQ(animation({"+KFF4", "+EF9"}).last, 4);
    EXPECT_EQ(animation({"+KFF10", "+STP3"}).count(), 4);
    EXPECT_THROW(animation({"+KFF3", "+SF5"}), UsageError);
}

// Catches a number of digits that differs between the frames of one animation.
TEST(Animation, DigitsOfTheFinalFrame) {
    EXPECT_EQ(animation({"+KFF9"}).digits(), 1);
    EXPECT_EQ(animation({"+KFF9", "+KC"}).digits(), 2);
    EXPECT_EQ(animation({"+KFF10", "+SF3", "+EF3"}).digits(), 2);
    EXPECT_EQ(animation({"+KFF1000"}).digits(), 4);
}

}  // namespace
}  // namespace sundog::app
