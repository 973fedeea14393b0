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
        {{"render", scene, "-o", "a.png", "--sampler", "sobel"}, "did you mean 'sobol'"},
        {{"render", scene, "-o", "a.png", "--sampler", "jittered", "--spp", "12"}, "--spp 9 or 16"},
        {{"render", scene, "-o", "a.png", "--sampler", "sobol", "--adaptive", "0.3"}, "same number of samples"},
        {{"render", scene, "-o", "a.png", "--filter", "gausian"}, "did you mean 'gaussian'"},
        {{"render", scene, "-o", "a.png", "--filter", "mitchell", "--spp", "4"}, "--spp 16 or more"},
        {{"render", scene, "-o", "a.png", "--filter", "tent", "--filter-radius", "20"}, "from 0.1 to 16"},
        {{"render", scene, "-o", "a.png", "--filter-radius", "2"}, "--filter gaussian"},
        {{"render", scene, "-o", "a.png", "--preview", "1.5"}, "from 0 to 1"},
        {{"render", scene, "-o", "a.png", "--preview", "0.1", "--spp", "4"}, "add --adaptive 0.3"},
        {{"render", scene, "-o", "a.png", "--preview", "0.1", "--filter", "box"}, "leave --filter out"},
        {{"render", scene, "-o", "a.png", "--adaptive", "4"}, "from 0 to 3"},
        {{"render", scene, "-o", "a.png", "--adaptive", "0.3", "--spp", "1"}, "for example --spp 9"},
        {{"render", scene, "-o", "a.png", "--adaptive", "0.3", "--adaptive-method", "3"}, "from 1 to 2"},
        {{"render", scene, "-o", "a.png", "--adaptive", "0.3", "--adaptive-depth", "3"}, "--adaptive-method 2"},
        {{"render", scene, "-o", "a.png", "--adaptive-by", "object"}, "add --adaptive 0.3"},
        {{"render", scene, "-o", "a.png", "--adaptive", "0.3", "--adaptive-by", "object,dept"}, "did you mean 'depth'"},
        {{"render", scene, "-o", "a.png", "--adaptive", "0.3", "--adaptive-method", "2", "--spp", "4"},
         "--adaptive-depth"},
        {{"render", scene, "-o", "a.png", "--target-error", "0"}, "from 0.0001 to 1"},
        {{"render", scene, "-o", "a.png", "--target-error", "0.1", "--spp", "8"}, "needs 16 samples"},
        {{"render", scene, "-o", "a.png", "--target-error", "0.1", "--adaptive", "0.3"}, "leave --adaptive"},
        {{"render", scene, "-o", "a.png", "--time-limit", "0"}, "from 0.01 to 1000000"},
        {{"render", scene, "-o", "a.png", "--preview-method", "scanline"}, "add --preview 0.1"},
        {{"bench", "--preview-method", "scanline"}, "belongs to --refine"},
        {{"render", scene, "-o", "a.png", "--show", "rays"}, "add --preview 0.1"},
        {{"render", scene, "--pixel", "1,1", "--show", "rays", "--preview", "0.1"}, "leave --pixel out"},
        {{"render", scene, "-o", "a.png", "--primary", "rater"}, "did you mean 'raster'"},
        {{"render", scene, "-o", "a.png", "--primary", "raster", "--accel", "bvh"}, "leave --accel out"},
        {{"render", scene, "-o", "a.png", "--primary", "raster", "--device", "gpu"}, "leave one of them out"},
        {{"bench", "--primary", "--accel"}, "measurements of their own"},
        {{"bench", "--accel", "--scene", "treee"}, "did you mean 'tree'"},
        {{"bench", "--sampling", "--accel"}, "measurements of their own"},
        {{"bench", "--sampling", "--scene", "tree"}, "--scene"},
        {{"bench", "--accel", "--device", "gpu"}, "for the CPU"},
        {{"bench", "--scene", "tree"}, "--accel"},
        {{"render", scene, "-o", "a.png", "--aov", "depth"}, ".exr"},
        {{"render", scene, "-o", "a.png", "--tone-map", "reinhart"}, "did you mean 'reinhard'"},
        {{"render", scene, "-o", "a.png", "--white-point", "2"}, "add --tone-map reinhard"},
        {{"render", scene, "-o", "a.exr", "--tone-map", "agx"}, "hold radiance"},
        {{"render", scene, "-o", "a.hdr", "--white-balance", "4000"}, "hold radiance"},
        {{"render", scene, "-o", "a.png", "--environment", "a.exr", "--sky"}, "leave one of them out"},
        {{"render", scene, "-o", "a.png", "--environment-turn", "90"}, "--environment studio.exr"},
        {{"render", "-o", "a.png", "--sky", scene}, "the scene goes before --sky"},
        {{"render", scene, "-o", "a.png", "--denoise"}, "--spp 16"},
        {{"render", scene, "-o", "a.png", "--denoiser", "filter"}, "--spp 16"},
        {{"render", scene, "-o", "a.png", "--denoiser", "oidm", "--spp", "16"}, "did you mean 'oidn'"},
        {{"render", scene, "-o", "a.png", "--denoise", "--spp", "3"}, "needs 4 samples"},
        {{"render", scene, "-o", "a.png", "--denoise", "--adaptive", "0.3"}, "leave --preview and --adaptive out"},
        {{"render", scene, "-o", "a.png", "--denoise", "--spp", "9", "--sampler", "regular"}, "leave --sampler out"},
        {{"render", scene, "-o", "a.png", "--integrator", "paths"}, "did you mean 'path'"},
        {{"render", scene, "-o", "a.png", "--shutter", "1"}, "--spp 64"},
        {{"render", scene, "-o", "a.png", "--seed", "3"}, "add --integrator path"},
        {{"render", scene, "-o", "a.png", "--occlusion-distance", "3"}, "add --integrator occlusion"},
        {{"render", scene, "-o", "a.png", "--photons", "9", "--integrator", "path"}, "find caustics themselves"},
        {{"render", scene, "-o", "a.png", "--radiosity", "9", "--integrator", "path"}, "leave --radiosity or"},
        {{"render", scene, "-o", "a.png", "--photons", "9", "--integrator", "occlusion"}, "leave one of them out"},
        {{"render", scene, "-o", "a.png", "--photons", "9", "--device", "gpu"}, "drawn by the CPU only"},
        {{"render", scene, "-o", "a.png", "--radiosity", "9", "--device", "gpu"}, "drawn by the CPU only"},
        {{"view", scene, "--photons", "9", "--device", "gpu"}, "drawn by the CPU only"},
        {{"render", scene, "-o", "a.png", "--radiosity-bounces", "3"}, "add --radiosity 200"},
        {{"render", scene, "-o", "a.png", "--radiosity-error", "1", "--radiosity", "0"}, "add --radiosity 200"},
        {{"render", scene, "-o", "a.png", "--aperture", "0.1"}, "--focus DISTANCE or --focus-pixel X,Y"},
        {{"render", scene, "-o", "a.png", "--blades", "5"}, "add --aperture RADIUS"},
        {{"render", scene, "-o", "a.png", "--aperture", "1", "--focus-pixel", "700,0"}, "outside the picture of"},
        {{"render", scene, "-o", "a.png", "--lens-blur", "disc"}, "add --aperture RADIUS and --focus DISTANCE"},
        {{"render", scene, "-o", "a.png", "--lens-blur", "disc", "--aperture", "1", "--focus", "8", "--blades", "5"},
         "leave --lens-blur or --blades out"},
        {{"render", scene, "-o", "a.png", "--lens-blur", "disc", "--aperture", "1", "--focus", "8", "--shutter", "1",
          "--spp", "8"},
         "add --shutter-blur velocity"},
        {{"render", scene, "-o", "a.png", "--shutter-blur", "velocity"}, "add --shutter SECONDS"},
        {{"render", scene, "--pixel", "3,4", "--shutter", "1", "--shutter-blur", "velocity"}, "leave --pixel"},
        {{"render", scene, "-o", "a.png", "--show", "cost", "--accel", "bvh", "--lens-blur", "disc", "--aperture", "1",
          "--focus", "8"},
         "leave --pixel and --show out"},
        {{"render", scene, "-o", "a.png", "--lens-blur", "dics"}, "did you mean 'disc'"},
        {{"render", scene, "-o", "a.png", "--camera", "fornt"}, "did you mean 'front'"},
        {{"render", scene, "-o", "a.png", "--camera", "1,2,3"}, "twelve numbers"},
        {{"render", scene, "-o", "a.mp4", "--turntable", "9", "--frames", "0..2"}, "frames of its own"},
        {{"render", scene, "-o", "a.exr", "--aov", "dept"}, "did you mean 'depth'"},
        {{"render", scene, "-o", "a.pngg"}, ".png"},
        {{"render", scene, "--pixel", "700,0"}, "outside the picture of"},
        {{"help", "rendre"}, "did you mean 'render'"},
        {{"compare", "a.png"}, "two pictures are needed"},
        {{"bake", scene}, "nothing says where the scene goes"},
        {{"bake", scene, "-o", "walk.obj"}, "doesn't end in .glb"},
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

