// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/raster/covers.h"

#include <algorithm>
#include <cmath>

#include "device/accel/primitive_bounds.h"

namespace sundog::cpu::raster {
namespace {

Vec3 host(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

Vec3 placed(const kernel::Instance& i, Vec3 p) {
    return host(i.world_from_object_x) * p.x + host(i.world_from_object_y) * p.y + host(i.world_from_object_z) * p.z +
           host(i.world_from_object_t);
}

/// Of a box's corners in the picture, a pixel wider on all sides; the whole picture where the box reaches the plane of
/// the eye.
PixelRect rect_of(const std::array<Vec3, 8>& corners, const EyeView& view) {
    const PixelRect all{0, 0, static_cast<int>(view.width), static_cast<int>(view.height)};
    float x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    bool before = false, behind = false;
    for (const Vec3& corner : corners) {
        const Vec3 v = corner - host(view.eye);
        const float ahead = dot(v, host(view.forward));
        if (!(std::abs(ahead) > 0.01F * length(v) * length(host(view.forward)))) return all;
        (ahead > 0 ? before : behind) = true;
        const float x = (dot(v, host(view.right)) / ahead + 1) * 0.5F * view.width;
        const float y = (1 - dot(v, host(view.up)) / ahead) * 0.5F * view.height;
        x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
    if (!before) return {};
    if (behind) return all;
    const auto pixel = [](float at, float end) { return static_cast<int>(std::clamp(std::floor(at), 0.0F, end)); };
    return {pixel(x0 - 1, view.width), pixel(y0 - 1, view.height), pixel(x1 + 2, view.width),
            pixel(y1 + 2, view.height)};
}

}  // namespace

TracedThings::TracedThings(const RenderScene& scene) {
    std::vector<const PlacedSolid*> solid_of(scene.geometries.size());
    for (const PlacedSolid& solid : scene.solids) solid_of[solid.geometry] = &solid;
    for (std::uint32_t i = 0; i < scene.geometries.size(); ++i) {
        const kernel::Geometry& g = scene.geometries[i];
        const bool rasterised = g.kind == kernel::GEOMETRY_TRIANGLES && g.instance == kernel::NONE;
        if (g.primitive_count == 0 || g.kind == kernel::GEOMETRY_PLANE || rasterised) continue;
        if (g.kind == kernel::GEOMETRY_SOLID) {
            const Bounds3 all{{-accel::kFarthest, -accel::kFarthest, -accel::kFarthest},
                              {accel::kFarthest, accel::kFarthest, accel::kFarthest}};
            things_.push_back(
                {solid_of[i] == nullptr ? all : accel::roomy(accel::bounds_of_solid(*solid_of[i]->solid)), g.instance});
            continue;
        }
        // What moves as one is traced as one; spheres and boxes stand for themselves.
        Bounds3 together;
        for (std::uint32_t k = 0; k < g.primitive_count; ++k) {
            const Bounds3 one = accel::bounds_of(scene, g, k);
            if (one.lower.x <= one.upper.x) together.include(one.lower), together.include(one.upper);
        }
        if (together.lower.x <= together.upper.x) things_.push_back({accel::roomy(together), g.instance});
    }
}

std::vector<PixelRect> TracedThings::rects(const Frame& frame, const EyeView& view) const {
    std::vector<PixelRect> rects;
    for (const Thing& thing : things_) {
        std::array<Vec3, 8> corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Bounds3& b = thing.bounds;
            const Vec3 corner{k & 1U ? b.upper.x : b.lower.x, k & 2U ? b.upper.y : b.lower.y,
                              k & 4U ? b.upper.z : b.lower.z};
            corners[k] = thing.instance == kernel::NONE ? corner : placed(frame.instances[thing.instance], corner);
        }
        const PixelRect rect = rect_of(corners, view);
        if (rect.width() > 0 && rect.height() > 0) rects.push_back(rect);
    }
    return rects;
}

}  // namespace sundog::cpu::raster
