// SPDX-License-Identifier: Apache-2.0
// Whole pictures, CPU against GPU: at most one pixel in a thousand may differ by more than 2/255 in sRGB, and only
// where the CPU's picture has an edge, on which rounding decides which side a pixel's ray falls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "base/diagnostics.h"
#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "test_devices.h"

namespace sundog::parity {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr double kAllowedFraction = 1e-3;
constexpr int kAllowedDifference = 2;
constexpr std::uint32_t kAovs =
    kernel::AOV_DEPTH | kernel::AOV_NORMAL | kernel::AOV_ALBEDO | kernel::AOV_OBJECT | kernel::AOV_COST;

/// Whether object, depth, normal or colour vary among a pixel and its neighbours.
bool on_edge(const Film& film, int x, int y) {
    const std::size_t here = film.index(x, y);
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, kHeight - 1); ++ny) {
        for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, kWidth - 1); ++nx) {
            const std::size_t there = film.index(nx, ny);
            if (film.object[there] != film.object[here]) return true;
            if (film.object[here] == kernel::NONE) continue;
            if (std::fabs(film.depth[there] - film.depth[here]) > 0.05F * film.depth[here]) return true;
            if (dot(film.normal[there], film.normal[here]) < 0.98F) return true;
            if (difference(film.mean(nx, ny), film.mean(x, y)) > 4) return true;
        }
    }
    return false;
}

/// Compares two films pixel by pixel.
void expect_same_picture(const Film& from_cpu, const Film& from_gpu) {
    int different = 0;
    int other_objects = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const std::size_t i = from_cpu.index(x, y);
            if (difference(from_cpu.mean(x, y), from_gpu.mean(x, y)) > kAllowedDifference) {
                ++different;
                EXPECT_TRUE(on_edge(from_cpu, x, y)) << "pixel " << x << ", " << y;
            }
            if (from_cpu.object[i] != from_gpu.object[i]) {
                ++other_objects;
                continue;
            }
            EXPECT_EQ(from_cpu.material[i], from_gpu.material[i]);
            if (from_cpu.object[i] == kernel::NONE) continue;
            EXPECT_NEAR(from_cpu.depth[i], from_gpu.depth[i], 1e-4F * from_cpu.depth[i]);
        }
    }
    const double allowed = kAllowedFraction * kWidth * kHeight;
    EXPECT_LE(different, allowed);
    EXPECT_LE(other_objects, allowed);
}

/// Draws the scene on both and compares; skips the test where there is no GPU. Validation messages fail it.
void compare_devices(const TestScene& test) {
    std::vector<std::string> messages;
    std::string why;
    const auto gpu = open_gpu(messages, why);
    if (!gpu) GTEST_SKIP() << "no GPU to compare with: " << why;
    const auto cpu = make_cpu_device({});
    const Prepared prepared = prepare(test, kWidth, kHeight);
    gpu->load(prepared.scene);
    cpu->load(prepared.scene);
    expect_same_picture(render(*cpu, prepared.frame, 1, kAovs), render(*gpu, prepared.frame, 1, kAovs));
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

class ImageParity : public testing::TestWithParam<TestScene> {};

// Catches whatever the GPU computes otherwise than the CPU: shading, textures, shadows, mirrors, glass, motion,
// clipping, culling, and a hierarchy that loses or displaces things.
TEST_P(ImageParity, CpuAndGpuDrawTheSamePicture) { compare_devices(GetParam()); }

class GalleryParity : public testing::TestWithParam<std::string> {};

// Catches the same on scenes of real size, as importers deliver them.
TEST_P(GalleryParity, CpuAndGpuDrawTheSamePicture) {
    const std::filesystem::path folder = std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / GetParam();
    compare_devices({GetParam(), import::import_scene(folder / (GetParam() + ".scene"), {}), 1.5F});
}

class GltfParity : public testing::TestWithParam<std::string> {};

// Catches the same in what vertices have beside texture coordinates, and in backs that the eye doesn't see.
TEST_P(GltfParity, CpuAndGpuDrawTheSamePicture) {
    const std::filesystem::path folder = std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / "gltf";
    compare_devices({GetParam(), import::import_scene(folder / (GetParam() + ".gltf"), {}), 0});
}

// Catches rainbows, turbulence of fog and of films, and bump maps that the GPU computes otherwise.
TEST(PovParity, WeatherIsTheSame) {
    const auto file = std::filesystem::path(SUNDOG_SOURCE_DIR) / "tests" / "parity" / "scenes" / "weather.pov";
    compare_devices({"weather", import::import_scene(file, [](const Diagnostic& d) { ADD_FAILURE() << format(d); })});
}

std::string test_name(const testing::TestParamInfo<TestScene>& info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

// Catches a GPU whose planes of what is seen stop at veils, or mix what is behind them in other shares.
TEST(SeenThroughParity, BothDevicesMixTheSame) {
    constexpr std::uint32_t kBeyond = kAovs | kernel::AOV_BEYOND;
    std::vector<std::string> messages;
    std::string why;
    const auto gpu = open_gpu(messages, why);
    if (!gpu) GTEST_SKIP() << "no GPU to compare with: " << why;
    const auto cpu = make_cpu_device({});
    const std::vector<TestScene> scenes = test_scenes();
    const auto cut_out =
        std::find_if(scenes.begin(), scenes.end(), [](const TestScene& t) { return t.name == "textures"; });
    const Prepared prepared = prepare(*cut_out, kWidth, kHeight);
    gpu->load(prepared.scene);
    cpu->load(prepared.scene);
    const Film stopped = render(*cpu, prepared.frame, 1, kAovs);
    const Film from_cpu = render(*cpu, prepared.frame, 1, kBeyond);
    const Film from_gpu = render(*gpu, prepared.frame, 1, kBeyond);
    int mixed = 0, different = 0;
    for (std::size_t i = 0; i < from_cpu.albedo.size(); ++i) {
        if (difference(stopped.albedo[i], from_cpu.albedo[i]) > kAllowedDifference) ++mixed;
        const Vec3 turned = from_cpu.normal[i] - from_gpu.normal[i];
        if (difference(from_cpu.albedo[i], from_gpu.albedo[i]) > kAllowedDifference ||
            std::fabs(from_cpu.depth[i] - from_gpu.depth[i]) > 1e-3F * from_cpu.depth[i] || dot(turned, turned) > 1e-3F)
            ++different;
    }
    EXPECT_GT(mixed, 100);
    EXPECT_LE(different, 4 * kAllowedFraction * kWidth * kHeight);
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ImageParity, testing::ValuesIn(test_scenes()), test_name);
INSTANTIATE_TEST_SUITE_P(Gallery, GalleryParity, testing::Values("table", "cornell", "mirrors", "glass", "textured"),
                         [](const testing::TestParamInfo<std::string>& info) { return info.param; });
INSTANTIATE_TEST_SUITE_P(Gallery, GltfParity, testing::Values("colors", "uv_sets", "tangents", "one_sided"),
                         [](const testing::TestParamInfo<std::string>& info) { return info.param; });

}  // namespace

/// How GoogleTest shows the parameter.
void PrintTo(const TestScene& test, std::ostream* stream) { *stream << test.name; }

}  // namespace sundog::parity
