// SPDX-License-Identifier: Apache-2.0
// Where pictures go, and that what was there is never lost.
#include <gtest/gtest.h>

#include "program.h"

namespace sundog::tests {
namespace {

std::vector<std::string> small_render(const std::string& scene, const std::filesystem::path& output) {
    return {"render", scene, "-o", output.string(), "--size", "64x48", "--device", "cpu"};
}

std::vector<std::string> with(std::vector<std::string> arguments, std::initializer_list<std::string> more) {
    arguments.insert(arguments.end(), more);
    return arguments;
}

// Catches a place that can't be written to being found out only after the render, or with another status than 3.
TEST(Output, PlacesThatCanNotBeWrittenEndWith3BeforeTheRender) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "taken.png");
    for (const std::filesystem::path& output : {folder / "no-such-folder/a.png", folder / "taken.png"}) {
        // So many samples would take hours.
        const Outcome outcome = run(with(small_render(table_scene(), output), {"--spp", "65536"}));
        EXPECT_EQ(outcome.status, 3) << output << outcome.err;
        EXPECT_NE(outcome.err.find(output.filename().string()), std::string::npos) << outcome.err;
    }
}

// Catches an output file that is truncated or removed when the scene turns out to be bad.
TEST(Output, AnExistingFileSurvivesABadScene) {
    const TemporaryFolder folder;
    write_bytes(folder / "precious.png", "kept");
    write_bytes(folder / "bad.scene", "focsu = 12\n");
    const Outcome outcome = run(small_render((folder / "bad.scene").string(), folder / "precious.png"));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("bad.scene:1:1: error: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("did you mean 'focus'"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_bytes(folder / "precious.png"), "kept");
}

// Catches pictures that depend on the number of threads.
TEST(Output, SameBitsForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    for (const std::string threads : {"1", "2", "5"}) {
        const Outcome outcome =
            run(with(small_render(table_scene(), folder / (threads + ".exr")), {"--threads", threads, "--spp", "3"}));
        ASSERT_EQ(outcome.status, 0) << outcome.err;
    }
    const std::string one = read_bytes(folder / "1.exr");
    EXPECT_GT(one.size(), 1000U);
    EXPECT_TRUE(one == read_bytes(folder / "2.exr"));
    EXPECT_TRUE(one == read_bytes(folder / "5.exr"));
}

// Catches an overlay that isn't there, covers what is interpolated, or depends on threads; and frames without it.
TEST(Output, ShowsWhereRaysWent) {
    const TemporaryFolder folder;
    const std::vector<std::string> preview = {"render",   table_scene(), "--size",    "160x120",
                                              "--device", "cpu",         "--preview", "0.1"};
    const auto render_to = [&](const std::string& name, std::initializer_list<std::string> more) {
        const Outcome outcome = run(with(with(preview, {"-o", (folder / name).string()}), more));
        ASSERT_EQ(outcome.status, 0) << outcome.err;
    };
    render_to("plain.ppm", {});
    render_to("rays.ppm", {"--show", "rays"});
    render_to("one.ppm", {"--show", "rays", "--threads", "1"});
    render_to("frames.ppm", {"--show", "rays", "--frames", "0..1"});
    const std::string plain = read_bytes(folder / "plain.ppm"), rays = read_bytes(folder / "rays.ppm");
    EXPECT_TRUE(rays == read_bytes(folder / "one.ppm"));
    EXPECT_TRUE(rays == read_bytes(folder / "frames-0000.ppm"));
    ASSERT_EQ(plain.size(), rays.size());
    constexpr std::size_t kBytes = std::size_t{3} * 160 * 120;
    ASSERT_GT(plain.size(), kBytes);
    std::size_t painted = 0;
    for (std::size_t i = plain.size() - kBytes; i < plain.size(); i += 3) {
        const std::string_view was = std::string_view(plain).substr(i, 3), is = std::string_view(rays).substr(i, 3);
        if (is == was) continue;
        EXPECT_EQ(is, "\xff\xff\xff");
        ++painted;
    }
    EXPECT_GT(painted, 160U * 120 / 64);
    EXPECT_LT(painted, 160U * 120 / 2);
}

// Catches heat maps of steps that depend on threads, on which pixels share a packet, or on nothing at all.
TEST(Output, CostPicturesAreTheSameForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    for (const std::string threads : {"1", "3"}) {
        const Outcome outcome =
            run(with({"render", table_scene(), "-o", (folder / (threads + ".ppm")).string()},
                     {"--size", "40x30", "--accel", "grid", "--show", "cost", "--threads", threads}));
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("acceleration grid; steps a pixel: "), std::string::npos) << outcome.err;
    }
    const std::string one = read_bytes(folder / "1.ppm");
    EXPECT_TRUE(one == read_bytes(folder / "3.ppm"));
    ASSERT_EQ(run(with({"render", table_scene(), "-o", (folder / "none.ppm").string()},
                       {"--size", "40x30", "--accel", "none", "--show", "cost"}))
                  .status,
              0);
    EXPECT_FALSE(one == read_bytes(folder / "none.ppm"));
}

