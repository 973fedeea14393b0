// SPDX-License-Identifier: Apache-2.0
// Exact solids, CPU against GPU, and those that the GPU refuses. The scenes are beside this file, under scenes/.
#include <gtest/gtest.h>

#include <filesystem>

#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "test_devices.h"

namespace sundog::parity {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

TestScene solid_scene(const std::string& name) {
    const auto file = std::filesystem::path(SUNDOG_SOURCE_DIR) / "tests" / "parity" / "scenes" / (name + ".pov");
    return {name, import::import_scene(file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); })};
}

class SolidParity : public testing::TestWithParam<std::string> {};

// Catches whatever the GPU finds otherwise than the CPU on a shape or in a group of shapes: crossings, normals,
// materials, insides, coincident faces, texture coordinates, and shadows of all that. Both compute in double precision:
// all but a few pixels on edges are equal in depth, normal and material.
TEST_P(SolidParity, CpuAndGpuDrawTheSamePicture) {
    std::vector<std::string> messages;
    std::string why;
    const auto gpu = open_gpu(messages, why);
    if (!gpu) GTEST_SKIP() << "no GPU to compare with: " << why;
    const Prepared prepared = prepare(solid_scene(GetParam()), kWidth, kHeight);
    if (const auto refused = gpu->unsupported(*prepared.scene); !refused.empty()) GTEST_FAIL() << refused.front();
    const auto cpu = make_cpu_device({});
    gpu->load(prepared.scene);
    cpu->load(prepared.scene);
    constexpr std::uint32_t aovs = kernel::AOV_DEPTH | kernel::AOV_NORMAL | kernel::AOV_OBJECT;
    const Film wanted = render(*cpu, prepared.frame, 1, aovs);
    const Film found = render(*gpu, prepared.frame, 1, aovs);
    int different = 0;
    int misplaced = 0;
    for (std::size_t i = 0; i < wanted.radiance.size(); ++i) {
        float most = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            most = std::max(most, std::abs(wanted.radiance[i][channel] - found.radiance[i][channel]));
        if (most > 0.004F) ++different;
        const bool same = wanted.object[i] == found.object[i] && wanted.material[i] == found.material[i];
        if (!same || (wanted.object[i] != kernel::NONE &&
                      (std::abs(wanted.depth[i] - found.depth[i]) > 1e-4F * wanted.depth[i] ||
                       dot(wanted.normal[i], found.normal[i]) < 0.9999F)))
            ++misplaced;
    }
    EXPECT_LE(different, kWidth * kHeight / 500);
    EXPECT_LE(misplaced, kWidth * kHeight / 1000);
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SolidParity,
                         testing::Values("solid_shapes", "solid_csg", "solid_outlines", "solid_blobs",
                                         "solid_coincident"),
                         [](const auto& info) { return info.param; });

// Catches a shape that the GPU has no code for and draws as nothing, and a message without the object, its line or the
// shape.
TEST(SolidsOnTheGpu, AreRefusedByNameAndLine) {
    std::vector<std::string> messages;
    std::string why;
    const auto gpu = open_gpu(messages, why);
    if (!gpu) GTEST_SKIP() << "no GPU to ask: " << why;
    const auto reason_for = [&](const std::string& name) {
        const Prepared prepared = prepare(solid_scene(name), kWidth, kHeight);
        const std::vector<std::string> reasons = gpu->unsupported(*prepared.scene);
        return reasons.size() == 1 ? reasons[0] : std::to_string(reasons.size()) + " reasons";
    };
    const std::string fractal = reason_for("solid_refused");
    EXPECT_TRUE(
        fractal.ends_with("solid_refused.pov:6: object 'difference' is or has a Julia fractal, which only the "
                          "CPU draws; use --device cpu"))
        << fractal;
    const std::string letters = reason_for("solid_prisms_refused");
    EXPECT_TRUE(
        letters.ends_with("solid_prisms_refused.pov:7: object 'intersection' is or has an intersection of more "
                          "than 2 prisms or letters, which only the CPU draws; use --device cpu"))
        << letters;
}

}  // namespace
}  // namespace sundog::parity
