// SPDX-License-Identifier: Apache-2.0
#include "viewer/replay.h"

#include <gtest/gtest.h>

#include <cstring>

namespace sundog::viewer {
namespace {

const kernel::Camera kCamera{{0.1F, -10, 1e-7F}, {0, 1.0F / 3, 0}, {1.7777778F, 0, 0}, {0, 0, 1}};

// Catches digits lost on the way: the replayed picture would not be the one that was seen.
TEST(Replay, CameraComesBackBitForBit) {
    const auto camera = parse_camera_argument(camera_argument(kCamera));
    ASSERT_TRUE(camera);
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): to the last bit
    EXPECT_EQ(std::memcmp(&*camera, &kCamera, sizeof kCamera), 0);
}

// Catches a reader that takes anything: too few, too many, words, infinities, a view without extent.
TEST(Replay, RefusesWhatIsNoCamera) {
    EXPECT_TRUE(parse_camera_argument("0,-10,0,0,1,0,1,0,0,0,0,1"));
    for (const char* text : {"", "1,2,3", "0,-10,0,0,1,0,1,0,0,0,0,1,5", "0,-10,0,0,1,0,1,0,0,0,0,1,",
                             "0,-10,0,0,1,0,1,0,0,0,0,x", "0,-10,0,0,1,0,1,0,0,0,0,inf", "0,-10,0,0,1,0,1,0,0,0,0,nan",
                             "0,-10,0,0,1,0,1,0,0,0,0,1e99", "0,-10,0,0,1,0,1,0,0,1,0,0", "0;-10;0;0;1;0;1;0;0;0;0;1"})
        EXPECT_FALSE(parse_camera_argument(text)) << text;
}

// Catches a command line that a shell would read differently.
TEST(Replay, QuotesForTheShell) {
    EXPECT_EQ(shell_quoted("scenes/table.scene"), "scenes/table.scene");
    EXPECT_EQ(shell_quoted("my scene.obj"), "'my scene.obj'");
    EXPECT_EQ(shell_quoted("it's $HOME"), "'it'\\''s $HOME'");
    EXPECT_EQ(shell_quoted(""), "''");
}

// Catches a setting of the window that the replay forgets.
TEST(Replay, CarriesAllThatTheWindowSet) {
    FrameOptions options;
    options.width = 640;
    options.height = 480;
    options.time_s = 2.5F;
    options.camera = kernel::Camera{{0, -10, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    EXPECT_EQ(replay_command("a b.scene", "cpu", options, 3, 4),
              "sundog render 'a b.scene' --device cpu --time 2.5 --camera 0,-10,0,0,1,0,1,0,0,0,0,1 "
              "--size 640x480 --pixel 3,4");
    options.max_depth = 7;
    options.min_weight = 0.25F;
    options.shadows = false;
    const std::string command = replay_command("a.scene", "gpu", options, 3, 4);
    EXPECT_NE(command.find(" --max-depth 7 --min-weight 0.25 --shadows off"), std::string::npos) << command;
}

}  // namespace
}  // namespace sundog::viewer