// Catches news mixed into a picture on standard output.
TEST(Output, StandardOutputIsThePictureAlone) {
    const Outcome outcome = run(with(small_render(table_scene(), "-"), {"--format", "ppm"}));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("P6")) << outcome.out.substr(0, 40);
    EXPECT_EQ(outcome.out.size(), std::string("P6\n64 48\n255\n").size() + 64UL * 48 * 3);
    const Outcome quiet = run(with(small_render(table_scene(), "-"), {"--quiet"}));
    EXPECT_TRUE(quiet.out.starts_with("\x89PNG"));
    EXPECT_EQ(quiet.err, "");
}

// Catches frames that are all of the same moment, numbered otherwise than asked for, or announced under another name.
TEST(Output, NumberedFrames) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run(with(small_render(table_scene(), folder / "turn-%03d.ppm"), {"--frames", "9..10", "--fps", "1"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::string names = (folder / "turn-009.ppm").string() + " ... " + (folder / "turn-010.ppm").string() + " (";
    EXPECT_NE(outcome.err.find("wrote 2 frames to " + names), std::string::npos) << outcome.err;
    const std::string first = read_bytes(folder / "turn-009.ppm");
    const std::string second = read_bytes(folder / "turn-010.ppm");
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(first.size(), second.size());
    EXPECT_TRUE(first != second) << "the table's camera goes round";
    // Frame 9 at one frame a second is the moment 9 s.
    ASSERT_EQ(run(with(small_render(table_scene(), folder / "moment.ppm"), {"--time", "9"})).status, 0);
    EXPECT_TRUE(read_bytes(folder / "moment.ppm") == first);
}

// Catches a turntable whose frames are all the same, or whose first isn't the view that was asked for.
TEST(Output, TurntablesGoRoundTheScene) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run(with(small_render(table_scene(), folder / "turn.ppm"), {"--camera", "iso", "--turntable", "3"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::string first = read_bytes(folder / "turn-0000.ppm"), second = read_bytes(folder / "turn-0001.ppm");
    EXPECT_FALSE(std::filesystem::exists(folder / "turn-0003.ppm"));
    EXPECT_TRUE(first != second);
    EXPECT_TRUE(second != read_bytes(folder / "turn-0002.ppm"));
    ASSERT_EQ(run(with(small_render(table_scene(), folder / "iso.ppm"), {"--camera", "iso"})).status, 0);
    EXPECT_TRUE(read_bytes(folder / "iso.ppm") == first);
}

// Catches options that change nothing.
TEST(Output, OptionsReachThePicture) {
    const TemporaryFolder folder;
    const auto picture = [&](std::initializer_list<std::string> options) {
        const Outcome outcome = run(with(small_render(table_scene(), folder / "a.ppm"), options));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return read_bytes(folder / "a.ppm");
    };
    const std::string plain = picture({});
    EXPECT_TRUE(plain == picture({}));
    EXPECT_TRUE(plain != picture({"--no-shadows"}));
    EXPECT_TRUE(picture({"--shadows", "off"}) == picture({"--no-shadows"}));
    EXPECT_TRUE(plain != picture({"--max-depth", "0"}));
    EXPECT_TRUE(plain != picture({"--exposure", "1"}));
    const std::string paths = picture({"--integrator", "path"});
    EXPECT_TRUE(plain != paths);
    EXPECT_TRUE(paths != picture({"--integrator", "path", "--seed", "1"}));
    EXPECT_TRUE(paths != picture({"--integrator", "path", "--clamp", "0.2"}));
    EXPECT_TRUE(paths == picture({"--integrator", "path", "--threads", "1"}));
    const std::string occlusion = picture({"--integrator", "occlusion"});
    EXPECT_TRUE(occlusion != picture({"--integrator", "occlusion", "--occlusion-distance", "0.2"}));
    EXPECT_TRUE(picture({"--spp", "4"}) != picture({"--spp", "4", "--shutter", "2"}));
    EXPECT_TRUE(picture({"--spp", "4"}) == picture({"--spp", "4", "--shutter", "0"}));
    const std::string blurred = picture({"--aperture", "0.3", "--focus", "8"});
    EXPECT_TRUE(plain != blurred);
    EXPECT_TRUE(blurred != picture({"--aperture", "0.3", "--focus", "3"}));
    EXPECT_TRUE(blurred != picture({"--aperture", "0.3", "--focus", "8", "--blades", "5"}));
    EXPECT_TRUE(blurred != picture({"--aperture", "0.3", "--focus-pixel", "32,40"}));
    EXPECT_TRUE(plain == picture({"--tone-map", "linear"}));
    EXPECT_TRUE(plain == picture({"--white-balance", "6504"}));
    const std::string mapped = picture({"--tone-map", "agx"});
    EXPECT_TRUE(plain != mapped);
    EXPECT_TRUE(mapped != picture({"--tone-map", "aces"}));
    EXPECT_TRUE(mapped != picture({"--tone-map", "agx", "--white-balance", "4000"}));
    EXPECT_TRUE(plain != picture({"--spp", "4"}));
    EXPECT_TRUE(plain != picture({"--time", "3"}));
    EXPECT_TRUE(picture({"--spp", "4", "--denoise"}) != picture({"--spp", "4"}));
    const std::string filtered = picture({"--spp", "4", "--denoiser", "filter"});
    EXPECT_TRUE(filtered == picture({"--spp", "4", "--denoise", "--denoiser", "filter", "--threads", "1"}));
}

// Catches --pixel naming another object than the one that the picture shows there.
TEST(Output, PixelNamesWhatItSees) {
    const Outcome outcome =
        run({"render", table_scene(), "--size", "64x48", "--pixel", "32,40", "--device", "cpu", "--shadows", "on"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("object    "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("table.obj:"), std::string::npos) << outcome.out;
}

// Catches a comparison that finds differences between equal pictures, or none between different ones.
TEST(Output, CompareTellsEqualFromDifferent) {
    const TemporaryFolder folder;
    ASSERT_EQ(run(small_render(table_scene(), folder / "a.png")).status, 0);
    ASSERT_EQ(run(with(small_render(table_scene(), folder / "b.png"), {"--no-shadows"})).status, 0);
    const Outcome same = run({"compare", "a.png", "a.png"}, folder.path());
    EXPECT_EQ(same.status, 0) << same.err;
    EXPECT_NE(same.out.find("RMSE                0.000000"), std::string::npos) << same.out;
    const Outcome other = run({"compare", "a.png", "b.png", "-o", "difference.png"}, folder.path());
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_EQ(other.out.find("RMSE                0.000000"), std::string::npos) << other.out;
    EXPECT_TRUE(read_bytes(folder / "difference.png").starts_with("\x89PNG"));
}

}  // namespace
}  // namespace sundog::tests
