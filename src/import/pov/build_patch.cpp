// SPDX-License-Identifier: Apache-2.0
// Bicubic patches as smooth triangles (POV-Ray reference, section 3.4.5.2.1 "Bicubic Patch").
#include <algorithm>
#include <array>
#include <cmath>

#include "import/pov/build_shape.h"

namespace sundog::pov {
namespace {

using Controls = std::array<std::array<Vec3d, 4>, 4>;  // [v][u]

/// Weights of the four control points, and of the derivative (Bernstein polynomials of degree 3).
std::array<double, 4> weights(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}
std::array<double, 4> slopes(double t) {
    const double s = 1 - t;
    return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Vec3d blend(const Controls& points, const std::array<double, 4>& along_u, const std::array<double, 4>& along_v) {
    Vec3d sum;
    for (std::size_t v = 0; v < 4; ++v)
        for (std::size_t u = 0; u < 4; ++u) sum += points[v][u] * (along_u[u] * along_v[v]);
    return sum;
}

/// The unit normal. Where a side of the patch has shrunk to a point, that of a place nearby.
Vec3d normal_at(const Controls& points, double u, double v) {
    for (const double inwards : {0.0, 1e-3, 1e-2}) {
        const double nu = u + (0.5 - u) * inwards;
        const double nv = v + (0.5 - v) * inwards;
        const Vec3d n = cross(blend(points, slopes(nu), weights(nv)), blend(points, weights(nu), slopes(nv)));
        if (length(n) > 1e-12) return normalize(n);
    }
    return {};
}

}  // namespace

NodeShape read_bicubic_patch(ItemReader& items) {
    int u_steps = 0;
    int v_steps = 0;
    std::array<std::array<double, 2>, 4> corner_uvs{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    bool has_uvs = false;
    constexpr int kMostSteps = 1000;
    while (const std::optional<Keyword> keyword = items.peek_keyword()) {
        items.skip();
        if (*keyword == Keyword::type) items.integer("a type", 0, 4);
        else if (*keyword == Keyword::flatness) items.number("a flatness");
        else if (*keyword == Keyword::u_steps) u_steps = items.integer("a number of steps", 0, kMostSteps);
        else if (*keyword == Keyword::v_steps) v_steps = items.integer("a number of steps", 0, kMostSteps);
        else if (*keyword == Keyword::uv_vectors) {
            has_uvs = true;
            for (auto& uv : corner_uvs) uv = items.vector2("the uv coordinates of a corner");
        } else {
            items.fail("'" + std::string(spelling(*keyword)) + "' has no place before the points of a bicubic_patch",
                       "expected type, flatness, u_steps, v_steps or 16 points");
        }
    }
    Controls points{};
    for (auto& row : points)
        for (Vec3d& point : row) point = items.vector("one of the 16 points");

    // POV-Ray halves a patch up to so many times; more than 64 parts a side can't be seen.
    constexpr int kMostHalvings = 6;
    const int columns = 1 << std::clamp(u_steps, 2, kMostHalvings);
    const int rows = 1 << std::clamp(v_steps, 2, kMostHalvings);
    auto mesh = std::make_shared<NodeMesh>();
    scene::SolidMesh& out = mesh->triangles;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const double u = static_cast<double>(i) / columns;
            const double v = static_cast<double>(j) / rows;
            out.positions.push_back(to_float(blend(points, weights(u), weights(v))));
            out.normals.push_back(to_float(normal_at(points, u, v)));
            if (!has_uvs) continue;
            std::array<double, 2> uv{};
            for (std::size_t k = 0; k < 2; ++k)
                uv[k] = (1 - v) * ((1 - u) * corner_uvs[0][k] + u * corner_uvs[1][k]) +
                        v * ((1 - u) * corner_uvs[3][k] + u * corner_uvs[2][k]);
            out.uvs.push_back({static_cast<float>(uv[0]), static_cast<float>(uv[1])});
        }
    }
    constexpr std::uint32_t kNone = scene::SolidMesh::kNoIndex;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const std::array<std::uint32_t, 3> corners{a, b, c};
        const std::array<std::uint32_t, 3> none{kNone, kNone, kNone};
        out.triangles.push_back({corners, corners, has_uvs ? corners : none, kNone});
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i);
            const std::uint32_t b = a + 1;
            const std::uint32_t c = a + static_cast<std::uint32_t>(columns) + 1;
            add(a, b, c + 1);
            add(a, c + 1, c);
        }
    }
    return std::shared_ptr<const NodeMesh>(std::move(mesh));
}

}  // namespace sundog::pov
