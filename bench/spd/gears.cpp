// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "spd/builder.h"
#include "spd/spd.h"

namespace sundog::bench {
namespace {

constexpr int kSide = 4;    // gears along each edge of the cube
constexpr int kTeeth = 24;  // of six sides each

/// A gear's outline around the origin, six corners a tooth: up the flank, over the top, down and along the foot.
std::vector<Vec3> outline(float radius, float turn) {
    constexpr std::array<float, 6> at{0.05F, 0.2F, 0.3F, 0.4F, 0.55F, 0.8F};
    constexpr std::array<float, 6> height{-0.04F, 0.02F, 0.05F, 0.02F, -0.04F, -0.05F};
    std::vector<Vec3> corners;
    for (int tooth = 0; tooth < kTeeth; ++tooth)
        for (std::size_t i = 0; i < at.size(); ++i) {
            const float angle = 2 * kPi * (static_cast<float>(tooth) + at[i] + turn) / kTeeth;
            const float r = radius * (1 + height[i]);
            corners.push_back({r * std::cos(angle), r * std::sin(angle), 0});
        }
    return corners;
}

scene::Mesh gear(Vec3 center, float radius, float thickness, float turn, std::uint32_t material) {
    scene::Mesh mesh;
    const std::vector<Vec3> corners = outline(radius, turn);
    const Vec3 up{0, 0, thickness / 2};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = center + corners[i], b = center + corners[(i + 1) % corners.size()];
        add_triangle(mesh, center + up, a + up, b + up, material);
        add_triangle(mesh, center - up, b - up, a - up, material);
        add_triangle(mesh, a - up, b - up, b + up, material);
        add_triangle(mesh, a - up, b + up, a + up, material);
    }
    return mesh;
}

}  // namespace

scene::Scene spd_gears() {
    SceneBuilder scene("gears");
    scene.eye({-1.1F, -2.1F, 2.6F}, {0, 0, 0});
    scene.light({2, 4, 4}, 0.45F).light({-2, 4, 3}, 0.45F).light({2, -2.5F, 2.5F}, 0.45F).light({-1, -4, 2}, 0.45F);
    const std::uint32_t floor = scene.material({1, 0.85F, 0.7F}, 0.4F);
    const std::array<std::uint32_t, 2> metals{scene.material({0.9F, 0.6F, 0.3F}, 0.2F),
                                              scene.material({0.5F, 0.6F, 0.7F}, 0.2F)};
    scene.ground(8, -1.05F, floor);
    const float step = 2.0F / kSide;
    for (int x = 0; x < kSide; ++x)
        for (int y = 0; y < kSide; ++y)
            for (int z = 0; z < kSide; ++z) {
                const auto place = [&](int i) { return -1 + step * (static_cast<float>(i) + 0.5F); };
                // A neighbour's teeth stand where there are gaps.
                const bool odd = (x + y) % 2 == 1;
                scene.mesh(gear({place(x), place(y), place(z)}, step / 2, step / 2, odd ? 0.5F : 0.0F,
                                metals[static_cast<std::size_t>((x + y + z) % 2)]));
            }
    return scene.take();
}

}  // namespace sundog::bench
