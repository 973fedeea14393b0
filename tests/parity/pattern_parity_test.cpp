// SPDX-License-Identifier: Apache-2.0
// Patterns and warps that the CPU asks the host for and shaders compute for themselves. The scenes are beside this
// file, under scenes/.
#include <gtest/gtest.h>

#include <filesystem>

#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "test_devices.h"

namespace sundog::parity {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

class PatternParity : public testing::TestWithParam<std::string> {};

// Catches programs whose words the shader reads otherwise than they are written, operations that its variant leaves out
// although the scene has them, surfaces' normals and directions that patterns get in another space, and points that
// warps of normals leave where they are. What both compute is compared in fields_test, number by number.
TEST_P(PatternParity, CpuAndGpuDrawTheSame) {
    std::vector<std::string> messages;
    std::string why;
    const auto gpu = open_gpu(messages, why);
    if (!gpu) GTEST_SKIP() << "no GPU to compare with: " << why;
    const auto file = std::filesystem::path(SUNDOG_SOURCE_DIR) / "tests" / "parity" / "scenes" / (GetParam() + ".pov");
    const Prepared prepared =
        prepare({GetParam(), import::import_scene(file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); })},
                kWidth, kHeight);
    for (const std::string& refused : gpu->unsupported(*prepared.scene)) ADD_FAILURE() << refused;
    const auto cpu = make_cpu_device({});
    cpu->load(prepared.scene);
    gpu->load(prepared.scene);
    const Film wanted = render(*cpu, prepared.frame, 1);
    const Film found = render(*gpu, prepared.frame, 1);
    int different = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) different += difference(wanted.mean(x, y), found.mean(x, y)) > 2 ? 1 : 0;
    EXPECT_LE(different, kWidth * kHeight / 500);
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

INSTANTIATE_TEST_SUITE_P(Scenes, PatternParity, testing::Values("patterns_warped", "patterns_figures"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace sundog::parity
