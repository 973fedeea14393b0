// SPDX-License-Identifier: Apache-2.0
// The 64 kB demo as a file, and its frames against pictures of them that were looked at and kept beside this file. One
// that changed on purpose is made again by
//     sundog-intro --window 320x180 --frame SECONDS frame.ppm
// and conversion to PNG.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "output/compare.h"
#include "output/image.h"
#include "program.h"

namespace sundog::tests {
namespace {

/// Skips where the processor can't run it, as the program itself says.
class Intro : public testing::Test {
protected:
    void SetUp() override {
        const Outcome help = run({"--frame", "0", "/dev/null", "--window", "16x16"});
        if (help.err.find("AVX2") != std::string::npos) GTEST_SKIP() << help.err;
    }
    output::Image frame(const std::string& seconds, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"--window", "320x180", "--frame", seconds, (folder_ / "frame.ppm").string()};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return output::read_image(folder_ / "frame.ppm");
    }

    TemporaryFolder folder_;
};

// Catches the demo growing out of its 64 kB.
TEST(IntroFile, IsNoLargerThan64K) {
    const std::uintmax_t bytes = std::filesystem::file_size(built_program());
    constexpr bool kCompilerIsMeasured = __GNUC__ == 12;  // clang says 4
    if (bytes > 65536 && !kCompilerIsMeasured)
        GTEST_SKIP() << "its size is kept with g++ 12; this compiler makes " << bytes << " bytes of it";
    EXPECT_LE(bytes, 65536U);
}

// Catches the C++ library, or any other, coming to be needed.
TEST(IntroFile, NeedsOnlyTheLibrariesItMay) {
    const Outcome outcome = run({"-d", built_program().string()}, ".", "/usr/bin/readelf");
    if (outcome.status != 0) GTEST_SKIP() << "needs readelf (package binutils)";
    const std::regex needed(R"(\(NEEDED\)[^\[]*\[([^\]]*)\])");
    std::set<std::string> found;
    for (std::sregex_iterator i(outcome.out.begin(), outcome.out.end(), needed), end; i != end; ++i)
        found.insert((*i)[1]);
    EXPECT_TRUE(found.contains("libSDL2-2.0.so.0")) << outcome.out;
    const std::set<std::string> allowed{"libSDL2-2.0.so.0", "libc.so.6", "libm.so.6", "libpthread.so.0",
                                        "ld-linux-x86-64.so.2"};
    for (const std::string& library : found) EXPECT_TRUE(allowed.contains(library)) << library;
}

// Catches whatever changes a scene: shapes, cuts, textures, lamps, shadows, mirrors, the camera's way, fades. The
// bounds leave room for another compiler's rounding at edges.
TEST_F(Intro, FramesAreAsTheyWere) {
    for (const char* seconds : {"13", "24", "40", "56", "72", "90"}) {
        const std::string name = "frame_" + std::string(seconds) + ".png";
        const output::Image wanted =
            output::read_image(std::filesystem::path(SUNDOG_SOURCE_DIR) / "tests" / "intro64k" / name);
        const output::Comparison distance = output::compare(frame(seconds), wanted);
        EXPECT_GE(distance.psnr_db, 36) << name;
        EXPECT_LE(distance.flip, 0.015) << name;
    }
}

// Catches refinement that misses what it should have traced. In full size, for which it is meant: of textures it takes
// the middle of each pixel, where tracing everything takes the mean of its corners.
TEST_F(Intro, RefinementShowsWhatTracingEverythingShows) {
    for (const char* seconds : {"13", "56"}) {
        const std::vector<std::string> full_size{"--window", "1280x720"};
        const output::Image refined = frame(seconds, full_size);
        const output::Comparison distance =
            output::compare(refined, frame(seconds, {"--window", "1280x720", "--no-refinement"}));
        EXPECT_GE(distance.psnr_db, 35) << seconds;
        EXPECT_GE(distance.ssim, 0.96) << seconds;
    }
}

// Catches pixels that depend on which thread draws them.
TEST_F(Intro, FramesDoNotDependOnThreads) {
    frame("56", {"--threads", "1"});
    const std::string one = read_bytes(folder_ / "frame.ppm");
    frame("56", {"--threads", "5"});
    EXPECT_EQ(one, read_bytes(folder_ / "frame.ppm"));
}

// Catches pictures whose sides aren't whole tiles or squares being drawn past their ends.
TEST_F(Intro, PicturesMayHaveAnySize) {
    for (const char* size : {"16x16", "65x63", "129x200"}) {
        const Outcome outcome = run({"--window", size, "--frame", "24", (folder_ / "odd.ppm").string()});
        EXPECT_EQ(outcome.status, 0) << size;
        const output::Image image = output::read_image(folder_ / "odd.ppm");
        EXPECT_EQ(std::to_string(image.width) + "x" + std::to_string(image.height), size);
    }
}

// Catches a benchmark that prints no numbers.
TEST_F(Intro, BenchmarkPrintsFramesAndRaysPerSecond) {
    const Outcome outcome = run({"--benchmark", "3", "--window", "64x64"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(std::regex_search(outcome.out, std::regex("frames per second: [0-9.]+ on average"))) << outcome.out;
    EXPECT_TRUE(std::regex_search(outcome.out, std::regex("rays per second: [0-9.]+ million"))) << outcome.out;
}

// Catches bad words that are taken for good ones, and messages that don't say what would be right.
TEST_F(Intro, WrongWordsAreRefusedWithTheValidRange) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--window", "1280"}, "16x16 to 8192x8192"},
        {{"--window", "8x8"}, "16x16 to 8192x8192"},
        {{"--window"}, "16x16 to 8192x8192"},
        {{"--frame", "101", "x.ppm"}, "0 to 100"},
        {{"--frame", "nan", "x.ppm"}, "0 to 100"},
        {{"--frame", "1"}, "0 to 100"},
        {{"--threads", "0"}, "1 to 64"},
        {{"--threads", "2.5"}, "1 to 64"},
        {{"--benchmark", "0"}, "1 to 1000000"},
        {{"--fast"}, "--help"},
    };
    for (const auto& [words, expected] : cases) {
        const Outcome outcome = run(words, folder_.path());
        EXPECT_EQ(outcome.status, 2) << words[0];
        EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    }
}

// Catches a frame that couldn't be written being passed over in silence.
TEST_F(Intro, SaysWhichFileCouldNotBeWritten) {
    const Outcome outcome = run({"--window", "16x16", "--frame", "1", "/no/such/folder/x.ppm"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.err.find("/no/such/folder/x.ppm"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace sundog::tests
