// SPDX-License-Identifier: Apache-2.0
// Scenes for the tests of this folder.
#pragma once

#include <cmath>
#include <random>

#include "base/vec.h"
#include "device/render_scene.h"

namespace sundog::cpu::raster {

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    float within(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
    Vec3 point(float size) {
        const float x = within(-size, size), y = within(-size, size);
        return {x, y, within(-size, size)};
    }

private:
    std::mt19937 engine_;
};

/// A scene under construction, one object after the other.
struct TestScene {
    RenderScene scene;

    TestScene() { scene.materials.resize(1); }
    void add_triangle(Vec3 a, Vec3 b, Vec3 c) {
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        for (const Vec3 p : {a, b, c}) scene.positions.push_back({p.x, p.y, p.z});
        scene.triangles.push_back({first, first + 1, first + 2, 0});
    }
    void add_quad(Vec3 corner, Vec3 u, Vec3 v) {
        add_triangle(corner, corner + u, corner + u + v);
        add_triangle(corner, corner + u + v, corner + v);
    }
    void end_mesh(std::uint32_t instance = kernel::NONE) {
        std::uint32_t first = 0;
        for (const kernel::Geometry& g : scene.geometries)
            if (g.kind == kernel::GEOMETRY_TRIANGLES) first = g.first_primitive + g.primitive_count;
        scene.geometries.push_back({kernel::GEOMETRY_TRIANGLES, first,
                                    static_cast<std::uint32_t>(scene.triangles.size()) - first, instance, 0, 0, 0});
    }
    void add_sphere(Vec3 center, float radius) {
        scene.spheres.push_back({{center.x, center.y, center.z}, radius, 0});
        scene.geometries.push_back(
            {kernel::GEOMETRY_SPHERE, static_cast<std::uint32_t>(scene.spheres.size()) - 1, 1, kernel::NONE, 0, 0, 0});
    }
    /// A bumpy ball of rings * 2*rings quads with shared corners.
    void add_ball(Vec3 center, float radius, int rings, float bumps) {
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        const int around = 2 * rings;
        for (int i = 0; i <= rings; ++i)
            for (int j = 0; j < around; ++j) {
                const float a = kPi * static_cast<float>(i) / static_cast<float>(rings);
                const float b = 2 * kPi * static_cast<float>(j) / static_cast<float>(around);
                const float r = radius * (1 + bumps * std::sin(5 * a) * std::cos(7 * b));
                const Vec3 p = center + Vec3{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)} * r;
                scene.positions.push_back({p.x, p.y, p.z});
            }
        const auto at = [&](int i, int j) { return first + static_cast<std::uint32_t>(i * around + j % around); };
        for (int i = 0; i < rings; ++i)
            for (int j = 0; j < around; ++j) {
                scene.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), 0});
                scene.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1), 0});
            }
        end_mesh();
    }
    /// Arrays are never empty, and positions have a spare element.
    void finish() {
        scene.positions.push_back({0, 0, 0});
        if (scene.spheres.empty()) scene.spheres.resize(1);
        if (scene.planes.empty()) scene.planes.resize(1);
        if (scene.triangles.empty()) scene.triangles.resize(1);
    }
};

}  // namespace sundog::cpu::raster
