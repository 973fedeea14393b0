// SPDX-License-Identifier: Apache-2.0
// Paths, CPU against GPU. Both draw the same numbers, so a path goes the same way on both until rounding parts it, at
// an edge or where two choices are as good; then only means agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "scene/environment.h"
#include "test_devices.h"

namespace sundog::parity {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr std::uint32_t kSamples = 8;
constexpr double kDifferentPixels = 0.03;
constexpr double kDifferentMeans = 0.01;

struct PathScene {
    std::string name;
    scene::Scene scene;
    std::uint32_t integrator = kernel::INTEGRATOR_PATH;
    float lens_radius = 0;
};

/// A sky that is bright in one direction.
scene::Environment uneven_sky() {
    scene::Environment sky;
    sky.width = 16;
    sky.height = 8;
    for (int i = 0; i < 128; ++i) {
        const float v = i == 40 ? 60.0F : 0.2F + 0.02F * static_cast<float>(i % 16);
        sky.radiance.push_back({v, v * 0.9F, v * 0.7F});
    }
    return sky;
}

std::vector<PathScene> path_scenes() {
    std::vector<PathScene> all;
    for (TestScene& test : test_scenes())
        for (const char* const wanted : {"analytic shapes", "glass", "textures", "procedural", "moving objects"})
            if (test.name == wanted) all.push_back({test.name, std::move(test.scene)});
    const std::filesystem::path scenes = std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes";
    all.push_back({"cornell", import::import_scene(scenes / "cornell/cornell.scene", {})});
    all.push_back({"open corners", all.back().scene, kernel::INTEGRATOR_OCCLUSION});
    all.push_back({"behind a lens", all[all.size() - 2].scene, kernel::INTEGRATOR_PATH, 0.2F});
    scene::Scene spheres = import::import_scene(scenes / "gltf/spheres.gltf", {});
    scene::hang(uneven_sky(), 0, spheres);
    all.push_back({"principled spheres under a sky", std::move(spheres)});
    return all;
}

double mean_of(const Film& film) {
    double sum = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Vec3 c = film.mean(x, y);
            sum += c.x + c.y + c.z;
        }
    return sum;
}

/// Whether two colours look different: by more than a hundredth of what they are or of white.
bool differ(Vec3 a, Vec3 b) {
    const auto channel = [](float p, float q) { return std::abs(p - q) > 0.01F * std::max({p, q, 1.0F}); };
    return channel(a.x, b.x) || channel(a.y, b.y) || channel(a.z, b.z);
}

class PathParity : public testing::TestWithParam<PathScene> {};

// Catches an array that the GPU hasn't got, numbers that it draws otherwise, and light that one of both counts twice.
TEST_P(PathParity, CpuAndGpuTraceTheSamePaths) {
    std::vector<std::string> messages;
    std::string why;
    const auto gpu = open_gpu(messages, why);
    if (!gpu) GTEST_SKIP() << "no GPU to compare with: " << why;
    const auto cpu = make_cpu_device({});
    const PathScene& test = GetParam();
    const auto compiled = compile(test.scene, {});
    FrameOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.integrator = test.integrator;
    options.max_depth = 6;
    options.lens_radius = test.lens_radius;
    options.focus_distance = 8;
    const Frame frame = make_frame(test.scene, *compiled, options);
    gpu->load(compiled);
    cpu->load(compiled);
    const Film a = render(*cpu, frame, kSamples, kernel::AOV_NORMAL | kernel::AOV_ALBEDO);
    const Film b = render(*gpu, frame, kSamples, kernel::AOV_NORMAL | kernel::AOV_ALBEDO);
    int different = 0, other_surfaces = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            different += differ(a.mean(x, y), b.mean(x, y)) ? 1 : 0;
            const std::size_t i = a.index(x, y);
            other_surfaces += differ(a.normal[i], b.normal[i]) || differ(a.albedo[i], b.albedo[i]) ? 1 : 0;
        }
    const double mean = mean_of(a);
    EXPECT_GT(mean, 0);
    EXPECT_NEAR(mean_of(b), mean, kDifferentMeans * mean);
    EXPECT_LE(different, kDifferentPixels * kWidth * kHeight);
    EXPECT_LE(other_surfaces, 0.003 * kWidth * kHeight);
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

INSTANTIATE_TEST_SUITE_P(Scenes, PathParity, testing::ValuesIn(path_scenes()),
                         [](const testing::TestParamInfo<PathScene>& info) {
                             std::string name = info.param.name;
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

}  // namespace

/// How GoogleTest shows the parameter.
void PrintTo(const PathScene& test, std::ostream* stream) { *stream << test.name; }

}  // namespace sundog::parity
