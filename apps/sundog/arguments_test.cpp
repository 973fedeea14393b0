// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"

#include <gtest/gtest.h>

#include "usage_error.h"

namespace sundog::app {
namespace {

// Catches sizes that are read by a lenient scanner: signs, blanks, trailing junk, overflow, zero.
TEST(Arguments, Sizes) {
    EXPECT_EQ(parse_size("1920x1080").width, 1920);
    EXPECT_EQ(parse_size("1x65535").height, 65535);
    for (const char* bad : {"",
                            "x",
                            "640",
                            "640x",
                            "x480",
                            "0x0",
                            "640x0",
                            "-640x480",
                            "640x-480",
                            "65536x1",
                            "1000000x1000000",
                            "99999999999x1",
                            "640x480x2",
                            "640X480",
                            "6 40x480",
                            " 640x480",
                            "640x480 ",
                            "1e3x1e3",
                            "640.5x480",
                            "+640x480",
                            "0x10x10"})
        EXPECT_THROW(parse_size(bad), UsageError) << bad;
}

// Catches infinities and NaN as values, and half-read numbers.
TEST(Arguments, Numbers) {
    EXPECT_EQ(parse_float("--time", "-2.5", -10, 10), -2.5F);
    for (const char* bad : {"nan", "inf", "-inf", "1e99", "11", "1,5", "1.5s", "", "-"})
        EXPECT_THROW(parse_float("--time", bad, -10, 10), UsageError) << bad;
    EXPECT_EQ(parse_int("--spp", "16", 1, 100), 16);
    for (const char* bad : {"0", "101", "1.5", "abc", "", "9999999999999"})
        EXPECT_THROW(parse_int("--spp", bad, 1, 100), UsageError) << bad;
}

// Catches ranges that run backwards or without end.
TEST(Arguments, Frames) {
    EXPECT_EQ(parse_frames("3..7").last, 7);
    EXPECT_EQ(parse_frames("5").first, 5);
    for (const char* bad : {"7..3", "..", "1..", "..3", "-1..3", "0..1000000", "1...3", "1-3", "a..b"})
        EXPECT_THROW(parse_frames(bad), UsageError) << bad;
}

// Catches planes that get lost in a list, and misspelt ones without a suggestion.
TEST(Arguments, Aovs) {
    const AovChoice some = parse_aovs("depth,samples");
    EXPECT_EQ(some.planes, kernel::AOV_DEPTH);
    EXPECT_TRUE(some.samples);
    EXPECT_EQ(parse_aovs("all").planes,
              kernel::AOV_DEPTH | kernel::AOV_NORMAL | kernel::AOV_ALBEDO | kernel::AOV_OBJECT | kernel::AOV_COST);
    EXPECT_THROW(parse_aovs(""), UsageError);
    EXPECT_THROW(parse_aovs("depth,"), UsageError);
    try {
        parse_aovs("depth,normla");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_EQ(error.hint(), "did you mean 'normal'?");
    }
}

// Catches a structure whose name is lost between the command line and the device.
TEST(Arguments, Accelerations) {
    for (const std::string_view name : kAccelerationNames) EXPECT_EQ(name_of(parse_acceleration(name)), name);
    EXPECT_EQ(parse_acceleration("kdtree"), Acceleration::kdtree);
    try {
        parse_acceleration("kd-tree");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_EQ(error.hint(), "did you mean 'kdtree'?");
    }
}

// Catches a wrong choice, near to none of the right ones, whose message doesn't name these.
TEST(Arguments, WrongChoicesNameTheRightOnes) {
    const auto said = [](const auto& parse) -> std::string {
        try {
            parse();
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(said([] { parse_acceleration("xyz"); }),
              "--accel 'xyz': expected embree, bvh, kdtree, octree, grid, boxes or none");
    EXPECT_EQ(said([] { parse_switch("--shadows", "maybe"); }), "--shadows 'maybe': expected on or off");
    EXPECT_EQ(said([] { parse_choice("--show", "x", {"cost"}); }), "--show 'x': expected cost");
    EXPECT_EQ(said([] { parse_aovs("depth,xyz"); }),
              "--aov 'xyz': expected depth, normal, albedo, object, samples, cost or all");
}

// Catches a way of finding first hits whose name is lost between the command line and the device.
TEST(Arguments, PrimaryHits) {
    EXPECT_EQ(parse_primary("auto"), PrimaryHits::automatic);
    EXPECT_EQ(parse_primary("trace"), PrimaryHits::trace);
    EXPECT_EQ(parse_primary("raster"), PrimaryHits::raster);
    EXPECT_THROW(parse_primary("rasta"), UsageError);
}

// Catches a message that echoes a terminal's control sequences.
TEST(Arguments, EchoedValuesAreTamed) {
    try {
        parse_size("\x1b[31mred" + std::string(1000, 'x'));
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_EQ(std::string(error.what()).find('\x1b'), std::string::npos);
        EXPECT_LT(std::string(error.what()).size(), 200U);
    }
}

}  // namespace
}  // namespace sundog::app
