// SPDX-License-Identifier: Apache-2.0
// Grid refinement of whole pictures against tracing every pixel.
#include <gtest/gtest.h>

#include <algorithm>
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
             std::uint32_t aovs = 0, RefinementMethod method = RefinementMethod::grid) {
    Session session(make_cpu_device(device));
    session.load(loaded.compiled);
    Film film({0, 0, kWidth, kHeight}, aovs);
    const RenderStats done = session.refine_into(loaded.frame(aovs), tolerance, 1, film, StopFlag(), method);
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

// Catches the same of spans along scan lines.
TEST_P(RefinedGallery, LooksLikeTheTracedPictureAlongScanLines) {
    const Loaded loaded = load(gallery_file(GetParam()));
    const Film film = refined(loaded, {.threads = 2, .lanes = 0}, 0.1F, nullptr, 0, RefinementMethod::scanline);
    for (const auto& pixel : film.radiance) ASSERT_EQ(1.0F, pixel[3]);
    const output::Comparison distance = output::compare(image_of(traced(loaded)), image_of(film));
    EXPECT_GE(distance.psnr_db, 32);
    EXPECT_GE(distance.ssim, 0.98);
    EXPECT_LE(distance.flip, 0.025);
}

// Catches hits of assumed triangles that differ from those that are searched for: in place, normal, texture coordinates
// or side.
TEST_P(RefinedGallery, WhatIsAssumedIsShadedAlike) {
    const Loaded loaded = load(gallery_file(GetParam()));
    RenderStats stats;
    const Film film = refined(loaded, {.threads = 2, .lanes = 0}, 0.1F, &stats, 0, RefinementMethod::scanline_assumed);
    const output::Comparison distance = output::compare(image_of(traced(loaded)), image_of(film));
    EXPECT_GE(distance.psnr_db, 40);
    EXPECT_GE(distance.ssim, 0.995);
    EXPECT_LE(distance.flip, 0.005);
    EXPECT_LT(stats.points, std::uint64_t{kWidth} * kHeight);
}

// Catches work whose bits depend on who does it, and pixels that are traced although nothing asks for it.
TEST(Refinement, BitsDontDependOnThreadsAndRaysAreFew) {
    const Loaded loaded = load(gallery_file("table"));
    RenderStats stats;
    const Film one = refined(loaded, {.threads = 1, .lanes = 0}, 0.1F, &stats);
    const Film three = refined(loaded, {.threads = 3, .lanes = 0}, 0.1F);
    EXPECT_EQ(one.radiance, three.radiance);
    EXPECT_LT(stats.points, std::uint64_t{kWidth} * kHeight / 4);
}

// Catches the same along scan lines; rays that are shaded without a search must not count as searched.
TEST(Refinement, ScanLinesDontDependOnThreadsEither) {
    const Loaded loaded = load(gallery_file("table"));
    for (const auto method : {RefinementMethod::scanline, RefinementMethod::scanline_assumed}) {
        RenderStats stats;
        const Film one = refined(loaded, {.threads = 1, .lanes = 0}, 0.1F, &stats, kernel::AOV_COST, method);
        EXPECT_EQ(one.radiance,
                  refined(loaded, {.threads = 3, .lanes = 0}, 0.1F, nullptr, kernel::AOV_COST, method).radiance);
        const auto searched = static_cast<std::uint64_t>(
            std::count_if(one.cost.begin(), one.cost.end(), [](float rays) { return rays > 0; }));
        EXPECT_LE(searched, stats.points);
        EXPECT_GT(searched, one.cost.size() / 8);
        EXPECT_LT(searched, one.cost.size() / 2);
    }
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

/// A floor, a ball, a box, and a box and a ball that are turned and moved, under a lamp that makes normals show.
scene::Scene scene_of_shapes() {
    scene::Scene scene = test::empty_scene();
    const scene::Index paint = test::add_material(scene, test::matt({0.8F, 0.7F, 0.6F}));
    test::add_light(scene, scene::Light::Kind::lamp, {3, -2, 8});
    const auto add = [&](const auto& shape) { test::add_shape(scene, shape, paint); };
    const auto add_moving = [&](const auto& shape) {
        add(shape);
        scene::ObjectMotion motion;
        motion.rot_z_deg.kind = scene::Motion::Kind::linear;
        motion.rot_z_deg.speed = 30;
        scene.objects.back().motion = motion;
    };
    add(scene::Plane{{0, 0, 1}, -2});
    add(scene::Sphere{{-3, 10, 0}, 2});
    add(scene::Box{{1, 9, -2}, {4, 11, 1}});
    add_moving(scene::Box{{6, 9, 2}, {9, 12, 5}});
    add_moving(scene::Sphere{{0, 16, 4}, 3});
    return scene;
}

// Catches the same of planes, spheres and boxes, and of those that move. Silhouettes that both ends of a span miss may
// differ.
TEST(Refinement, ShapesAreShadedAsAssumed) {
    Loaded loaded;
    loaded.scene = scene_of_shapes();
    loaded.compiled = compile(loaded.scene, {});
    const Film all = traced(loaded);
    RenderStats stats;
    const Film film = refined(loaded, {.threads = 2, .lanes = 0}, 0.1F, &stats, 0, RefinementMethod::scanline_assumed);
    EXPECT_LT(stats.points, std::uint64_t{kWidth} * kHeight * 2 / 3);  // half of it is sky, which isn't assumed
    std::size_t different = 0, lit = 0;
    for (std::size_t i = 0; i < all.radiance.size(); ++i) {
        different += std::abs(all.radiance[i][0] - film.radiance[i][0]) > 1e-3F ? 1 : 0;
        lit += all.radiance[i][0] > 0.05F ? 1 : 0;
    }
    EXPECT_LT(different, 40U);
    EXPECT_GT(lit, all.radiance.size() / 3);
}

}  // namespace
}  // namespace sundog
