// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>

#include "device/cpu/quick_solid.h"
#include "device/cpu/solid_callbacks.h"
#include "device/cpu/test_packets.h"

namespace sundog::cpu {
namespace {

using SolidPointer = std::shared_ptr<scene::Solid>;
using Kind = scene::SolidGroup::Kind;

template <class T>
SolidPointer make(T shape) {
    auto solid = std::make_shared<scene::Solid>();
    solid->shape = std::move(shape);
    return solid;
}
SolidPointer group(Kind kind, std::vector<std::shared_ptr<const scene::Solid>> children) {
    return make(scene::SolidGroup{kind, std::move(children)});
}
SolidPointer inverse_of(const SolidPointer& solid) {
    auto other = std::make_shared<scene::Solid>(*solid);
    other->inverted = !other->inverted;
    return other;
}
SolidPointer clipped(const SolidPointer& solid, const SolidPointer& by) {
    auto other = std::make_shared<scene::Solid>(*solid);
    other->clipped_by.push_back(by);
    return other;
}
/// Turned, stretched and moved, so that no axis stays one.
SolidPointer askew(const SolidPointer& solid, std::uint32_t material = scene::Solid::kInherited) {
    auto other = std::make_shared<scene::Solid>(*solid);
    other->parent_from_shape =
        Affine3d{{0.8, 0.5, 0.1}, {-0.6, 0.9, 0.2}, {0.1, -0.3, 1.2}, {0.1, -0.2, 0.15}} * other->parent_from_shape;
    other->material = material;
    return other;
}

std::vector<SolidPointer> solids() {
    const SolidPointer ball = make(scene::SolidSphere{{0.1, 0.2, -0.1}, 0.8});
    const SolidPointer box = make(scene::SolidBox{{-0.7, -0.6, -0.9}, {0.8, 0.5, 0.6}});
    const SolidPointer cylinder = make(scene::SolidCone{{0, -1, 0}, {0, 1.1, 0}, 0.5, 0.5});
    const SolidPointer cone = make(scene::SolidCone{{-0.2, -1, 0}, {0.4, 0.9, 0.3}, 0.9, 0.1});
    const SolidPointer tip = make(scene::SolidCone{{0, -1, 0}, {0, 1, 0}, 1.5, 0, true});
    const SolidPointer half = make(scene::HalfSpace{{0.6, 0.8, 0}, 0.1});
    const SolidPointer ellipsoid =
        make(scene::Polynomial{2, {{2, 0, 0, 1}, {0, 2, 0, 2}, {0, 0, 2, 3}, {1, 1, 0, 0.5}, {0, 0, 0, -1}}});
    const SolidPointer saddle =
        make(scene::Polynomial{2, {{2, 0, 0, 1}, {0, 2, 0, -1}, {0, 0, 2, 1}, {0, 0, 0, -0.2}}});
    const SolidPointer bowl = make(scene::Polynomial{2, {{2, 0, 0, 1}, {0, 0, 2, 1}, {0, 1, 0, -1}}});
    const SolidPointer torus = make(scene::Torus{0.9, 0.3});
    const SolidPointer disc = make(scene::Disc{{0, 0.1, 0}, {0, 1, 0}, 1, 0.3});
    const SolidPointer prism =
        make(scene::Prism{scene::SplineKind::linear, false, -0.5, 0.6, {{-1, -1}, {1, -1}, {0, 1}, {-1, -1}}, false});
    const SolidPointer lens = group(Kind::common, {ball, make(scene::SolidSphere{{0.6, 0, 0.3}, 0.9})});
    std::vector<SolidPointer> out{ball, box, cylinder, cone, tip, half, ellipsoid, saddle, bowl, torus, disc, prism};
    for (std::size_t i = 0; i < 12; ++i) out.push_back(askew(out[i]));
    out.push_back(group(Kind::common, {box, inverse_of(cylinder), askew(inverse_of(ball), 3)}));
    out.push_back(
        group(Kind::common, {askew(box), half, inverse_of(cone), inverse_of(make(scene::SolidSphere{{}, 0.3}))}));
    out.push_back(group(Kind::common, {askew(saddle), box}));
    out.push_back(group(Kind::common, {ball, disc}));
    out.push_back(group(Kind::common, {box, torus}));
    out.push_back(
        group(Kind::common, {box, make(scene::SolidBox{{-0.7, -0.2, -0.5}, {0.3, 0.5, 1}})}));  // shared faces
    out.push_back(group(Kind::merged, {askew(lens, 2), cylinder, tip}));
    out.push_back(group(Kind::combined, {lens, askew(cylinder), ellipsoid}));
    out.push_back(group(Kind::combined, {group(Kind::common, {box, inverse_of(ball)}), torus}));
    out.push_back(group(Kind::merged, {inverse_of(lens), make(scene::SolidSphere{{0.6, 0, 0.3}, 0.2})}));
    out.push_back(inverse_of(group(Kind::merged, {box, askew(cone)})));
    out.push_back(clipped(ball, box));
    out.push_back(clipped(group(Kind::combined, {cylinder, half}), askew(box)));
    out.push_back(clipped(torus, half));
    out.push_back(clipped(askew(cone), inverse_of(ball)));
    out.push_back(clipped(saddle, group(Kind::common, {ball, half})));
    return out;
}

struct Callbacks {
    RTCIntersectFunctionN intersect;
    RTCOccludedFunctionN occluded;
};

template <class Packet, unsigned N>
void compare(const RenderScene& scene, const solids::CompiledSolid& solid, Callbacks callbacks, std::size_t number) {
    int hits = 0;
    const QuickSolid quick(solid);
    std::mt19937 random(static_cast<unsigned>(number));
    for (int round = 0; round < 100; ++round) {
        GeometryData data{&scene, {}, &solid};
        data.quick = quick.useful() ? &quick : nullptr;
        data.visible_to = round % 2 == 0 ? 3U : 2U;
        data.culling = round % 5 == 0;
        const Rays<Packet, N> rays(random, Aim::at_the_middle);
        Rays<Packet, N> together = rays, alone = rays;
        embree::Context context = embree::make_context();
        const auto ask = [&](Rays<Packet, N>& some, RTCIntersectFunctionN function) {
            RTCIntersectFunctionNArguments args{};
            args.valid = some.valid.data();
            args.geometryUserPtr = &data;
            args.context = &context;
            args.rayhit = reinterpret_cast<RTCRayHitN*>(&some.packet);
            args.N = N;
            args.geomID = 4;
            function(&args);
        };
        ask(together, callbacks.intersect);
        ask(alone, intersect_solid);
        for (unsigned i = 0; i < N; ++i) {
            hits += alone.packet.hit.geomID[i] == 4 ? 1 : 0;
            ASSERT_EQ(together.packet.hit.geomID[i], alone.packet.hit.geomID[i]) << number << ' ' << round << ' ' << i;
            ASSERT_EQ(together.packet.hit.primID[i], alone.packet.hit.primID[i]) << number << ' ' << round << ' ' << i;
        }
        ASSERT_EQ(std::memcmp(&together.packet, &alone.packet, sizeof together.packet), 0) << number << ' ' << round;

        const auto ask_any = [&](Rays<Packet, N>& some, RTCOccludedFunctionN function) {
            RTCOccludedFunctionNArguments args{};
            args.valid = some.valid.data();
            args.geometryUserPtr = &data;
            args.context = &context;
            args.ray = reinterpret_cast<RTCRayN*>(&some.packet.ray);
            args.N = N;
            args.geomID = 4;
            function(&args);
        };
        together = alone = rays;
        ask_any(together, callbacks.occluded);
        ask_any(alone, occluded_by_solid);
        ASSERT_EQ(std::memcmp(&together.packet, &alone.packet, sizeof together.packet), 0) << number << ' ' << round;
    }
    EXPECT_GT(hits, static_cast<int>(N)) << number;
}

// Catches lanes that answer otherwise together than alone, in any way of putting shapes together: shapes without an
// end, faces that coincide, inverted and clipped parts, discs whose inside has no box, and rays along axes.
TEST(SolidPackets, GiveTheBitsOfSingleRays) {
    RenderScene scene;
    scene.materials.resize(4);
    scene.materials[2].flags = kernel::MATERIAL_TRANSPARENT;
    const std::vector<SolidPointer> all = solids();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto solid = solids::compile_solid(*all[i], 1, {}, [&](std::uint32_t) { return i % 3 == 0; });
        compare<RTCRayHit4, 4>(scene, *solid, {intersect_solid_4, occluded_by_solid_4}, i);
        if (__builtin_cpu_supports("avx2"))
            compare<RTCRayHit8, 8>(scene, *solid, {intersect_solid_8, occluded_by_solid_8}, i);
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
            __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
            compare<RTCRayHit16, 16>(scene, *solid, {intersect_solid_16, occluded_by_solid_16}, i);
    }
}

// Catches solids that are no longer told together, and would be slow without being wrong.
TEST(SolidPackets, KnowsSmallSolids) {
    for (const SolidPointer& one : solids()) {
        const auto solid = solids::compile_solid(*one, 1);
        const QuickSolid quick(*solid);
        const bool lone_box = solid->leaves().size() == 1 && std::holds_alternative<scene::Prism>(one->shape);
        EXPECT_TRUE(lone_box || quick.useful());
    }
}

}  // namespace
}  // namespace sundog::cpu
