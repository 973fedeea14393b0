// SPDX-License-Identifier: Apache-2.0
// Participating media, CPU against GPU. The scenes are beside this file, under scenes/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/diagnostics.h"
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

class MediaParity : public testing::Test {
protected:
    void SetUp() override {
        std::string why;
        gpu_ = open_gpu(messages_, why);
        if (!gpu_) GTEST_SKIP() << "no GPU to compare with: " << why;
    }
    void TearDown() override {
        for (const std::string& message : messages_) ADD_FAILURE() << message;
    }

    Pictures draw(const scene::Scene& scene, std::uint32_t integrator, std::uint32_t samples) {
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
        Pictures pictures{render(*cpu, frame, samples), render(*gpu_, frame, samples)};
        EXPECT_GT(mean_of(pictures.cpu), 0.1F);
        return pictures;
    }

    std::vector<std::string> messages_;
    std::unique_ptr<Device> gpu_;
};

// Few tests, for a driver in software takes half a minute or more to compile the shader for each; and small scenes, for
// it lets no ray go through more than 65,535 rounds of loops.

// Catches whatever the GPU computes otherwise than the CPU of media in objects along rays of Whitted's integrator:
// which of them a ray is in, places of samples, densities, what is scattered by each phase function, shadows and the
// light that is dimmed there. All but one pixel in a hundred are the same but for rounding; where a step is halved on
// one device but not on the other, it may be more.
TEST_F(MediaParity, ObjectsHoldTheSame) {
    EXPECT_LE(draw(media_scene("media_containers"), kernel::INTEGRATOR_WHITTED, 1).different(), kWidth * kHeight / 100);
}

// The same of a medium that is everywhere, of stretches of rays that spots and cylinders light, and of exact shapes.
// Catches, too, an eye that isn't inside of anything, and solids that have the atmosphere in them.
TEST_F(MediaParity, TheAirIsTheSame) {
    scene::Scene scene = media_scene("media_everywhere");
    EXPECT_LE(draw(scene, kernel::INTEGRATOR_WHITTED, 1).different(), kWidth * kHeight / 100);
    // More than that driver does: catches a wrong picture without a word.
    scene.atmosphere.at(0).intervals = 30;
    try {
        EXPECT_LE(draw(scene, kernel::INTEGRATOR_WHITTED, 1).different(), kWidth * kHeight / 100);
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string(error.what()).find("ends a shader's loops early"), std::string::npos) << error.what();
    }
}

// Catches a density that the GPU has no code for and takes for 0, and a message without its place.
TEST_F(MediaParity, DensitiesThatOnlyTheHostComputesAreRefused) {
    const auto compiled = compile(media_scene("media_refused"), {});
    const std::vector<std::string> reasons = gpu_->unsupported(*compiled);
    ASSERT_EQ(reasons.size(), 1U);
    EXPECT_TRUE(
        reasons[0].ends_with("media_refused.pov:9: a pattern or a warp that only the CPU draws; use --device cpu"))
        << reasons[0];
}

// Catches paths that are tracked by other numbers or bounds on the GPU, particles that scatter otherwise, and light
// that one device counts twice. Paths draw the same numbers, but for light on its way through media with a pattern:
// there numbers are a hash of the ray's bits. So some pixels differ by noise, and the mean tells.
TEST_F(MediaParity, PathsBringTheSameLight) {
    scene::Scene scene = media_scene("media_containers");
    scene::Medium air;
    air.scattering = {0.02F, 0.02F, 0.03F};
    air.scattering_type = 5, air.eccentricity = 0.3F;
    scene.atmosphere.push_back(air);
    const Pictures pictures = draw(scene, kernel::INTEGRATOR_PATH, 4);
    const float mean = mean_of(pictures.cpu);
    EXPECT_NEAR(mean_of(pictures.gpu), mean, 0.01F * mean);
    EXPECT_LE(pictures.different(), kWidth * kHeight / 10);
}

}  // namespace
}  // namespace sundog::parity
