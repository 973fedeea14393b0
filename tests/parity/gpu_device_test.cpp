// SPDX-License-Identifier: Apache-2.0
// What the Device interface promises, asked of the GPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics.h"
#include "device/vulkan/vulkan_device.h"
#include "test_devices.h"

namespace sundog::parity {
namespace {

constexpr std::uint32_t kAllAovs =
    kernel::AOV_DEPTH | kernel::AOV_NORMAL | kernel::AOV_ALBEDO | kernel::AOV_OBJECT | kernel::AOV_COST;

class GpuDevice : public testing::Test {
protected:
    void SetUp() override {
        std::string why;
        gpu_ = open_gpu(messages_, why);
        if (!gpu_) GTEST_SKIP() << "no GPU to test on: " << why;
    }
    void TearDown() override {
        gpu_.reset();
        for (const std::string& message : messages_) ADD_FAILURE() << message;
    }

    TestScene scene(const std::string& name) {
        for (TestScene& test : test_scenes()) {
            if (test.name == name) return test;
        }
        throw std::runtime_error("no test scene called " + name);
    }

    std::vector<std::string> messages_;
    std::unique_ptr<Device> gpu_;
};

// Catches sums that depend on how samples and regions were split into work: progressive pictures must end up equal to
// those rendered at once, to the bit.
TEST_F(GpuDevice, GivesTheSameBitsHoweverWorkIsSplit) {
    const Prepared prepared = prepare(scene("matt triangles"), 61, 43);
    gpu_->load(prepared.scene);
    Frame frame = prepared.frame;
    frame.params.aovs = kAllAovs;
    const Film whole = render(*gpu_, frame, 5, kAllAovs);
    Film parts(whole.bounds, kAllAovs);
    const StopFlag never;
    for (const PixelRect region : {PixelRect{0, 0, 20, 43}, PixelRect{20, 0, 61, 9}, PixelRect{20, 9, 61, 43}}) {
        gpu_->render(frame, {region, 0, 1}, parts, never);
        gpu_->render(frame, {region, 1, 3}, parts, never);
        gpu_->render(frame, {region, 4, 1}, parts, never);
    }
    EXPECT_EQ(parts.radiance, whole.radiance);
    EXPECT_EQ(parts.depth, whole.depth);
    EXPECT_EQ(parts.normal, whole.normal);
    EXPECT_EQ(parts.albedo, whole.albedo);
    EXPECT_EQ(parts.object, whole.object);
    EXPECT_EQ(parts.primitive, whole.primitive);
    EXPECT_EQ(parts.material, whole.material);
    EXPECT_EQ(parts.cost, whole.cost);
}

// Catches pixels outside the work's region that are touched, and films whose bounds don't start at 0.
TEST_F(GpuDevice, WritesOnlyTheRegion) {
    const Prepared prepared = prepare(scene("matt triangles"), 64, 48);
    gpu_->load(prepared.scene);
    const Film whole = render(*gpu_, prepared.frame, 1);
    Film window({10, 5, 50, 40});
    const std::array<float, 4> untouched{-1, -2, -3, -4};
    std::fill(window.radiance.begin(), window.radiance.end(), untouched);
    const PixelRect region{17, 9, 30, 21};
    const StopFlag never;
    gpu_->render(prepared.frame, {region, 0, 1}, window, never);
    for (int y = 5; y < 40; ++y) {
        for (int x = 10; x < 50; ++x) {
            const bool inside = x >= region.x0 && x < region.x1 && y >= region.y0 && y < region.y1;
            EXPECT_EQ(window.radiance[window.index(x, y)], inside ? whole.radiance[whole.index(x, y)] : untouched);
        }
    }
}

// Catches rays that are not counted, or counted for workgroup cells outside the picture.
TEST_F(GpuDevice, CountsRays) {
    const Prepared sky = prepare(scene("nothing but sky"), 13, 9);
    gpu_->load(sky.scene);
    Film film({0, 0, 13, 9}, kernel::AOV_COST);
    const StopFlag never;
    const RenderStats stats = gpu_->render(sky.frame, {film.bounds, 0, 3}, film, never);
    EXPECT_EQ(stats.rays, 13U * 9U * 3U);
    EXPECT_EQ(stats.shadow_rays, 0U);
    EXPECT_TRUE(stats.complete);
    for (const float cost : film.cost) EXPECT_EQ(cost, 3);
}

// Catches a stop that is not heeded, or that is reported as a complete picture.
TEST_F(GpuDevice, Stops) {
    const Prepared prepared = prepare(scene("nothing but sky"), 32, 32);
    gpu_->load(prepared.scene);
    Film film({0, 0, 32, 32});
    StopFlag stop;
    stop.request();
    const RenderStats stats = gpu_->render(prepared.frame, {film.bounds, 0, 1000000}, film, stop);
    EXPECT_FALSE(stats.complete);
    EXPECT_EQ(stats.rays, 0U);
    EXPECT_EQ(film.radiance[0][3], 0);
}

// Catches what the first scene leaves behind: smaller and larger scenes, with and without a second level, one after the
// other on one device.
TEST_F(GpuDevice, ForgetsTheSceneBefore) {
    const Prepared sky = prepare(scene("nothing but sky"), 24, 16);
    const Prepared waves = prepare(scene("matt triangles"), 24, 16);
    gpu_->load(waves.scene);
    const Film first = render(*gpu_, waves.frame, 1);
    gpu_->load(sky.scene);
    const Film empty = render(*gpu_, sky.frame, 1);
    for (const auto& sum : empty.radiance) EXPECT_EQ(sum, empty.radiance[0]);
    gpu_->load(waves.scene);
    EXPECT_EQ(render(*gpu_, waves.frame, 1).radiance, first.radiance);
    EXPECT_GT(gpu_->memory_bytes(), memory_bytes(*waves.scene));
}

// Catches buffers for auxiliary planes that stay as small, or as few, as an earlier film wanted them.
TEST_F(GpuDevice, GivesEachFilmItsOwnPlanes) {
    const Prepared small = prepare(scene("matt triangles"), 8, 6);
    const Prepared large = prepare(scene("matt triangles"), 40, 30);
    gpu_->load(small.scene);
    render(*gpu_, small.frame, 1, kernel::AOV_DEPTH);
    render(*gpu_, large.frame, 1, 0);
    const Film film = render(*gpu_, large.frame, 1, kernel::AOV_DEPTH | kernel::AOV_COST);
    EXPECT_EQ(film.depth.back(), INFINITY);  // the sky
    EXPECT_LT(*std::min_element(film.depth.begin(), film.depth.end()), 10);
    for (const float cost : film.cost) EXPECT_GE(cost, 1);
}

// Catches a scene whose light below surfaces would be left out without a word.
TEST_F(GpuDevice, RefusesLightBelowSurfacesByItsLine) {
    scene::Scene scene;
    scene.subsurface.emplace();
    auto texture = std::make_shared<scene::LayeredTexture>();
    texture->layers.push_back({std::make_shared<scene::Pigment>(), {}});
    texture->layers[0].finish.translucency = {1, 1, 1};
    scene::Material wax;
    wax.patterned->texture = texture;
    wax.where = {std::make_shared<const std::string>("wax.pov"), 7, 1};
    scene.materials.push_back(wax);
    scene::Object ball;
    ball.shape = scene::Sphere{{0, 0, 0}, 1};
    ball.material = 0;
    scene.objects.push_back(ball);
    const auto reasons = gpu_->unsupported(*compile(scene, {}));
    ASSERT_EQ(reasons.size(), 1U);
    EXPECT_EQ(reasons[0], "wax.pov:7: light below surfaces is drawn by the CPU only; use --device cpu");
}

// Catches a scene that is too large for the GPU and is neither refused nor named.
TEST_F(GpuDevice, NamesTheArrayThatIsTooLarge) {
    RenderScene scene;
    EXPECT_TRUE(gpu_->unsupported(scene).empty());
    if (!gpu_->info().software) GTEST_SKIP() << "this GPU reads arrays too large for a test to allocate";
    scene.texels.resize(std::size_t{40} << 20U);  // 160 MiB
    const auto reasons = gpu_->unsupported(scene);
    ASSERT_EQ(reasons.size(), 1U);
    EXPECT_NE(reasons[0].find("'texels'"), std::string::npos);
    EXPECT_NE(reasons[0].find("160.0 MiB"), std::string::npos);
}

// Catches uploads that go wrong where the host doesn't see the GPU's memory, as on most cards: pieces left out, at the
// wrong place, or of the wrong length. Only the way of the data differs, so all bits are equal.
TEST_F(GpuDevice, GivesTheSameBitsThroughStagingBuffers) {
    VulkanOptions options;
    options.map_device_memory = false;
    options.staging_bytes = 1000;  // Most arrays take many pieces, and the last one is shorter.
    std::string why;
    const auto staged = open_gpu(messages_, why, options);
    ASSERT_TRUE(staged) << why;
    for (const char* name : {"matt triangles", "textures"}) {
        SCOPED_TRACE(name);
        const Prepared prepared = prepare(scene(name), 64, 48);
        gpu_->load(prepared.scene);
        staged->load(prepared.scene);
        const Film direct = render(*gpu_, prepared.frame, 2, kAllAovs);
        const Film film = render(*staged, prepared.frame, 2, kAllAovs);
        EXPECT_EQ(film.radiance, direct.radiance);
        EXPECT_EQ(film.depth, direct.depth);
        EXPECT_EQ(film.object, direct.object);
        EXPECT_EQ(film.cost, direct.cost);
    }
}

// Catches rendering without a scene, and an adapter number out of range.
TEST_F(GpuDevice, RefusesMisuseWithAMessage) {
    Film film({0, 0, 4, 4});
    const StopFlag never;
    EXPECT_THROW(gpu_->render(Frame{}, {film.bounds, 0, 1}, film, never), DeviceError);
    EXPECT_THROW(make_vulkan_device(1000), DeviceError);
}

// Catches an adapter list that is empty without a reason, or entries without a name.
TEST(VulkanAdapters, AreListedOrItIsSaidWhyNot) {
    std::string why;
    const auto adapters = vulkan_adapters(why);
    EXPECT_EQ(adapters.empty(), !why.empty());
    for (const VulkanAdapter& adapter : adapters) {
        EXPECT_EQ(adapter.info.kind, "gpu");
        EXPECT_FALSE(adapter.info.name.empty());
        EXPECT_NE(adapter.info.detail.find("Vulkan 1."), std::string::npos);
    }
}

}  // namespace
}  // namespace sundog::parity
