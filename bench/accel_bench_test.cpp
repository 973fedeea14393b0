// SPDX-License-Identifier: Apache-2.0
#include "bench/accel_bench.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/spd/spd.h"
#include "compile/compile.h"
#include "device/choose/choose.h"

namespace sundog::bench {
namespace {

struct Count {
    std::size_t triangles = 0, spheres = 0, solids = 0;
};

Count count_of(const RenderScene& scene) {
    Count count;
    for (const kernel::Geometry& g : scene.geometries) {
        if (g.kind == kernel::GEOMETRY_TRIANGLES) count.triangles += g.primitive_count;
        if (g.kind == kernel::GEOMETRY_SPHERE) count.spheres += g.primitive_count;
        if (g.kind == kernel::GEOMETRY_SOLID) count.solids += g.primitive_count;
    }
    return count;
}

// Catches generators that make another scene than Haines describes: his numbers of things (his polygons are triangles
// here), and all of it within his bounds.
TEST(Spd, HoldWhatHainesDescribes) {
    struct Expected {
        scene::Scene (*make)();
        Count count;
    };
    for (const Expected& e : {Expected{spd_balls, {2, 7381, 0}}, Expected{spd_gears, {2 + 64 * 4 * 144, 0, 0}},
                              Expected{spd_mount, {8192, 4, 0}}, Expected{spd_rings, {2, 4200, 4200}},
                              Expected{spd_tetra, {4096, 0, 0}}, Expected{spd_tree, {2, 4095, 4095}}}) {
        const scene::Scene scene = e.make();
        SCOPED_TRACE(scene.name);
        const auto compiled = compile(scene, {});
        const Count count = count_of(*compiled);
        EXPECT_EQ(count.triangles, e.count.triangles);
        EXPECT_EQ(count.spheres, e.count.spheres);
        EXPECT_EQ(count.solids, e.count.solids);
        EXPECT_GE(scene.lights.size(), 1U);
        EXPECT_LT(length(compiled->bounds.extent()), 200);
    }
}

// Catches a camera that looks past its scene: much of each picture must be covered and lit.
TEST(Spd, AreInThePicture) {
    for (const std::string& name : accel_scene_names()) {
        SCOPED_TRACE(name);
        const scene::Scene scene = accel_scene({}, name);
        const auto compiled = compile(scene, {});
        FrameOptions options;
        options.width = 80;
        options.height = 60;
        const Frame frame = make_frame(scene, *compiled, options);
        const auto device = open_device("cpu", 2);
        device->load(compiled);
        Film film({0, 0, 80, 60});
        device->render(frame, {film.bounds, 0, 1}, film, StopFlag());
        const auto lit = std::count_if(film.radiance.begin(), film.radiance.end(),
                                       [](const auto& p) { return p[0] + p[1] + p[2] > 0.02F; });
        EXPECT_GT(lit, 80 * 60 / 8);
    }
}

// Catches pictures that depend on what finds the hits. Embree's tests round elsewhere, so few pixels may differ; ours
// all share theirs, so none may.
TEST(Accel, PicturesAreTheSameForAllStructures) {
    for (const char* name : {"textured", "glass", "mirrors", "mount", "rings", "tree"}) {
        SCOPED_TRACE(name);
        const scene::Scene scene = accel_scene({}, name);
        const auto compiled = compile(scene, {});
        FrameOptions options;
        options.width = 48;
        options.height = 36;
        options.time_s = 1.7F;
        const Frame frame = make_frame(scene, *compiled, options);
        const auto picture = [&](Acceleration which) {
            const auto device = open_device("cpu", 2, which);
            device->load(compiled);
            Film film({0, 0, 48, 36});
            device->render(frame, {film.bounds, 0, 1}, film, StopFlag());
            return film.radiance;
        };
        const auto none = picture(Acceleration::none);
        for (const Acceleration ours :
             {Acceleration::bvh, Acceleration::kdtree, Acceleration::octree, Acceleration::grid, Acceleration::boxes})
            EXPECT_EQ(picture(ours), none) << name_of(ours);
        const auto embree = picture(Acceleration::embree);
        std::size_t different = 0;
        for (std::size_t i = 0; i < none.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                if (std::abs(none[i][c] - embree[i][c]) > 0.02F) {
                    ++different;
                    break;
                }
        EXPECT_LE(different, none.size() / 50);
    }
}

// Catches a table without a structure, numbers in the wrong column, and steps shown for Embree.
TEST(Accel, ReportShowsWhatWasMeasured) {
    AccelReport report{"A machine", 2, 3, {}};
    report.timings.push_back({"table", 1128, Acceleration::embree, 0.001, 1 << 20U, 0, 0, 8e6});
    report.timings.push_back({"table", 1128, Acceleration::grid, 0.002, 2 << 20U, 12.25, 3.5, 2e6});
    const std::string text = format_report(report);
    EXPECT_NE(text.find("A machine; 2 threads used; medians of 3 rounds"), std::string::npos);
    EXPECT_NE(text.find("embree         1.00      1.00          -           -    8.000     1.000"), std::string::npos)
        << text;
    EXPECT_NE(text.find("grid           2.00      2.00       12.2         3.5    2.000     0.250"), std::string::npos)
        << text;
}

// Catches a structure left out, steps that aren't counted, and a run that goes on for other scenes than the one asked
// for.
TEST(Accel, MeasuresEveryStructure) {
    AccelOptions options;
    options.rounds = 1;
    options.only = "cornell";
    const AccelReport report = run_accel_bench(options, {}, StopFlag());
    ASSERT_EQ(report.timings.size(), kAccelerationNames.size());
    const double primitives = static_cast<double>(report.timings[0].primitives);
    for (const AccelTiming& t : report.timings) {
        SCOPED_TRACE(name_of(t.structure));
        EXPECT_GT(t.rays_per_second, 0);
        EXPECT_GT(t.bytes, 0U);
        if (t.structure == Acceleration::embree) continue;
        EXPECT_GT(t.tests, 0);
        EXPECT_LE(t.tests, 1.2 * primitives);  // a shadow ray goes on behind glass without being counted again
    }
}

}  // namespace
}  // namespace sundog::bench
