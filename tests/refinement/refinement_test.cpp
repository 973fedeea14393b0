// SPDX-License-Identifier: Apache-2.0
// Grid refinement of whole pictures against tracing every pixel.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "compile/compile.h"
#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "output/compare.h"
#include "output/image.h"
#include "scenes/scene_builder.h"
#include "session/session.h"

namespace sundog {
namespace {

constexpr int kWidth = 250, kHeight = 187;  // no multiples of anything

struct Loaded {
    scene::Scene scene;
    std::shared_ptr<const RenderScene> compiled;
    [[nodiscard]] Frame frame(std::uint32_t aovs = 0) const {
        FrameOptions options;
        options.width = kWidth;
        options.height = kHeight;
        options.time_s = 1;
        options.aovs = aovs;
        return make_frame(scene, *compiled, options);
    }
};

Loaded load(const std::filesystem::path& file) {
    Loaded loaded;
    loaded.scene = import::import_scene(file, {});
    loaded.compiled = compile(loaded.scene, {});
    return loaded;
}

std::filesystem::path gallery_file(const std::string& name) {
    return std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / name / (name + ".scene");
}

Film refined(const Loaded& loaded, CpuOptions device, float tolerance, RenderStats* stats = nullptr,
             std::uint32_t aovs = 0) {
    Session session(make_cpu_device(device));
    session.load(loaded.compiled);
    Film film({0, 0, kWidth, kHeight}, aovs);
    const RenderStats done = session.refine_into(loaded.frame(aovs), tolerance, 1, film, StopFlag());
    if (stats != nullptr) *stats = done;
    return film;
}

Film traced(const Loaded& loaded) {
    Session session(make_cpu_device({.threads = 2, .lanes = 0}));
    session.load(loaded.compiled);
    Film film({0, 0, kWidth, kHeight});
    session.render_into(loaded.frame(), 0, 1, film, StopFlag());
    return film;
}

output::Image image_of(const Film& film) {
    output::Image image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) image.at(x, y) = film.mean(x, y);
    return image;
}

class RefinedGallery : public testing::TestWithParam<const char*> {};

// Catches memories that leave out something that shows: edges, shadows, mirrors, glass, highlights, textures.
TEST_P(RefinedGallery, LooksLikeTheTracedPicture) {
    const Loaded loaded = load(gallery_file(GetParam()));
    RenderStats stats;
    const Film film = refined(loaded, {.threads = 2, .lanes = 0}, 0.1F, &stats);
    for (const auto& pixel : film.radiance) ASSERT_EQ(1.0F, pixel[3]);
    const output::Comparison distance = output::compare(image_of(traced(loaded)), image_of(film));
    EXPECT_GE(distance.psnr_db, 32);
    EXPECT_GE(distance.ssim, 0.98);
    EXPECT_LE(distance.flip, 0.02);
    EXPECT_GT(stats.points, 0U);
}

INSTANTIATE_TEST_SUITE_P(Gallery, RefinedGallery, testing::Values("table", "cornell", "mirrors", "glass", "textured"),
                         [](const auto& name) { return std::string(name.param); });

// Catches work whose bits depend on who does it, and pixels that are traced although nothing asks for it.
TEST(Refinement, BitsDontDependOnThreadsAndRaysAreFew) {
    const Loaded loaded = load(gallery_file("table"));
    RenderStats stats;
    const Film one = refined(loaded, {.threads = 1, .lanes = 0}, 0.1F, &stats);
    const Film three = refined(loaded, {.threads = 3, .lanes = 0}, 0.1F);
    EXPECT_EQ(one.radiance, three.radiance);
    EXPECT_LT(stats.points, std::uint64_t{kWidth} * kHeight / 4);
}

// Catches a tolerance of 0 that still interpolates.
TEST(Refinement, NoToleranceTracesAll) {
    const Loaded loaded = load(gallery_file("cornell"));
    RenderStats stats;
    EXPECT_EQ(traced(loaded).radiance, refined(loaded, {.threads = 2, .lanes = 0}, 0, &stats).radiance);
    EXPECT_EQ(std::uint64_t{kWidth} * kHeight, stats.points);
}

// Catches a plane of costs that doesn't tell traced pixels from others.
TEST(Refinement, CostsTellWhereRaysWent) {
    const Loaded loaded = load(gallery_file("table"));
    const Film film = refined(loaded, {.threads = 2, .lanes = 0}, 0.1F, nullptr, kernel::AOV_COST);
    const Film all = traced(loaded);
    std::size_t rays_went = 0;
    for (std::size_t i = 0; i < film.cost.size(); ++i) {
        if (film.cost[i] == 0) continue;
        ++rays_went;
        // What was traced is exact, but for how Embree takes other packets.
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(all.radiance[i][c], film.radiance[i][c], 0.02);
    }
    EXPECT_GT(rays_went, film.cost.size() / 64);
    EXPECT_LT(rays_went, film.cost.size() / 4);
}

/// A wall, and before it a ball and a post that are thinner on the screen than any square. The camera looks along +Y.
scene::Scene scene_of_thin_things() {
    scene::Scene scene = test::empty_scene();
    const auto add = [&](const auto& shape, Vec3 color) {
        test::add_shape(scene, shape, test::add_material(scene, test::glowing_mirror(color, {})));
    };
    add(scene::Box{{-40, 30, -40}, {40, 31, 40}}, {0.2F, 0.2F, 0.2F});
    add(scene::Sphere{{0.303F, 10, 0.208F}, 0.06F}, {1, 0, 0});
    add(scene::Box{{-2.03F, 10, -2}, {-1.97F, 10.05F, 2}}, {0, 1, 0});
    return scene;
}

// Catches thin things that all corners of squares miss: one that shows when every pixel is traced must show here.
TEST(Refinement, ThinThingsAreFound) {
    Loaded loaded;
    loaded.scene = scene_of_thin_things();
    loaded.compiled = compile(loaded.scene, {});
    const Film all = traced(loaded);
    std::size_t thin = 0;
    for (const auto& pixel : all.radiance) thin += pixel[0] > 0.5F || pixel[1] > 0.5F ? 1 : 0;
    EXPECT_GT(thin, 20U);
    EXPECT_EQ(all.radiance, refined(loaded, {.threads = 2, .lanes = 0}, 0.1F).radiance);
}

}  // namespace
}  // namespace sundog
