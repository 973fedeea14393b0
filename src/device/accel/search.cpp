// SPDX-License-Identifier: Apache-2.0
#include "device/accel/search.h"

#include <algorithm>
#include <optional>

#include "device/accel/primitive_tests.h"
#include "kernel/shapes/triangle.h"
#include "solids/compiled_solid.h"

namespace sundog::accel {
namespace {

Vec3 to_host(kernel::real3 v) { return {v.x, v.y, v.z}; }

bool is_opaque(const RenderScene& scene, std::uint32_t material) {
    return (scene.materials[material].flags & kernel::MATERIAL_TRANSPARENT) == 0;
}

}  // namespace

Search::Search(const Primitives& primitives, const kernel::Ray& ray, Question question, Nearest& nearest, Steps& steps)
    : primitives_(primitives),
      ray_(ray),
      line_(ray.origin, ray.direction),
      question_(question),
      nearest_(nearest),
      steps_(steps) {}

void Search::test(const Item& item, const Bounds3& bounds) {
    ++steps_.tests;
    const Interval inside = clip(bounds, line_, {ray_.t_min, ray_.t_max});
    if (!inside.empty() && inside.enter <= reach()) test_within(item, inside);
}

void Search::test_endless(const Item& item) {
    ++steps_.tests;
    test_within(item, {ray_.t_min, ray_.t_max});
}

void Search::test_within(const Item& item, Interval inside) {
    const kernel::Geometry& geometry = primitives_.scene().geometries[item.geometry];
    if (blocked_ || (question_.kind & geometry.hidden_from) != 0) return;
    Found found;
    const bool hit = geometry.kind == kernel::GEOMETRY_SOLID ? hit_solid(item, found) : hit_primitive(item, found);
    if (!hit) return;
    if (question_.any) {
        blocked_ = true;
        return;
    }
    found.t = std::clamp(found.t, inside.enter, inside.leave);
    found.geometry = item.geometry;
    nearest_.enter(found);
}

bool Search::hit_primitive(const Item& item, Found& found) const {
    const RenderScene& scene = primitives_.scene();
    const kernel::Geometry& geometry = scene.geometries[item.geometry];
    const bool culls = question_.culls && is_opaque(scene, material_of(scene, geometry, item.primitive));
    kernel::real3 normal;
    found.primitive = item.primitive;
    if (geometry.kind != kernel::GEOMETRY_TRIANGLES) {
        if (!hit_shape(scene, geometry, item.primitive, ray_, culls, found.t, normal)) return false;
        found.leaves = dot(normal, ray_.direction) > 0;
    } else {
        const kernel::Triangle& t = scene.triangles[geometry.first_primitive + item.primitive];
        if (!intersect_triangle(ray_, scene.positions[t.p0], scene.positions[t.p1], scene.positions[t.p2], found.t,
                                found.u, found.v, normal))
            return false;
        const bool one_sided = question_.one_sided && (question_.kind & kernel::RAY_CAMERA) != 0 &&
                               (scene.materials[t.material].flags & kernel::MATERIAL_ONE_SIDED) != 0;
        if ((culls || one_sided) && dot(normal, ray_.direction) >= 0) return false;
    }
    found.normal = to_host(normal);
    return true;
}

/// The range doesn't shrink with what was found before: where roots are searched decides their last bits.
bool Search::hit_solid(const Item& item, Found& found) const {
    const RenderScene& scene = primitives_.scene();
    const solids::CompiledSolid& solid = *solid_of(scene, item.geometry);
    const solids::Ray ray{{ray_.origin.x, ray_.origin.y, ray_.origin.z},
                          {ray_.direction.x, ray_.direction.y, ray_.direction.z}};
    solids::Range range{ray_.t_min, ray_.t_max};
    if (question_.any && !question_.culls) return solid.any(ray, range);
    std::optional<solids::Hit> hit = solid.nearest(ray, range);
    while (hit && question_.culls && dot(hit->normal, ray.direction) >= 0 && is_opaque(scene, hit->material)) {
        range.lower = hit->t;
        hit = solid.nearest(ray, range);
    }
    if (!hit) return false;
    found.t = static_cast<float>(hit->t);
    found.u = static_cast<float>(hit->u);
    found.v = static_cast<float>(hit->v);
    found.primitive = hit->material;
    found.normal = {static_cast<float>(hit->normal.x), static_cast<float>(hit->normal.y),
                    static_cast<float>(hit->normal.z)};
    found.leaves = dot(hit->normal, ray.direction) > 0;
    return true;
}

}  // namespace sundog::accel
