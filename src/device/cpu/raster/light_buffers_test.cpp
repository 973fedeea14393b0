// SPDX-License-Identifier: Apache-2.0
// Light buffers against Embree: what they know of a shadow must be so.
#include "device/cpu/raster/light_buffers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "device/cpu/embree_scene.h"
#include "device/cpu/raster/test_scene.h"
#include "device/cpu/tile_kernel.h"

namespace sundog::cpu::raster {
namespace {

bool occluded(RTCScene scene, Vec3 origin, Vec3 direction, float reach) {
    RTCRay ray{};
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tfar = reach;
    ray.mask = kernel::RAY_SHADOW;
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
    return ray.tfar < 0;
}

struct Tally {
    int lit = 0, dark = 0, unknown = 0;
};

/// Asks about points all over the scene's triangles, as the kernel does, for one lamp.
void compare(const RenderScene& scene, Vec3 lamp, CellKernel kernel, Tally& tally) {
    const embree::Device device(rtcNewDevice("threads=1"));
    EmbreeScene embree(device.get(), scene);
    Frame frame;
    frame.lights.resize(1);
    frame.lights[0].place = {lamp.x, lamp.y, lamp.z};
    frame.lights[0].kind = kernel::LIGHT_LAMP;
    frame.lights[0].flags = kernel::LIGHT_SHADOWS;
    frame.instances.resize(1);
    frame.params.light_count = 1;
    frame.params.width = 640;
    frame.params.height = 480;
    embree.update(frame);
    LightBuffers buffers(scene, kernel);
    buffers.prepare(frame);
    kernel::SceneView view = view_of(scene, frame, nullptr);
    view.light_cells = buffers.cells();
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const auto number =
            static_cast<std::uint32_t>(random.within(0, 0.9999F) * static_cast<float>(scene.triangles.size()));
        const kernel::Triangle& t = scene.triangles[number];
        float u = random.within(0, 1), v = random.within(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const kernel::vec3 a = scene.positions[t.p0], b = scene.positions[t.p1], c = scene.positions[t.p2];
        const kernel::vec3 position = a * (1 - u - v) + b * u + c * v;
        kernel::vec3 normal = kernel::normalize(kernel::cross(b - a, c - a));
        const kernel::vec3 to_lamp = frame.lights[0].place - position;
        if (kernel::dot(normal, to_lamp) < 0) normal = -normal;
        // A point that was seen lies as far off its triangle as this at most.
        const float error = 2 * kernel::hit_error(position, position, kernel::length(to_lamp));
        const kernel::vec3 origin = position + normal * error;
        const kernel::vec3 way = frame.lights[0].place - origin;
        const float reach = kernel::length(way);
        bool dark = false;
        const bool unknown = kernel::unknown_shadows(view, 0, origin, number, true, dark);
        if (unknown) {
            ++tally.unknown;
            continue;
        }
        ++(dark ? tally.dark : tally.lit);
        const kernel::vec3 d = way * (1 / reach);
        EXPECT_EQ(occluded(embree.handle(), {origin.x, origin.y, origin.z}, {d.x, d.y, d.z},
                           reach - kernel::hit_error(origin, frame.lights[0].place, reach)),
                  dark)
            << "triangle " << number << " at " << u << "," << v;
        if (testing::Test::HasFailure()) return;
    }
}

std::vector<CellKernel> kernels() {
    std::vector<CellKernel> all{cell_kernel(4)};
    if (__builtin_cpu_supports("avx2")) all.push_back(cell_kernel(8));
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512vl"))
        all.push_back(cell_kernel(16));
    return all;
}

// Catches cells that know too much: of faces that others reach in front of, that don't fill them, or that lie at one
// place; sides of the cube that are turned or swapped; and lamps in corners, in faces and among needles.
TEST(LightBuffers, KnowNothingButTheTruth) {
    TestScene test;
    test.add_quad({-4, -4, -1}, {8, 0, 0}, {0, 8, 0});
    test.add_quad({-4, 4, -1}, {8, 0, 0}, {0, 0, 5});
    test.add_quad({-4, -4, 4}, {8, 0, 0}, {0, 8, 0});
    test.add_quad({-4, -4, -1}, {0, 8, 0}, {0, 0, 5});
    test.end_mesh();
    Random random(1);
    for (int i = 0; i < 30; ++i) {
        const Vec3 at = random.point(2);
        const float size = i % 2 == 0 ? 1.0F : 0.1F;
        test.add_triangle(at + random.point(size), at + random.point(size), at + random.point(size));
    }
    for (int i = 0; i < 10; ++i) {
        const Vec3 at = random.point(3), way = random.point(2);
        test.add_triangle(at, at + way, at + way * 0.5F + random.point(1e-4F));
    }
    test.add_quad({-1, -1, -1}, {1, 0, 0}, {0, 1, 0});
    test.end_mesh();
    test.add_ball({1, 1, 0.5F}, 0.6F, 8, 0.1F);
    test.add_sphere({-1.5F, 1, 0}, 0.5F);
    test.finish();
    for (const CellKernel kernel : kernels()) {
        Tally tally;
        for (const Vec3 lamp : {Vec3{0.1F, 0.2F, 3.5F}, Vec3{0, 0, 0}, Vec3{3.9F, -3.9F, 3.9F}, Vec3{-4, 0, 1},
                                Vec3{20, -30, 40}, Vec3{1, 1, 0.5F}})
            compare(test.scene, lamp, kernel, tally);
        // The floor and the walls are most of it.
        EXPECT_GT(tally.lit, tally.unknown / 20);
        EXPECT_GT(tally.dark, 100);
    }
}

// Catches light that is stopped by glass or by what casts no shadow.
TEST(LightBuffers, WhatLightPassesThrough) {
    for (const bool glass : {true, false}) {
        TestScene test;
        test.scene.materials.resize(2);
        test.scene.materials[1].flags = glass ? kernel::MATERIAL_TRANSPARENT : 0;
        test.add_quad({-4, -4, 0}, {8, 0, 0}, {0, 8, 0});
        test.end_mesh();
        test.add_quad({-1, -1, 1}, {2, 0, 0}, {0, 2, 0});
        for (std::size_t i = 2; i < 4; ++i) test.scene.triangles[i].material = 1;
        test.end_mesh();
        if (!glass) test.scene.geometries.back().hidden_from = kernel::RAY_SHADOW;
        test.finish();
        Frame frame;
        frame.lights.resize(1);
        frame.lights[0].place = {0.1F, 0, 3};
        frame.lights[0].kind = kernel::LIGHT_LAMP;
        frame.lights[0].flags = kernel::LIGHT_SHADOWS;
        frame.instances.resize(1);
        frame.params.light_count = 1;
        frame.params.width = frame.params.height = 100;
        LightBuffers buffers(test.scene, cell_kernel(4));
        buffers.prepare(frame);
        kernel::SceneView view = view_of(test.scene, frame, nullptr);
        view.light_cells = buffers.cells();
        bool dark = false;
        EXPECT_TRUE(kernel::unknown_shadows(view, 0, {0.2F, 0.1F, 0}, 0, true, dark));
        EXPECT_FALSE(dark);
        // The pane itself is lit.
        EXPECT_FALSE(kernel::unknown_shadows(view, 0, {0.2F, 0.1F, 1}, 2, true, dark) &&
                     kernel::unknown_shadows(view, 0, {0.2F, 0.1F, 1}, 3, true, dark));
        EXPECT_FALSE(dark);
    }
}

}  // namespace
}  // namespace sundog::cpu::raster
