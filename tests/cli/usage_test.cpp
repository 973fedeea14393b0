// SPDX-License-Identifier: Apache-2.0
// What the program says to wrong calls, and with which exit status.
#include <gtest/gtest.h>

#include "program.h"

namespace sundog::tests {
namespace {

struct WrongCall {
    std::vector<std::string> arguments;
    std::string said;
};

// Catches wrong calls that are ignored, end with another status than 2, or get no message that helps.
TEST(Usage, WrongCallsEndWith2AndSayWhatIsRight) {
    const std::string scene = table_scene();
    const std::vector<WrongCall> calls{
        {{"rendr", scene}, "did you mean 'render'?"},
        {{"render", scene, "-o", "a.png", "--siez", "64x48"}, "did you mean '--size'"},
        {{"render", scene, "-o", "a.png", "surplus"}, "unexpected argument 'surplus'"},
        {{"render", scene}, "nothing says where the picture goes"},
        {{"render", scene, "-o", "a.png", "--size", "0x0"}, "from 1 to 65535"},
        {{"render", scene, "-o", "a.png", "--size", "1000000x1000000"}, "from 1 to 65535"},
        {{"render", scene, "-o", "a.png", "--size", "-64x48"}, "from 1 to 65535"},
        {{"render", scene, "-o", "a.png", "--size", "large"}, "--size 1920x1080"},
        {{"render", scene, "-o", "a.png", "--size"}, "--size"},
        {{"render", scene, "-o", "a.png", "--size", "64x48", "--size", "32x24"}, "--size"},
        {{"render", scene, "-o", "a.png", "--spp", "0"}, "from 1 to 65536"},
        {{"render", scene, "-o", "a.png", "--max-depth", "-1"}, "from 0 to 10000"},
        {{"render", scene, "-o", "a.png", "--min-weight", "nan"}, "from 0 to 1"},
        {{"render", scene, "-o", "a.png", "--time", "inf"}, "expected a number"},
        {{"render", scene, "-o", "a.png", "--frames", "9..1"}, "A <= B"},
        {{"render", scene, "-o", "a.png", "--device", "gpuu"}, "did you mean 'gpu'"},
        {{"render", scene, "-o", "a.png", "--accel", "octre"}, "did you mean 'octree'"},
        {{"render", scene, "-o", "a.png", "--accel", "bvh", "--device", "gpu"}, "leave one of them out"},
        {{"render", scene, "-o", "a.png", "--show", "cost"}, "add --accel bvh"},
        {{"render", scene, "-o", "a.png", "--show", "cost", "--accel", "embree"}, "Embree hides its own"},
        {{"render", scene, "-o", "a.png", "--show", "costs", "--accel", "bvh"}, "did you mean 'cost'"},
        {{"render", scene, "-o", "a.mp4", "--show", "cost", "--accel", "bvh", "--frames", "0..2"}, "one picture"},
        {{"render", scene, "-o", "a.png", "--primary", "rater"}, "did you mean 'raster'"},
        {{"render", scene, "-o", "a.png", "--primary", "raster", "--accel", "bvh"}, "leave --accel out"},
        {{"render", scene, "-o", "a.png", "--primary", "raster", "--device", "gpu"}, "leave one of them out"},
        {{"bench", "--primary", "--accel"}, "measurements of their own"},
        {{"bench", "--accel", "--scene", "treee"}, "did you mean 'tree'"},
        {{"bench", "--accel", "--device", "gpu"}, "for the CPU"},
        {{"bench", "--scene", "tree"}, "--accel"},
        {{"render", scene, "-o", "a.png", "--aov", "depth"}, ".exr"},
        {{"render", scene, "-o", "a.exr", "--aov", "dept"}, "did you mean 'depth'"},
        {{"render", scene, "-o", "a.pngg"}, ".png"},
        {{"render", scene, "--pixel", "700,0"}, "outside the picture of"},
        {{"help", "rendre"}, "did you mean 'render'"},
        {{"compare", "a.png"}, "two pictures are needed"},
    };
    const TemporaryFolder folder;
    for (const WrongCall& call : calls) {
        const Outcome outcome = run(call.arguments, folder.path());
        SCOPED_TRACE(testing::PrintToString(call.arguments));
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(call.said), std::string::npos) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("sundog: error: ")) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "a wrong call leaves no file";
}

// Catches help that goes to standard error or fails, and commands that lack examples.
TEST(Usage, HelpIsOnStandardOutput) {
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {}, {"--help"}, {"help"}, {"help", "render"}, {"render", "--help"}, {"help", "info"}}) {
        const Outcome outcome = run(arguments);
        SCOPED_TRACE(testing::PrintToString(arguments));
        EXPECT_EQ(outcome.status, 0);
        EXPECT_NE(outcome.out.find("Examples:"), std::string::npos) << outcome.out;
        EXPECT_EQ(outcome.err, "");
    }
    EXPECT_EQ(run({"help"}).out, run({}).out) << "the overview, not the help of 'help'";
    EXPECT_TRUE(run({"--version"}).out.starts_with("sundog "));
}

// Catches a missing scene, or no scene at all, without a message that names what was looked for.
TEST(Usage, MissingScenes) {
    const TemporaryFolder folder;
    const Outcome missing = run({"render", "no-such.scene", "-o", "a.png"}, folder.path());
    EXPECT_EQ(missing.status, 1);
    EXPECT_NE(missing.err.find("no-such.scene"), std::string::npos) << missing.err;
    const Outcome none = run({"render", "-o", "a.png"}, folder.path());
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("raytracer.conf"), std::string::npos) << none.err;
}

// Catches a program that ignores raytracer.conf of the working folder.
TEST(Usage, ReadsRaytracerConfOfTheWorkingFolder) {
    const Outcome outcome = run({"info"}, SUNDOG_SOURCE_DIR "/scenes/table");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("table.obj"), std::string::npos) << outcome.out;
}

// Catches a device list without the CPU, or one that fails where there is no GPU.
TEST(Usage, ListsDevices) {
    const Outcome outcome = run({"info", "--devices"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("cpu ")) << outcome.out;
    EXPECT_NE(outcome.out.find("[auto]"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace sundog::tests
