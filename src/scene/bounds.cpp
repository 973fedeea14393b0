// SPDX-License-Identifier: Apache-2.0
#include "scene/bounds.h"

namespace sundog::scene {
namespace {

struct BoundsOf {
    Bounds3 operator()(const Boxed<Mesh>& boxed) const {
        const Mesh& mesh = *boxed;
        Bounds3 bounds;
        for (const Mesh::Triangle& triangle : mesh.triangles)
            for (const std::uint32_t i : triangle.position) bounds.include(mesh.positions[i]);
        return bounds;
    }
    Bounds3 operator()(const Sphere& s) const {
        const Vec3 reach{s.radius, s.radius, s.radius};
        return {s.center - reach, s.center + reach};
    }
    Bounds3 operator()(const Box& box) const { return {box.lower, box.upper}; }
    Bounds3 operator()(const Plane&) const { return {}; }
    Bounds3 operator()(const std::shared_ptr<const Solid>&) const { return {}; }
};

}  // namespace

Bounds3 bounds_of(const Object& object) { return std::visit(BoundsOf{}, object.shape); }

Bounds3 bounds_of(const Scene& scene) {
    Bounds3 bounds;
    for (const Object& object : scene.objects) {
        const Bounds3 own = bounds_of(object);
        bounds.include(object.node_motion ? transformed(transform_at(object, 0), own) : own);
    }
    return bounds;
}

}  // namespace sundog::scene
