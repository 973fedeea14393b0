// SPDX-License-Identifier: Apache-2.0
// A short run of what the fuzzer does, the same each time.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mutate.h"
#include "pov_target.h"

namespace sundog::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> texts_below(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const fs::path& file : files) {
        std::ifstream in(file, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return texts;
}

// Catches seeds that no longer are scenes, so that the fuzzer would start from rubble.
TEST(PovFuzz, SeedsAreScenes) {
    const std::vector<std::string> seeds = texts_below(SUNDOG_SOURCE_DIR "/tests/fuzz/seeds");
    ASSERT_GE(seeds.size(), 10U);
    for (const std::string& seed : seeds) EXPECT_EQ(refusal_of_pov_scene(seed), std::nullopt);
}

// Catches crashes, endless loops, bottomless recursions and foreign exceptions on damaged scenes (most useful under the
// sanitizers).
TEST(PovFuzz, DamagedScenesAreReadOrRefused) {
    constexpr std::uint64_t kRuns = 3000;
    const std::vector<std::string> seeds = texts_below(SUNDOG_SOURCE_DIR "/tests/fuzz/seeds");
    std::uint64_t read = 0;
    for (std::uint64_t run = 0; run < kRuns; ++run) {
        const std::string text = mutated(seeds[run % seeds.size()], seeds, run);
        SCOPED_TRACE(testing::Message() << "seed " << run);
        ASSERT_NO_THROW(read += refusal_of_pov_scene(text) ? 0 : 1) << text;
    }
    EXPECT_GT(read, kRuns / 100) << "damage that leaves nothing to read tests nothing but the first error";
    EXPECT_LT(read, kRuns * 99 / 100);
}

// Catches inputs that once were findings of the fuzzer.
TEST(PovFuzz, FormerFindingsStayFixed) {
    const fs::path folder = SUNDOG_SOURCE_DIR "/tests/fuzz/findings";
    if (!fs::exists(folder)) GTEST_SKIP() << "none";
    for (const std::string& text : texts_below(folder)) EXPECT_NO_THROW((void)refusal_of_pov_scene(text)) << text;
}

}  // namespace
}  // namespace sundog::fuzz
