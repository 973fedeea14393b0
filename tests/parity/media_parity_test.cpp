// SPDX-License-Identifier: Apache-2.0
// Participating media, CPU against GPU. The scenes are beside this file, under scenes/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "test_devices.h"

namespace sundog::parity {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

scene::Scene media_scene(const std::string& name) {
    const auto file = std::filesystem::path(SUNDOG_SOURCE_DIR) / "tests" / "parity" / "scenes" / (name + ".pov");
    return import::import_scene(file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); });
}

/// Both devices' pictures of a scene.
struct Pictures {
    Film cpu{{0, 0, kWidth, kHeight}, 0}, gpu{{0, 0, kWidth, kHeight}, 0};

    /// Pixels that differ by more than 2/255.
    [[nodiscard]] int different() const {
        int count = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) count += difference(cpu.mean(x, y), gpu.mean(x, y)) > 2 ? 1 : 0;
        return count;
    }
};

float mean_of(const Film& film) {
    Vec3 sum{0, 0, 0};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) sum = sum + film.mean(x, y) * (1.0F / (kWidth * kHeight));
    return sum.x + sum.y + sum.z;
}

class MediaParity : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        std::string why;
        gpu_ = open_gpu(messages_, why);
        if (!gpu_) GTEST_SKIP() << "no GPU to compare with: " << why;
    }
    void TearDown() override {
        for (const std::string& message : messages_) ADD_FAILURE() << message;
    }

    Pictures draw(std::uint32_t integrator, std::uint32_t samples) {
        const scene::Scene scene = media_scene(GetParam());
        const auto compiled = compile(scene, {});
        FrameOptions options;
        options.width = kWidth;
        options.height = kHeight;
        options.integrator = integrator;
        options.max_depth = 6;
        const Frame frame = make_frame(scene, *compiled, options);
        for (const std::string& refused : gpu_->unsupported(*compiled)) ADD_FAILURE() << refused;
        const auto cpu = make_cpu_device({});
        cpu->load(compiled);
        gpu_->load(compiled);
        return {render(*cpu, frame, samples), render(*gpu_, frame, samples)};
    }

    std::vector<std::string> messages_;
    std::unique_ptr<Device> gpu_;
};

// Catches whatever the GPU computes otherwise than the CPU of media along rays of Whitted's integrator: which of them a
// ray is in, places of samples, densities, what is scattered, shadows in them and the light that they dim. All but one
// pixel in a hundred may be off by rounding alone; where a step is halved on one device but not on the other, more.
TEST_P(MediaParity, WhittedPicturesAreTheSame) {
    EXPECT_LE(draw(kernel::INTEGRATOR_WHITTED, 1).different(), kWidth * kHeight / 100);
}

// Catches paths that are tracked by other numbers or bounds on the GPU, particles that scatter otherwise, and light
// that one device counts twice. Paths draw the same numbers, but for light on its way through media with a pattern:
// there numbers are a hash of the ray's bits. So some pixels differ by noise, and the mean tells.
TEST_P(MediaParity, PathsBringTheSameLight) {
    const Pictures pictures = draw(kernel::INTEGRATOR_PATH, 4);
    const float mean = mean_of(pictures.cpu);
    EXPECT_GT(mean, 0);
    EXPECT_NEAR(mean_of(pictures.gpu), mean, 0.01F * mean);
    EXPECT_LE(pictures.different(), kWidth * kHeight / 10);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MediaParity, testing::Values("media_containers", "media_everywhere"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace sundog::parity
