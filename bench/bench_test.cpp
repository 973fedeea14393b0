// SPDX-License-Identifier: Apache-2.0
#include "bench/bench.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/diagnostics.h"
#include "bench/machine.h"
#include "bench/raw_embree.h"
#include "bench/statistics.h"
#include "bench/tachyon.h"
#include "compile/compile.h"
#include "device/choose/choose.h"
#include "import/import.h"

namespace sundog::bench {
namespace {

/// A matt square of side 2 around the origin at z = 0, seen from straight above so that it fills the picture, and a
/// lamp.
scene::Scene square_under_lamp() {
    scene::Scene scene;
    scene.materials.emplace_back().name = "matt";
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    const std::uint32_t none = scene::kNone;
    mesh.triangles = {{{0, 1, 2}, {none, none, none}, {none, none, none}, 0},
                      {{0, 2, 3}, {none, none, none}, {none, none, none}, 0}};
    scene::Object object;
    object.name = "square";
    object.shape = mesh;
    scene.objects.push_back(object);
    scene.lights.emplace_back().place = {0, 0, 5};
    scene.camera.rot_x_deg.base = -90;
    scene.camera.distance = 0.5F;
    return scene;
}

Frame frame_of(const scene::Scene& scene, const RenderScene& compiled, int width, int height, int depth) {
    FrameOptions options;
    options.width = width;
    options.height = height;
    options.max_depth = depth;
    options.min_weight = 0.0F;
    options.shadows = true;
    return make_frame(scene, compiled, options);
}

std::size_t occurrences(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++count;
    return count;
}

// Catches a median of an even count that takes one side only, and a crash on no values.
TEST(Median, IsTheMiddle) {
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_EQ(median({}), 0);
}

// Catches keys taken for a longer key's beginning ("cpu" in "cpu family") and values with their padding.
TEST(Machine, ReadsAField) {
    const std::string text = "processor\t: 0\ncpu family\t: 6\nmodel name\t: A Processor @ 2 GHz\n";
    EXPECT_EQ(field_of(text, "model name"), "A Processor @ 2 GHz");
    EXPECT_EQ(field_of(text, "cpu"), "");
    EXPECT_EQ(field_of(text, "cpu family"), "6");
}

// Catches rays left out or counted twice: every pixel sees the square, and the lamp lies in front of all of it.
TEST(RawEmbree, CountsPrimaryAndShadowRays) {
    const scene::Scene scene = square_under_lamp();
    const auto compiled = compile(scene, {});
    for (const int lanes : {4, 8, 16}) {
        if (lanes == 8 && !__builtin_cpu_supports("avx2")) continue;
        if (lanes == 16 && !__builtin_cpu_supports("avx512f")) continue;
        RawEmbree raw(compiled, 2, lanes);
        const RawFrame traced = raw.trace(frame_of(scene, *compiled, 37, 29, 1));  // No multiple of any block.
        EXPECT_EQ(traced.rays, 2U * 37 * 29) << lanes;
        EXPECT_EQ(traced.shadow_rays, 37U * 29) << lanes;
        EXPECT_EQ(traced.blocked, 0U) << lanes;
    }
}

// Catches a lamp behind something opaque that is said to be seen: wrong ray ends or directions.
TEST(RawEmbree, FindsWhatBlocksTheLamp) {
    scene::Scene scene = square_under_lamp();
    scene::Object ball;
    ball.name = "ball";
    ball.shape = scene::Sphere{{0, 0, 4}, 0.9F};
    scene.objects.push_back(ball);
    const auto compiled = compile(scene, {});
    RawEmbree raw(compiled, 1);
    const RawFrame traced = raw.trace(frame_of(scene, *compiled, 32, 32, 0));
    EXPECT_EQ(traced.blocked, traced.shadow_rays);
}

// Catches a yardstick that traces other rays than the renderer: at most one in a hundred differs (the raw loop goes by
// the faces' normals where it decides which lights are in front).
TEST(RawEmbree, TracesTheRaysOfTheRenderer) {
    const std::filesystem::path gallery = std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes";
    const auto device = open_device("cpu", 2);
    for (const std::string name : {"table", "cornell"}) {
        const scene::Scene scene = import::import_scene(gallery / name / (name + ".scene"), {});
        const auto compiled = compile(scene, {});
        const Frame frame = frame_of(scene, *compiled, 160, 120, 2);
        device->load(compiled);
        Film film({0, 0, 160, 120});
        const RenderStats ours = device->render(frame, {film.bounds, 0, 1}, film, StopFlag());
        const RawFrame raw = RawEmbree(compiled, 2).trace(frame);
        EXPECT_NEAR(static_cast<double>(raw.rays), static_cast<double>(ours.rays),
                    0.01 * static_cast<double>(ours.rays))
            << name;
        EXPECT_NEAR(static_cast<double>(raw.shadow_rays), static_cast<double>(ours.shadow_rays),
                    0.01 * static_cast<double>(ours.shadow_rays))
            << name;
    }
}

// Catches silence about a scene that the yardstick would trace only in part.
TEST(RawEmbree, RefusesWhatItDoesNotTrace) {
    scene::Scene scene = square_under_lamp();
    scene::Object plane;
    plane.shape = scene::Plane{};
    scene.objects.push_back(plane);
    EXPECT_THROW(RawEmbree(compile(scene, {}), 1), DeviceError);
}

// Catches missing statements and a camera that isn't mirrored to Tachyon's left-handed one.
TEST(Tachyon, WritesTheScene) {
    scene::Scene scene = square_under_lamp();
    scene.lights[0].place = {2, 3, 5};
    const auto compiled = compile(scene, {});
    const std::string text = tachyon_scene(*compiled, frame_of(scene, *compiled, 64, 48, 1));
    EXPECT_TRUE(text.starts_with("BEGIN_SCENE\nRESOLUTION 64 48\n"));
    EXPECT_TRUE(text.ends_with("END_SCENE\n"));
    EXPECT_EQ(occurrences(text, "\nTRI V0 "), 2U);
    EXPECT_EQ(occurrences(text, "\nTEXDEF m0 "), 1U);
    EXPECT_EQ(occurrences(text, "\nLIGHT CENTER -2 3 5 "), 1U);
    EXPECT_EQ(occurrences(text, "RAYDEPTH 2\n"), 1U);
}

// Catches a figure taken from another line of Tachyon's report.
TEST(Tachyon, ReadsItsReport) {
    EXPECT_EQ(tachyon_seconds("Preprocessing Time:     0.0001 seconds\n\n  Ray Tracing Time:     0.0754 seconds\n"),
              0.0754);
    EXPECT_EQ(tachyon_seconds("sh: tachyon: not found"), std::nullopt);
    EXPECT_EQ(tachyon_seconds("Ray Tracing Time:"), std::nullopt);
}

// Catches a wrong triangle count of the loading benchmark's model, and indices past its vertices.
TEST(Million, MakesAClosedSphere) {
    const std::string text = bumpy_sphere_obj(5);
    EXPECT_EQ(occurrences(text, "\nf "), 4U * 5 * 4);
    EXPECT_EQ(occurrences(text, "\nv "), 2U + 4 * 10);
    EXPECT_NE(text.find(" 42 "), std::string::npos);
    EXPECT_EQ(text.find(" 43 "), std::string::npos);
}

// Catches a table without a scene's row, or one that shows a ratio where there was nothing to compare with.
TEST(Report, ShowsWhatWasMeasured) {
    BenchReport report;
    report.machine = "A machine";
    report.threads = 2;
    report.frames.push_back({.scene = "table",
                             .width = 640,
                             .height = 480,
                             .depth = 1,
                             .device = "cpu",
                             .frame_s = 0.01,
                             .rays = 1e6,
                             .raw_s = 0.005,
                             .raw_rays = 1e6,
                             .ratio = 2.0,
                             .tachyon_s = 0.2});
    report.frames.push_back({.scene = "cornell",
                             .width = 512,
                             .height = 512,
                             .depth = 2,
                             .device = "A GPU",
                             .frame_s = 0.001,
                             .rays = 1e6,
                             .raw_s = {},
                             .ratio = {},
                             .tachyon_s = {}});
    const std::string text = format_report(report);
    EXPECT_NE(text.find("A machine; 2 threads"), std::string::npos);
    EXPECT_NE(text.find("10.00    100.0    100.0 |     5.00    200.0   2.00 |     200.00    20.0"), std::string::npos)
        << text;
    EXPECT_NE(text.find("1.00   1000.0   1000.0 |        -        -      - |          -       -"), std::string::npos)
        << text;
}

}  // namespace
}  // namespace sundog::bench
