// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "spd/builder.h"
#include "spd/spd.h"

namespace sundog::bench {
namespace {

constexpr int kLevels = 5;

using Corners = std::array<Vec3, 4>;

/// Sierpinski's tetrahedron: four half as large, in the corners.
void add_tetrahedra(scene::Mesh& mesh, const Corners& c, int levels, std::uint32_t material) {
    if (levels > 0) {
        for (const Vec3 kept : c) {
            Corners half;
            for (std::size_t i = 0; i < 4; ++i) half[i] = (c[i] + kept) * 0.5F;
            add_tetrahedra(mesh, half, levels - 1, material);
        }
        return;
    }
    add_triangle(mesh, c[0], c[1], c[2], material);
    add_triangle(mesh, c[0], c[3], c[1], material);
    add_triangle(mesh, c[0], c[2], c[3], material);
    add_triangle(mesh, c[1], c[3], c[2], material);
}

}  // namespace

scene::Scene spd_tetra() {
    SceneBuilder scene("tetra");
    scene.eye({1.02F, -3.18F, -2.17F}, {0, 0, 0.21F}, {-0.83F, -0.43F, 0.37F});
    scene.light({2, -18, -5}, 1);
    const std::uint32_t red = scene.material({1, 0.2F, 0.2F});
    scene::Mesh mesh;
    add_tetrahedra(mesh, {{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}}, kLevels, red);
    scene.mesh(std::move(mesh));
    return scene.take();
}

}  // namespace sundog::bench
