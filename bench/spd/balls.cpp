// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "spd/builder.h"
#include "spd/spd.h"

namespace sundog::bench {
namespace {

constexpr int kLevels = 4;

/// A ball, and nine a third of its size on it: three around its axis, near the end that points away from its parent,
/// six around the middle.
void add_balls(SceneBuilder& scene, Vec3 center, float radius, Vec3 axis, int levels, std::uint32_t material) {
    scene.sphere(center, radius, material);
    if (levels == 0) return;
    const Vec3 u = perpendicular_to(axis), v = cross(axis, u);
    for (int i = 0; i < 9; ++i) {
        const bool upper = i < 3;
        const float around = radians(static_cast<float>(upper ? 45 + 120 * i : 15 + 60 * i));
        const float height = upper ? std::sqrt(2.0F / 3.0F) : 0.0F;
        const float width = std::sqrt(1 - height * height);
        const Vec3 outwards = axis * height + u * (width * std::cos(around)) + v * (width * std::sin(around));
        add_balls(scene, center + outwards * (radius * 4 / 3), radius / 3, outwards, levels - 1, material);
    }
}

}  // namespace

scene::Scene spd_balls() {
    SceneBuilder scene("balls");
    scene.eye({2.1F, 1.3F, 1.7F}, {0, 0, 0});
    scene.light({4, 3, 2}, 0.6F).light({1, -4, 4}, 0.6F).light({-3, 1, 5}, 0.6F);
    const std::uint32_t floor = scene.material({1, 0.75F, 0.33F});
    const std::uint32_t shiny = scene.material({0.5F, 0.45F, 0.35F}, 0.5F);
    scene.ground(12, -0.5F, floor);
    add_balls(scene, {0, 0, 0}, 0.5F, {0, 0, 1}, kLevels, shiny);
    return scene.take();
}

}  // namespace sundog::bench