// Catches options of sampling and acceleration that take what lies outside of their range, or refuse it without saying
// what the range is.
TEST(Usage, OptionsOutOfRangeSayTheRange) {
    struct Option {
        std::string name;
        std::vector<std::string> bad;
        std::string range;
    };
    const std::string structures = "embree, bvh, kdtree, octree, grid, boxes or none";
    const Option size{"--size", {"0x480", "640x65536", "640", "x"}, "whole numbers from 1 to 65535"};
    const Option threads{"--threads", {"-1", "1025", "2.5", "many"}, "a whole number from 0 to 1024"};
    const Option accel{"--accel", {"xyz", "-1"}, structures};
    const Option max_depth{"--max-depth", {"-1", "10001", "x"}, "a whole number from 0 to 10000"};
    const Option min_weight{"--min-weight", {"-0.1", "1.1", "nan"}, "a number from 0 to 1"};
    struct Command {
        std::vector<std::string> call;
        std::vector<Option> options;
    };
    const std::string scene = table_scene();
    const std::vector<Command> commands{
        {{"render", scene, "-o", "a.png"},
         {size,
          threads,
          accel,
          max_depth,
          min_weight,
          {"--device", {"xyz"}, "auto, cpu or gpu"},
          {"--spp", {"0", "65537", "-1", "1.5", "99999999999"}, "a whole number from 1 to 65536"},
          {"--preview", {"-0.01", "1.01", "nan", "inf", "x"}, "a number from 0 to 1"},
          {"--preview-method", {"xyz"}, "grid, scanline or scanline-assumed"},
          {"--show", {"xyz"}, "cost or rays"},
          {"--shadows", {"maybe"}, "on or off"},
          {"--time", {"1e7", "nan"}, "a number from -1000000 to 1000000"},
          {"--frames", {"3..1", "0..1000000"}, "0 <= A <= B < 1000000"},
          {"--fps", {"0", "1001"}, "a number from 0.01 to 1000"},
          {"--exposure", {"101", "-101"}, "a number from -100 to 100"},
          {"--integrator", {"xyz"}, "whitted, path or occlusion"},
          {"--shutter", {"-1", "nan"}, "a number from 0 to 1000000"},
          {"--lens-blur", {"xyz"}, "traced, gaussian or disc"},
          {"--shutter-blur", {"xyz"}, "traced or velocity"},
          {"--seed", {"-1", "1.5", "1000000001"}, "a whole number from 0 to 1000000000"},
          {"--clamp", {"0", "nan"}, "a number from 0.0001 to 1000000"},
          {"--occlusion-distance", {"0", "inf"}, "a number from 0.0001 to 1000000"},
          {"--photons", {"-1", "1e5", "100000001"}, "a whole number from 0 to 100000000"},
          {"--radiosity", {"-1", "2.5", "1000001"}, "a whole number from 0 to 1000000"},
          {"--radiosity-bounces", {"0", "21", "x"}, "a whole number from 1 to 20"},
          {"--radiosity-error", {"0", "11", "nan"}, "a number from 0.01 to 10"},
          {"--aperture", {"0", "-1"}, "a number from 0.0001 to 1000000"},
          {"--focus", {"0", "far"}, "a number from 0.0001 to 1000000"},
          {"--focus-pixel", {"1", "-1,2"}, "counted from 0"},
          {"--blades", {"2", "65"}, "a whole number from 3 to 64"},
          {"--tone-map", {"xyz"}, "linear, reinhard, aces, agx or gamma"},
          {"--white-point", {"0", "-1", "nan"}, "a number from 0.1 to 1000000"},
          {"--white-balance", {"1000", "30000", "warm"}, "a number from 1667 to 25000"},
          {"--sky", {"91", "noon", "30,0,20"}, "a number from"},
          {"--environment-turn", {"361", "x"}, "a number from -360 to 360"},
          {"--environment-gain", {"-1", "x"}, "a number from 0 to"},
          {"--turntable", {"0", "-3", "x"}, "a whole number from 1 to 100000"},
          {"--aov", {"xyz"}, "depth, normal, albedo, object, samples, cost or all"},
          {"--pixel", {"-1,0", "1"}, "counted from 0"}}},
        {{"view", scene},
         {size,
          threads,
          accel,
          max_depth,
          min_weight,
          {"--device", {"xyz"}, "auto, cpu or gpu"},
          {"--photons", {"-1", "many"}, "a whole number from 0 to 100000000"}}},
        {{"bake", scene, "-o", "a.glb"},
         {threads,
          {"--method", {"xyz"}, "paths or radiosity"},
          {"--patch", {"0", "-1", "nan"}, "a number from"},
          {"--spp", {"0", "1.5"}, "a whole number from 1 to 1000000"},
          {"--max-depth", {"-1"}, "a whole number from 0 to 10000"},
          {"--seed", {"-1"}, "a whole number from 0 to 1000000000"}}},
        {{"bench"},
         {threads,
          {"--device", {"xyz", "auto"}, "cpu or gpu"},
          {"--rounds", {"0", "1001"}, "a whole number from 1 to 1000"},
          {"--refine", {"-0.1", "1.1"}, "a number from 0 to 1"},
          {"--preview-method", {"xyz"}, "grid, scanline or scanline-assumed"},
          {"--scene", {"xyz"}, "table, cornell"}}}};
    const TemporaryFolder folder;
    for (const Command& command : commands)
        for (const Option& option : command.options)
            for (const std::string& value : option.bad) {
                std::vector<std::string> call = command.call;
                call.push_back(option.name + "=" + value);
                SCOPED_TRACE(testing::PrintToString(call));
                const Outcome outcome = run(call, folder.path());
                EXPECT_EQ(outcome.status, 2) << outcome.err;
                EXPECT_NE(outcome.err.find(option.name), std::string::npos) << outcome.err;
                EXPECT_NE(outcome.err.find(option.range), std::string::npos) << outcome.err;
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
