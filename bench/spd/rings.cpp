// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "spd/builder.h"
#include "spd/spd.h"

namespace sundog::bench {
namespace {

constexpr int kLayers = 7;
constexpr float kRadius = 0.93F, kTube = 0.074F;

/// Five balls and five tubes around an axis.
void add_pentagon(SceneBuilder& scene, Vec3 center, Vec3 axis, std::uint32_t material) {
    const Vec3 u = perpendicular_to(axis), v = cross(axis, u);
    const auto corner = [&](int i) {
        const float angle = 2 * kPi * static_cast<float>(i % 5) / 5;
        return center + (u * std::cos(angle) + v * std::sin(angle)) * kRadius;
    };
    for (int i = 0; i < 5; ++i) {
        scene.cone(corner(i), kTube, corner(i + 1), kTube, material);
        scene.sphere(corner(i), kTube, material);
    }
}

/// A pentagon around each of a dodecahedron's six axes through the middles of its faces.
void add_ring(SceneBuilder& scene, Vec3 center, std::uint32_t material) {
    const float golden = (1 + std::sqrt(5.0F)) / 2;
    for (const Vec3 axis : {Vec3{0, 1, golden}, Vec3{0, -1, golden}, Vec3{1, golden, 0}, Vec3{-1, golden, 0},
                            Vec3{golden, 0, 1}, Vec3{golden, 0, -1}})
        add_pentagon(scene, center, normalize(axis), material);
}

}  // namespace

scene::Scene spd_rings() {
    SceneBuilder scene("rings");
    scene.eye({-1, -2.6F, 0.5F}, {-1, 0, 0.5F});
    scene.light({3, -2.6F, 3}, 0.6F).light({-4, -2.6F, 1}, 0.6F).light({2, -2.6F, -4}, 0.6F);
    const std::uint32_t wall = scene.material({1, 1, 1});
    const std::uint32_t metal = scene.material({1, 0.85F, 0.7F}, 0.3F);
    scene::Mesh behind;
    const float y = 2.6F * (kLayers + 1), s = 2.6F * kLayers;
    add_triangle(behind, {-s, y, -s}, {s, y, -s}, {s, y, s}, wall);
    add_triangle(behind, {-s, y, -s}, {s, y, s}, {-s, y, s}, wall);
    scene.mesh(std::move(behind));
    for (int layer = 1; layer <= kLayers; ++layer)
        for (int x = 0; x < layer; ++x)
            for (int z = 0; z < layer; ++z) {
                const auto place = [&](int i) {
                    return 2.0F * (static_cast<float>(i) - 0.5F * static_cast<float>(layer - 1));
                };
                add_ring(scene, {place(x) - 1, 2.6F * static_cast<float>(layer), place(z) + 0.5F}, metal);
            }
    return scene.take();
}

}  // namespace sundog::bench
