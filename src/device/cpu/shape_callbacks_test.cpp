// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/shape_callbacks.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>

#include "device/cpu/test_packets.h"

namespace sundog::cpu {
namespace {

template <class Packet, unsigned N>
void compare(const RenderScene& scene, ShapeCallbacks shapes) {
    std::mt19937 random(N);
    int hits = 0;
    for (int round = 0; round < 400; ++round) {
        GeometryData data{&scene, scene.geometries[static_cast<std::size_t>(round) % scene.geometries.size()]};
        data.visible_to = round % 2 == 0 ? 3U : 2U;
        data.culling = round % 3 == 0;
        const unsigned primitive = static_cast<unsigned>(round / 4) % data.geometry.primitive_count;
        const Rays<Packet, N> rays(random, Aim::anywhere);
        Rays<Packet, N> together = rays, alone = rays;
        embree::Context context = embree::make_context();
        const auto ask = [&](Rays<Packet, N>& some, RTCIntersectFunctionN function) {
            RTCIntersectFunctionNArguments args{};
            args.valid = some.valid.data();
            args.geometryUserPtr = &data;
            args.primID = primitive;
            args.context = &context;
            args.rayhit = reinterpret_cast<RTCRayHitN*>(&some.packet);
            args.N = N;
            args.geomID = 4;
            function(&args);
        };
        ask(together, shapes.intersect);
        ask(alone, intersect_shapes);
        ASSERT_EQ(std::memcmp(&together.packet, &alone.packet, sizeof together.packet), 0) << N << ' ' << round;
        for (unsigned i = 0; i < N; ++i) hits += together.packet.hit.geomID[i] == 4 ? 1 : 0;

        const auto ask_any = [&](Rays<Packet, N>& some, RTCOccludedFunctionN function) {
            RTCOccludedFunctionNArguments args{};
            args.valid = some.valid.data();
            args.geometryUserPtr = &data;
            args.primID = primitive;
            args.context = &context;
            args.ray = reinterpret_cast<RTCRayN*>(&some.packet.ray);
            args.N = N;
            args.geomID = 4;
            function(&args);
        };
        together = alone = rays;
        ask_any(together, shapes.occluded);
        ask_any(alone, occluded_by_shapes);
        ASSERT_EQ(std::memcmp(&together.packet, &alone.packet, sizeof together.packet), 0) << N << ' ' << round;
    }
    EXPECT_GT(hits, 25 * static_cast<int>(N));
}

// Catches lanes that answer otherwise together than alone, those that don't ask and are written to, shapes that they
// may not see, culled backs, and spheres so large that they are found in double.
TEST(ShapeCallbacks, PacketsGiveTheBitsOfSingleRays) {
    RenderScene scene;
    scene.materials.resize(2);
    scene.materials[1].flags = kernel::MATERIAL_TRANSPARENT;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const auto f = static_cast<float>(i);
        kernel::Sphere sphere{};
        sphere.center = {0.3F * f - 1, 0.2F, -0.1F * f};
        sphere.radius = i == 7 ? 1500.0F : 0.4F + 0.1F * f;
        sphere.material = i % 2;
        scene.spheres.push_back(sphere);
        kernel::Box box{};
        box.lower = {-0.2F * f, -0.5F, -1};
        box.upper = {0.1F * f + 0.1F, 0.5F, f};
        box.material = i % 2;
        scene.boxes.push_back(box);
    }
    for (const std::uint32_t kind : {kernel::GEOMETRY_SPHERE, kernel::GEOMETRY_BOX}) {
        kernel::Geometry geometry{};
        geometry.kind = kind;
        geometry.primitive_count = 8;
        scene.geometries.push_back(geometry);
    }
    compare<RTCRayHit4, 4>(scene, {intersect_shapes_4, occluded_by_shapes_4, nullptr, nullptr});
    if (__builtin_cpu_supports("avx2"))
        compare<RTCRayHit8, 8>(scene, {intersect_shapes_8, occluded_by_shapes_8, nullptr, nullptr});
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512vl"))
        compare<RTCRayHit16, 16>(scene, {intersect_shapes_16, occluded_by_shapes_16, nullptr, nullptr});
}

}  // namespace
}  // namespace sundog::cpu
