// SPDX-License-Identifier: Apache-2.0
// Sundog's pictures of small POV-Ray scenes, one a feature, against those of the `povray` program, where it is
// installed. The scenes are beside this file, under scenes/; under grain/ those whose randomness is Sundog's own.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "compile/compile.h"
#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "output/compare.h"
#include "output/image.h"
#include "session/session.h"

namespace sundog {
namespace {

namespace fs = std::filesystem;
constexpr int kWidth = 160, kHeight = 120;

/// Runs a program without output, found along PATH. Its exit status, or -1 if it could not be started.
int run_quietly(const std::vector<std::string>& arguments) {
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int descriptor : {0, 1, 2})
        posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_RDWR, 0);
    pid_t child = -1;
    const int failed = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) return -1;
    int status = 0;
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

/// povray's picture, one ray a pixel.
output::Image picture_of_povray(const fs::path& scene, const fs::path& picture) {
    run_quietly({"povray", "+I" + scene.string(), "+L" + scene.parent_path().string(), "+O" + picture.string(), "+FN8",
                 "-D", "-A", "-GA", "+W" + std::to_string(kWidth), "+H" + std::to_string(kHeight)});
    return output::read_image(picture);
}

output::Image picture_of_sundog(const fs::path& file) {
    const scene::Scene scene = import::import_scene(file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); });
    const auto compiled = compile(scene, {});
    FrameOptions options;
    options.width = kWidth;
    options.height = kHeight;
    Session session(make_cpu_device({.threads = 2, .lanes = 0}));
    session.load(compiled);
    const RenderResult result = session.render(make_frame(scene, *compiled, options), 1, {}, StopFlag());
    output::Image image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) image.at(x, y) = result.film.mean(x, y);
    return image;
}

fs::path scenes_folder(const char* name = "scenes") {
    return fs::path(SUNDOG_SOURCE_DIR) / "tests" / "conformance" / name;
}

std::vector<std::string> scene_names(const char* folder = "scenes") {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(scenes_folder(folder)))
        if (entry.path().extension() == ".pov") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Scenes whose pictures are known to differ, and why. They are drawn and compared all the same: one that agrees must
/// leave the list.
const std::map<std::string, const char*>& known_differences() {
    static const std::map<std::string, const char*> differences;
    return differences;
}

class PovConformance : public testing::TestWithParam<std::string> {};

// Catches whatever makes a feature look other than in POV-Ray. Measured on 8-bit sRGB values: at most 2% of the pixels
// may be more than 2 steps off (edges and checkers far away, where one ray decides), and the mean FLIP error of all
// pixels stays under 0.01, which can't be seen.
TEST_P(PovConformance, LooksAsInPovray) {
    const fs::path picture = fs::path(testing::TempDir()) / ("pov_conformance_" + GetParam() + ".png");
    if (run_quietly({"povray", "--version"}) == -1) GTEST_SKIP() << "povray isn't installed";
    const fs::path scene = scenes_folder() / (GetParam() + ".pov");
    const output::Image wanted = picture_of_povray(scene, picture);
    const output::Image found = picture_of_sundog(scene);
    const output::Comparison distance = output::compare(found, wanted);
    constexpr double kDifferentFraction = 0.02;
    constexpr double kFlip = 0.01;
    if (const auto known = known_differences().find(GetParam()); known != known_differences().end()) {
        fs::remove(picture);
        ASSERT_FALSE(distance.different_fraction <= kDifferentFraction && distance.flip <= kFlip)
            << "agrees with povray: take it off the list of known differences";
        GTEST_SKIP() << "known to differ: " << known->second;
    }
    EXPECT_LE(distance.different_fraction, kDifferentFraction);
    EXPECT_LE(distance.flip, kFlip);
    if (!HasFailure()) {
        fs::remove(picture);
        return;
    }
    const fs::path kept = fs::path(testing::TempDir()) / ("pov_conformance_" + GetParam() + "_sundog.png");
    output::write_image(kept, found);
    ADD_FAILURE() << "povray's picture is " << picture << ", ours " << kept;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, PovConformance, testing::ValuesIn(scene_names()), test_name);

/// What two pictures of the same sort of noise have in common, in steps of 8-bit sRGB values.
struct Grain {
    double mean = 0;
    double spread = 0;  ///< Standard deviation.
    double step = 0;    ///< Mean difference of neighbours in a row: how fine the grain is.
};

Grain grain_of(const output::Image& image) {
    // Of what povray's files hold, too.
    const auto stored = [&](int x, int y) {
        const Vec3 c = image.at(x, y);
        double sum = 0;
        for (const float linear : {c.x, c.y, c.z}) {
            const double v = std::clamp(static_cast<double>(linear), 0.0, 1.0);
            sum += v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
        }
        return sum * 255 / 3;
    };
    Grain grain;
    double squares = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double value = stored(x, y);
            grain.mean += value, squares += value * value;
            if (x > 0) grain.step += std::abs(value - stored(x - 1, y));
        }
    }
    constexpr double kPixels = kWidth * kHeight;
    grain.mean /= kPixels;
    grain.step /= kPixels - kHeight;
    grain.spread = std::sqrt(std::max(squares / kPixels - grain.mean * grain.mean, 0.0));
    return grain;
}

class PovGrain : public testing::TestWithParam<std::string> {};

// Catches noise that is weaker or stronger, brighter or darker, coarser or finer than in POV-Ray, or not there at all.
TEST_P(PovGrain, IsLikePovrays) {
    const fs::path picture = fs::path(testing::TempDir()) / ("pov_grain_" + GetParam() + ".png");
    if (run_quietly({"povray", "--version"}) == -1) GTEST_SKIP() << "povray isn't installed";
    const fs::path scene = scenes_folder("grain") / (GetParam() + ".pov");
    const Grain wanted = grain_of(picture_of_povray(scene, picture));
    const Grain found = grain_of(picture_of_sundog(scene));
    fs::remove(picture);
    // Ten places that waves come from don't make a mean: where they lie counts.
    const bool few = GetParam() == "normal_ripples" || GetParam() == "normal_waves";
    const double share = few ? 0.4 : 0.2;
    EXPECT_GT(wanted.spread, 2) << "no grain to compare";
    EXPECT_NEAR(found.mean, wanted.mean, 3);
    EXPECT_NEAR(found.spread, wanted.spread, share * wanted.spread);
    EXPECT_NEAR(found.step, wanted.step, share * wanted.step);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PovGrain, testing::ValuesIn(scene_names("grain")), test_name);

}  // namespace
}  // namespace sundog
