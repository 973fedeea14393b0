// SPDX-License-Identifier: Apache-2.0
#include "device/accel/primitive_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "device/accel/primitive_tests.h"
#include "solids/compiled_solid.h"

namespace sundog::accel {
namespace {

Vec3 to_host(kernel::vec3 v) { return {v.x, v.y, v.z}; }

/// The next float below (or above), so that rounding never cuts a box.
float rounded_down(double v) {
    return std::nextafter(static_cast<float>(std::clamp(v, -double{kFarthest}, double{kFarthest})),
                          -std::numeric_limits<float>::infinity());
}
float rounded_up(double v) { return -rounded_down(-v); }

}  // namespace

Bounds3 roomy(Bounds3 box) {
    const float reach = std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.lower.z),
                                  std::abs(box.upper.x), std::abs(box.upper.y), std::abs(box.upper.z)});
    const float room = 4 * kCoincident * std::min(reach, 1e6F);
    return {box.lower - Vec3{room, room, room}, box.upper + Vec3{room, room, room}};
}

Bounds3 bounds_of_solid(const solids::CompiledSolid& solid) {
    const Bounds3d b = solid.bounds();
    return {{rounded_down(b.lower.x), rounded_down(b.lower.y), rounded_down(b.lower.z)},
            {rounded_up(b.upper.x), rounded_up(b.upper.y), rounded_up(b.upper.z)}};
}

Bounds3 bounds_of(const RenderScene& scene, const kernel::Geometry& geometry, std::uint32_t primitive) {
    const std::uint32_t i = geometry.first_primitive + primitive;
    if (geometry.kind == kernel::GEOMETRY_SPHERE) {
        const kernel::Sphere& s = scene.spheres[i];
        const Vec3 center = to_host(s.center), radius{s.radius, s.radius, s.radius};
        return {center - radius, center + radius};
    }
    if (geometry.kind == kernel::GEOMETRY_BOX) return {to_host(scene.boxes[i].lower), to_host(scene.boxes[i].upper)};
    Bounds3 box;
    const kernel::Triangle& t = scene.triangles[i];
    for (const std::uint32_t corner : {t.p0, t.p1, t.p2}) {
        const Vec3 p = to_host(scene.positions[corner]);
        if (!is_finite(p)) return {};
        box.include(p);
    }
    return box;
}

}  // namespace sundog::accel
