// SPDX-License-Identifier: Apache-2.0
// Whole pictures whose eye rays are found by scan conversion, against traced ones.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "compile/compile.h"
#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "session/session.h"

namespace sundog {
namespace {

constexpr int kWidth = 250, kHeight = 187;  // no multiples of anything

struct Loaded {
    scene::Scene scene;
    std::shared_ptr<const RenderScene> compiled;
    [[nodiscard]] Frame frame() const {
        FrameOptions options;
        options.width = kWidth;
        options.height = kHeight;
        options.time_s = 1;
        options.aovs = kernel::AOV_OBJECT | kernel::AOV_DEPTH | kernel::AOV_NORMAL;
        return make_frame(scene, *compiled, options);
    }
};

Loaded load(scene::Scene scene) {
    Loaded loaded;
    loaded.scene = std::move(scene);
    loaded.compiled = compile(loaded.scene, {});
    return loaded;
}

Loaded gallery(const std::string& name) {
    return load(
        import::import_scene(std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / name / (name + ".scene"), {}));
}

Film rendered(const Loaded& loaded, CpuOptions options, std::uint32_t samples = 1) {
    Session session(make_cpu_device(options));
    session.load(loaded.compiled);
    return session.render(loaded.frame(), samples, {}, StopFlag{}).film;
}

CpuOptions by(PrimaryHits primary, int threads = 2, int lanes = 0) {
    CpuOptions options;
    options.threads = threads;
    options.lanes = lanes;
    options.primary = primary;
    return options;
}

/// The same objects to the bit, depths and colours but for rounding. Where a shadow's edge passes a pixel, rounding may
/// turn it dark: in a few.
void expect_same(const Film& traced, const Film& rastered) {
    EXPECT_EQ(traced.object, rastered.object);
    EXPECT_EQ(traced.primitive, rastered.primitive);
    EXPECT_EQ(traced.material, rastered.material);
    std::size_t seen = 0, other_colors = 0;
    for (std::size_t i = 0; i < traced.radiance.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(traced.radiance[i][c] - rastered.radiance[i][c]) > 1e-3F * (1 + traced.radiance[i][c])) {
                ++other_colors;
                break;
            }
        if (traced.object[i] == kernel::NONE) continue;
        ++seen;
        EXPECT_NEAR(traced.depth[i], rastered.depth[i], 3e-5F * traced.depth[i]) << i;
        EXPECT_GT(dot(traced.normal[i], rastered.normal[i]), 0.999F) << i;
    }
    EXPECT_GT(seen, traced.radiance.size() / 4);
    EXPECT_LT(other_colors, traced.radiance.size() / 1000);
}

// Catches hits that the kernel is given in another form than Embree's: sides of normals, coordinates on triangles,
// materials; and balls, glass or moving things that are passed over.
TEST(RasterPicture, TheGallery) {
    for (const char* name : {"table", "cornell", "mirrors", "glass", "textured"}) {
        SCOPED_TRACE(name);
        const Loaded loaded = gallery(name);
        expect_same(rendered(loaded, by(PrimaryHits::trace)), rendered(loaded, by(PrimaryHits::raster)));
    }
}

// Catches samples beside the pixels' middles that are scanned in another place than they are traced.
TEST(RasterPicture, ManySamples) {
    const Loaded loaded = gallery("table");
    const Film traced = rendered(loaded, by(PrimaryHits::trace), 5),
               rastered = rendered(loaded, by(PrimaryHits::raster), 5);
    expect_same(traced, rastered);
    EXPECT_EQ(rastered.radiance[0][3], 5);
}

// Catches bits that depend on threads, on the processor's vectors more than tracing's do, or on how a picture is cut.
TEST(RasterPicture, TheSameForAnyThreads) {
    const Loaded loaded = gallery("cornell");
    const Film one = rendered(loaded, by(PrimaryHits::raster, 1)), two = rendered(loaded, by(PrimaryHits::raster, 2));
    EXPECT_EQ(one.radiance, two.radiance);
    EXPECT_EQ(one.depth, two.depth);
    Session session(make_cpu_device(by(PrimaryHits::raster)));
    session.load(loaded.compiled);
    const Frame frame = loaded.frame();
    Film parts({0, 0, kWidth, kHeight}, frame.params.aovs);
    for (int y = 0; y < kHeight; y += 50)
        session.device().render(frame, {{0, y, kWidth, std::min(y + 50, kHeight)}, 0, 1}, parts, StopFlag{});
    EXPECT_EQ(one.radiance, parts.radiance);
    for (const int lanes : {4, 8}) {
        SCOPED_TRACE(lanes);
        expect_same(rendered(loaded, by(PrimaryHits::trace, 2, lanes)),
                    rendered(loaded, by(PrimaryHits::raster, 2, lanes)));
    }
}

// Catches bits that depend on whether a pixel is rendered alone, among small regions or with all others.
TEST(RasterPicture, TheSameInSmallRegions) {
    const Loaded loaded = gallery("textured");
    const Film whole = rendered(loaded, by(PrimaryHits::raster));
    Session session(make_cpu_device(by(PrimaryHits::raster)));
    session.load(loaded.compiled);
    const Frame frame = loaded.frame();
    std::vector<PixelRect> regions;
    for (int y = 0; y < kHeight; y += 13)
        for (int x = 0; x < kWidth; x += 37)
            regions.push_back({x, y, std::min(x + 37, kWidth), std::min(y + 13, kHeight)});
    Film parts({0, 0, kWidth, kHeight}, frame.params.aovs);
    session.device().render_regions(frame, regions, {{}, 0, 1}, parts, StopFlag{});
    EXPECT_EQ(whole.radiance, parts.radiance);
    EXPECT_EQ(whole.depth, parts.depth);
    Film one({101, 97, 102, 98}, frame.params.aovs);
    session.device().render(frame, {one.bounds, 0, 1}, one, StopFlag{});
    EXPECT_EQ(one.radiance[0], whole.radiance[whole.index(101, 97)]);
}

// Catches light buffers that change a bit of a picture or leave rays uncounted.
TEST(LightBufferPicture, TheGallery) {
    for (const char* name : {"table", "cornell", "mirrors", "glass", "textured"}) {
        SCOPED_TRACE(name);
        const Loaded loaded = gallery(name);
        CpuOptions options = by(PrimaryHits::trace);
        const auto render = [&](bool light_buffers) {
            options.light_buffers = light_buffers;
            Session session(make_cpu_device(options));
            session.load(loaded.compiled);
            FrameOptions frame_options;
            frame_options.width = 600;  // enough pixels for all of the gallery
            frame_options.height = 400;
            frame_options.time_s = 2;
            frame_options.aovs = kernel::AOV_COST;
            const Frame frame = make_frame(loaded.scene, *loaded.compiled, frame_options);
            return session.render(frame, 1, {}, StopFlag{}).film;
        };
        const Film with = render(true), without = render(false);
        EXPECT_EQ(with.radiance, without.radiance);
        EXPECT_EQ(with.cost, without.cost);
    }
}

// Catches scan conversion of what it can't do: other cameras, back faces left out, things that the eye doesn't see, and
// planes, which lie before triangles or in them.
TEST(RasterPicture, WhatIsTracedInstead) {
    scene::Scene scene = gallery("table").scene;
    scene.settings.cull_backfaces = true;
    Loaded loaded = load(scene);
    EXPECT_EQ(rendered(loaded, by(PrimaryHits::trace)).radiance, rendered(loaded, by(PrimaryHits::raster)).radiance);
    scene.settings.cull_backfaces = false;
    scene.objects.front().seen_by_camera = false;
    loaded = load(scene);
    EXPECT_EQ(rendered(loaded, by(PrimaryHits::trace)).radiance, rendered(loaded, by(PrimaryHits::raster)).radiance);
    scene.objects.front().seen_by_camera = true;
    for (const float height : {0.0F, 0.3F, -1.0F}) {
        scene::Object plane;
        plane.shape = scene::Plane{{0, 0, 1}, height};
        scene.objects.push_back(plane);
        loaded = load(scene);
        expect_same(rendered(loaded, by(PrimaryHits::trace)), rendered(loaded, by(PrimaryHits::raster)));
        scene.objects.pop_back();
    }
}

}  // namespace
}  // namespace sundog
