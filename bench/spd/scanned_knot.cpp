// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "spd/builder.h"
#include "spd/spd.h"

namespace sundog::bench {
namespace {

/// A trefoil knot, once around for s from 0 to 1.
Vec3 knot(float s) {
    const float t = 2 * kPi * s;
    return {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
}

/// Ridges in several sizes, as tools leave them.
float relief(float s, float angle) {
    float height = 0, size = 0.06F;
    for (int octave = 1; octave <= 32; octave *= 2, size *= 0.5F) {
        const auto k = static_cast<float>(octave);
        height += size * std::sin(2 * kPi * 9 * k * s + 2 * std::sin(2 * angle)) * std::cos(k * 3 * angle + k);
    }
    return height;
}

}  // namespace

scene::Scene scanned_knot(int around, int along) {
    SceneBuilder scene("scan");
    scene.eye({0, -6.5F, 6}, {0, 0, 0});
    scene.light({6, -4, 9}, 0.8F).light({-8, -3, 5}, 0.4F);
    const std::uint32_t stone = scene.material({0.75F, 0.7F, 0.62F});
    const std::uint32_t floor = scene.material({0.4F, 0.42F, 0.45F});
    scene.ground(12, -1.75F, floor);
    scene::Mesh mesh;
    SteadyRandom random;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            // A scanner's points don't lie in rows.
            const float s = (static_cast<float>(i) + 0.6F * random.next()) / static_cast<float>(along);
            const float angle = 2 * kPi * (static_cast<float>(j) + 0.6F * random.next()) / static_cast<float>(around);
            const Vec3 ahead = normalize(knot(s + 1e-3F) - knot(s - 1e-3F));
            const Vec3 u = normalize(cross(ahead, {0, 0, 1})), v = cross(u, ahead);
            const float radius = 0.55F + relief(s, angle);
            mesh.positions.push_back(knot(s) + (u * std::cos(angle) + v * std::sin(angle)) * radius);
        }
    const auto index = [&](int i, int j) { return static_cast<std::uint32_t>((i % along) * around + j % around); };
    constexpr std::uint32_t none = scene::kNone;
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({{a, b, c}, {none, none, none}, {none, none, none}, stone});
    };
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            triangle(index(i, j), index(i + 1, j), index(i + 1, j + 1));
            triangle(index(i, j), index(i + 1, j + 1), index(i, j + 1));
        }
    scene.mesh(std::move(mesh));
    return scene.take();
}

}  // namespace sundog::bench
