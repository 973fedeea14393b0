// SPDX-License-Identifier: Apache-2.0
// Scan conversion against Embree, ray by ray: on random and on nasty meshes, from random and from nasty places.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "device/cpu/embree_scene.h"
#include "device/cpu/given_hits.h"
#include "device/cpu/raster/frame_raster.h"
#include "device/cpu/raster/test_scene.h"
#include "kernel/cameras/pinhole.h"
#include "kernel/cameras/pixel_samples.h"

namespace sundog::cpu::raster {
namespace {

constexpr int kWidth = 150, kHeight = 110;  // no multiples of a tile

kernel::Camera camera_from(Vec3 eye, Vec3 at, Vec3 sky, float half_height) {
    const Vec3 forward = normalize(at - eye), right = normalize(cross(forward, sky));
    const Vec3 up = cross(right, forward) * half_height;
    const Vec3 wide = right * (half_height * kWidth / kHeight);
    return {{eye.x, eye.y, eye.z}, {forward.x, forward.y, forward.z}, {wide.x, wide.y, wide.z}, {up.x, up.y, up.z}};
}

Frame frame_of(const RenderScene& scene, const kernel::Camera& camera, float far_z = INFINITY) {
    Frame frame;
    frame.params.camera = camera;
    frame.params.width = kWidth;
    frame.params.height = kHeight;
    frame.params.far_z = far_z;
    frame.params.plane_count = scene.planes.size() == 1 && scene.planes[0].normal.x == 0 &&
                                       scene.planes[0].normal.y == 0 && scene.planes[0].normal.z == 0
                                   ? 0
                                   : static_cast<kernel::uint>(scene.planes.size());
    frame.lights.resize(1);
    frame.instances.resize(1);
    return frame;
}

struct Tally {
    int hits = 0, misses = 0, unknown = 0;
};

/// Embree's answer for one ray.
RTCRayHit traced(RTCScene scene, const kernel::Ray& ray) {
    RTCRayHit hit{};
    hit.ray = {ray.origin.x,
               ray.origin.y,
               ray.origin.z,
               ray.t_min,
               ray.direction.x,
               ray.direction.y,
               ray.direction.z,
               0,
               ray.t_max,
               kernel::RAY_CAMERA,
               0,
               0};
    hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &hit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &hit);
#endif
    return hit;
}

/// Each pixel of which rasterising is sure must be so for Embree, too: the same triangle, the same place but for
/// rounding.
class Comparer {
public:
    explicit Comparer(const RenderScene& scene)
        : scene_(scene), device_(rtcNewDevice("threads=1")), embree_(device_.get(), scene) {
        for (const int lanes : {4, 8, 16}) {
            if (lanes == 16 && !(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                                 __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl")))
                continue;
            if (lanes == 8 && !__builtin_cpu_supports("avx2")) continue;
            rasters_.push_back({lanes, std::make_unique<FrameRaster>(scene, raster_kernels(lanes))});
        }
    }

    void compare(const Frame& frame, std::uint32_t sample, Tally& tally) {
        embree_.update(frame);
        const kernel::SceneView view = view_of(scene_, frame, nullptr);
        auto scratch = std::make_unique<TileScratch>();
        std::vector<std::uint32_t> list;
        for (const auto& [lanes, raster] : rasters_) {
            raster->prepare(frame);
            const int block_width = lanes == 4 ? 2 : 4, block_height = lanes / block_width;
            for (int y0 = 0; y0 < kHeight; y0 += kTileSide)
                for (int x0 = 0; x0 < kWidth; x0 += kTileSide) {
                    const RasterisedTile tile = raster->tile({x0, y0, x0 + kTileSide, y0 + kTileSide},
                                                             frame.params.sampling, sample, *scratch, list);
                    for (int y = y0; y < std::min(y0 + kTileSide, kHeight); ++y)
                        for (int x = x0; x < std::min(x0 + kTileSide, kWidth); ++x) {
                            const int column = x - x0, row = y - y0;
                            const int block = row / block_height * (kTileSide / block_width) + column / block_width;
                            const std::uint32_t* const said = tile.triangles + block * lanes +
                                                              row % block_height * block_width + column % block_width;
                            compare_pixel(view, frame, x, y, sample, *said, tile.geometries, tally);
                            if (testing::Test::HasFailure()) return;
                        }
                }
        }
    }

private:
    void compare_pixel(const kernel::SceneView& view, const Frame& frame, int x, int y, std::uint32_t sample,
                       std::uint32_t said, const std::uint32_t* geometries, Tally& tally) const {
        if (said == kernel::EYE_UNKNOWN) {
            ++tally.unknown;
            return;
        }
        const kernel::PixelSample offset = kernel::pixel_sample(frame.params.sampling, static_cast<std::uint32_t>(x),
                                                                static_cast<std::uint32_t>(y), sample);
        const kernel::Ray ray =
            kernel::pinhole_ray(frame.params.camera, (static_cast<float>(x) + offset.x) * (1.0F / kWidth),
                                (static_cast<float>(y) + offset.y) * (1.0F / kHeight), frame.params.far_z);
        const RTCRayHit hit = traced(embree_.handle(), ray);
        const std::string where = "pixel " + std::to_string(x) + "," + std::to_string(y);
        if (said == kernel::NONE) {
            ++tally.misses;
            EXPECT_EQ(hit.hit.geomID, RTC_INVALID_GEOMETRY_ID) << where;
            return;
        }
        ++tally.hits;
        ASSERT_NE(hit.hit.geomID, RTC_INVALID_GEOMETRY_ID) << where << ": Embree misses what is said to be " << said;
        EXPECT_EQ(hit.hit.instID[0], RTC_INVALID_GEOMETRY_ID) << where;
        EXPECT_EQ(geometries[said], hit.hit.geomID) << where;
        EXPECT_EQ(said, hit.hit.primID + scene_.geometries[hit.hit.geomID].first_primitive) << where;
        kernel::Hit given{};
        kernel::hit_given_triangles(view, ray, said, {nullptr, geometries}, true, given);
        EXPECT_NEAR(given.t, hit.ray.tfar, depth_rounding(said, frame, ray)) << where;
        const float sine = length(cross(Vec3{given.normal.x, given.normal.y, given.normal.z},
                                        Vec3{hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z}));
        const float cosine =
            given.normal.x * hit.hit.Ng_x + given.normal.y * hit.hit.Ng_y + given.normal.z * hit.hit.Ng_z;
        EXPECT_GT(cosine, 0) << where << ": the normal's side";
        EXPECT_LT(sine, 0.02F * cosine) << where;
    }

    /// How exact a depth is at all: a triangle that is seen edge-on lies anywhere along the ray.
    [[nodiscard]] float depth_rounding(std::uint32_t triangle, const Frame& frame, const kernel::Ray& ray) const {
        const kernel::Triangle& t = scene_.triangles[triangle];
        const kernel::vec3 a = scene_.positions[t.p0] - frame.params.camera.eye;
        const kernel::vec3 b = scene_.positions[t.p1] - scene_.positions[t.p0];
        const kernel::vec3 c = scene_.positions[t.p2] - scene_.positions[t.p0];
        const float along = std::abs(kernel::dot(kernel::cross(b, c), ray.direction));
        return 2e-6F * kernel::length(a) * kernel::length(b) * kernel::length(c) / along;
    }

    struct Raster {
        int lanes;
        std::unique_ptr<FrameRaster> raster;
    };
    const RenderScene& scene_;
    embree::Device device_;
    EmbreeScene embree_;
    std::vector<Raster> rasters_;
};

/// From many places around and within. At most `doubtful` of the pixels may be left to tracing, else the test says
/// little.
void expect_same(TestScene& test, float size, double doubtful, int cameras = 12, bool some_hits = true) {
    test.finish();
    Comparer comparer(test.scene);
    Random random(3);
    Tally tally;
    for (int i = 0; i < cameras && !testing::Test::HasFailure(); ++i) {
        const Vec3 eye = random.point(i % 3 == 0 ? 0.5F * size : i % 3 == 1 ? 2.5F * size : 20 * size);
        const float view = i % 3 == 2 ? 0.06F : i % 4 == 0 ? 1.5F : 0.5F;
        const kernel::Camera camera = camera_from(eye, random.point(0.3F * size), random.point(1), view);
        Frame frame = frame_of(test.scene, camera, i % 5 == 4 ? 2.5F * size : INFINITY);
        frame.params.sampling.pattern = i % 7 < 4 ? kernel::SAMPLES_R2 : static_cast<std::uint32_t>(i % 7) - 3;
        frame.params.sampling.cells = frame.params.sampling.pattern == kernel::SAMPLES_SOBOL ? 0 : 3;
        comparer.compare(frame, static_cast<std::uint32_t>(i % 4), tally);
    }
    const double all = tally.hits + tally.misses + tally.unknown;
    if (some_hits) {
        EXPECT_GT(tally.hits, 0.01 * all);
    }
    EXPECT_LE(tally.unknown, doubtful * all) << tally.hits << " hits, " << tally.misses << " misses";
    testing::Test::RecordProperty("unknown_share", std::to_string(tally.unknown / all));
}

// Catches wrong edges, orders and bounds in general.
TEST(Raster, TrianglesOfAllSizes) {
    TestScene test;
    Random random(1);
    for (int i = 0; i < 400; ++i) {
        const Vec3 at = random.point(2);
        const float size = i % 4 == 0 ? 1.5F : i % 4 == 1 ? 0.3F : i % 4 == 2 ? 0.03F : 0.003F;
        test.add_triangle(at + random.point(size), at + random.point(size), at + random.point(size));
        if (i % 100 == 99) test.end_mesh();
    }
    expect_same(test, 2, 0.02);
}

// Catches gaps at shared edges and pixels that fall between small triangles.
TEST(Raster, FineMeshes) {
    TestScene test;
    test.add_ball({0, 0, 0}, 1, 60, 0.2F);
    test.add_ball({0.9F, 0.4F, 0}, 0.7F, 12, 0.1F);
    expect_same(test, 1, 0.08);
}

// Catches rooms and floors that reach behind the eye, and sides that are seen edge-on from within their planes.
TEST(Raster, RoomsAroundTheEye) {
    TestScene test;
    test.add_quad({-50, -50, -1}, {100, 0, 0}, {0, 100, 0});
    test.add_quad({-3, -3, -1}, {0, 6, 0}, {0, 0, 4});
    test.add_quad({3, -3, -1}, {0, 6, 0}, {0, 0, 4});
    test.add_quad({-3, 3, -1}, {6, 0, 0}, {0, 0, 4});
    test.end_mesh();
    for (int i = 0; i < 5; ++i) test.add_quad({-0.5F, 1.0F + 0.3F * static_cast<float>(i), 0}, {1, 0, 0}, {0, 0, 1});
    test.end_mesh();
    test.finish();
    Comparer comparer(test.scene);
    Tally tally;
    for (const Vec3 eye : {Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{-70, 0, -1}, Vec3{0.5F, -2, 0.3F}, Vec3{-3, -8, 0}})
        for (const Vec3 way : {Vec3{0, 1, 0}, Vec3{1, 0.1F, 0}, Vec3{0, 0.5F, -1}, Vec3{-1, -1, 0.05F}})
            for (const float view : {0.4F, 2.0F})
                comparer.compare(frame_of(test.scene, camera_from(eye, eye + way, {0, 0, 1}, view)), 0, tally);
    EXPECT_GT(tally.hits, 10 * tally.unknown);
}

// Catches faces at one place, of which rounding chooses: those are for tracing to decide.
TEST(Raster, FacesAtOnePlace) {
    TestScene test;
    Random random(4);
    test.add_quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    test.add_quad({-0.5F, -0.5F, 0}, {1, 0.1F, 0}, {-0.1F, 1, 0});
    test.add_quad({-0.2F, -0.9F, 1e-7F}, {0.5F, 0, 0}, {0, 1.8F, 0});
    for (int i = 0; i < 30; ++i) {
        const Vec3 a = random.point(1), b = random.point(1), c = random.point(1);
        test.add_triangle(a, b, c);
        if (i % 2 == 0) test.add_triangle(b, c, a);
    }
    test.end_mesh();
    expect_same(test, 1, 0.6);
}

// Catches needles, whose corners reach out farther than rounding elsewhere, and triangles without area.
TEST(Raster, NeedlesAndPoints) {
    TestScene test;
    Random random(5);
    for (int i = 0; i < 600; ++i) {
        const Vec3 a = random.point(1), way = random.point(1);
        const float thin = std::pow(10.0F, random.within(-8, -2));
        test.add_triangle(a, a + way, a + way * random.within(0, 1) + random.point(thin));
    }
    for (int i = 0; i < 20; ++i) {
        const Vec3 a = random.point(1);
        test.add_triangle(a, a, i % 2 == 0 ? a : random.point(1));
    }
    test.add_triangle({NAN, 0, 0}, {1, 0, 0}, {0, 1, 0});
    test.add_triangle({INFINITY, 0, 0}, {1, 0, 0}, {0, 1, 0});
    test.end_mesh();
    expect_same(test, 1, 0.08, 24, false);
}

// Catches bounds on rounding that only hold near the origin, or at one scale.
TEST(Raster, FarFromTheOriginAndAtAllScales) {
    for (const float scale : {1e-5F, 1.0F, 1e6F}) {
        TestScene test;
        Random random(6);
        const Vec3 middle = Vec3{300, -200, 100} * scale;
        for (int i = 0; i < 200; ++i) {
            const Vec3 at = middle + random.point(scale);
            test.add_triangle(at + random.point(0.3F * scale), at + random.point(0.3F * scale),
                              at + random.point(0.3F * scale));
        }
        test.end_mesh();
        test.finish();
        Comparer comparer(test.scene);
        Tally tally;
        for (int i = 0; i < 6; ++i) {
            const Vec3 eye = middle + random.point(3 * scale);
            comparer.compare(frame_of(test.scene, camera_from(eye, middle, {0, 0, 1}, 0.4F)), 0, tally);
        }
        EXPECT_GT(tally.hits, 5 * tally.unknown) << scale;
    }
}

// Catches triangles that are taken for the nearest where a ball, something moving or a plane lies before them.
TEST(Raster, WhatIsNotRasterised) {
    TestScene test;
    test.add_ball({0, 0, 0}, 1, 20, 0.1F);
    test.add_sphere({0.8F, 0.8F, 0.8F}, 0.5F);
    Random random(8);
    for (int i = 0; i < 20; ++i) {
        const Vec3 at = random.point(0.3F);
        test.add_triangle(at + random.point(0.3F), at + random.point(0.3F), at + random.point(0.3F));
    }
    test.end_mesh(0);
    test.finish();
    Comparer comparer(test.scene);
    Tally tally;
    for (int i = 0; i < 12; ++i) {
        Frame frame = frame_of(test.scene, camera_from(random.point(4), {0, 0, 0}, {0, 0, 1}, 0.5F));
        const Vec3 t = random.point(1.5F);
        frame.instances[0] = {{0, 1, 0},  {-1, 0, 0}, {0, 0, 1}, {t.x, t.y, t.z},
                              {0, -1, 0}, {1, 0, 0},  {0, 0, 1}, {-t.y, t.x, -t.z}};
        comparer.compare(frame, 0, tally);
    }
    EXPECT_GT(tally.hits, 0);
    EXPECT_GT(tally.misses, 0);
}

// Catches tiles that depend on how a scene's triangles are shared out to threads.
TEST(Raster, ManyRuns) {
    TestScene test;
    for (int i = 0; i < 3; ++i) test.add_ball({0.5F * static_cast<float>(i), 0, 0}, 1, 80, 0.3F);
    expect_same(test, 1, 0.15, 4);
}

}  // namespace
}  // namespace sundog::cpu::raster
