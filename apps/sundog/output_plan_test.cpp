// SPDX-License-Identifier: Apache-2.0
#include "output_plan.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/diagnostics.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

const std::optional<FrameRange> kOnePicture;
const std::optional<FrameRange> kFrames = FrameRange{0, 9};

std::string in_temp(const std::string& name) { return (std::filesystem::temp_directory_path() / name).string(); }

// Catches numbers that are put into the folder's name, lose their zeros, or are
// formatted by a user's format string.
TEST(OutputPlan, NumberedFiles) {
    EXPECT_EQ(numbered_file("a/turn.png", 7), "a/turn-0007.png");
    EXPECT_EQ(numbered_file("turn.png", 12345), "turn-12345.png");
    EXPECT_EQ(numbered_file("a/f%03d.png", 7), "a/f007.png");
    EXPECT_EQ(numbered_file("%d.png", 7), "7.png");
    for (const char* bad : {"%s.png", "%n.png", "%d%d.png", "%", "%0d.png", "%099d.png", "100%.png"})
        EXPECT_THROW(numbered_file(bad, 1), UsageError) << bad;
}

// Catches a render that starts although its place can't be written or its
// ending is unknown.
TEST(OutputPlan, ChecksThePlaceFirst) {
    EXPECT_THROW(plan_output("/no/such/folder/a.png", "", kOnePicture, false), OutputError);
    EXPECT_THROW(plan_output(in_temp("a.bmpp"), "", kOnePicture, false), UsageError);
    EXPECT_THROW(plan_output(in_temp("a"), "", kOnePicture, false), UsageError);
    const std::string folder = in_temp("sundog_plan.png");
    std::filesystem::create_directory(folder);
    EXPECT_THROW(plan_output(folder, "", kOnePicture, false), OutputError);
    std::filesystem::remove(folder);
}

// Catches the check itself leaving a file behind.
TEST(OutputPlan, TheCheckLeavesNothing) {
    const std::filesystem::path file = in_temp("sundog_plan_untouched.png");
    std::filesystem::remove(file);
    const OutputPlan plan = plan_output(file.string(), "", kOnePicture, false);
    EXPECT_EQ(plan.target, Target::image);
    EXPECT_FALSE(std::filesystem::exists(file));
}

// Catches combinations that would be silently ignored.
TEST(OutputPlan, RefusesWhatDoesNotFitTogether) {
    EXPECT_THROW(plan_output(in_temp("a.mp4"), "", kOnePicture, false), UsageError);
    EXPECT_THROW(plan_output(in_temp("a.png"), "", kOnePicture, true), UsageError);
    EXPECT_THROW(plan_output(in_temp("a.png"), "exr", kOnePicture, false), UsageError);
    EXPECT_THROW(plan_output("-", "", kFrames, false), UsageError);
    EXPECT_EQ(plan_output(in_temp("a.exr"), "", kOnePicture, true).format, output::Format::exr);
    EXPECT_EQ(plan_output(in_temp("a.png"), "", kFrames, false).target, Target::numbered_images);
}

}  // namespace
}  // namespace sundog::app
