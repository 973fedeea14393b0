// SPDX-License-Identifier: Apache-2.0
// Where eye rays hit primitives that they are taken to hit, without a search (sampling/scanline_refinement.h). Only
// units that hold a kernel for points include it.
#pragma once

#include <algorithm>
#include <array>

#include "device/cpu/packet_traversal.h"
#include "kernel/integrators/whitted.h"
#include "sampling/traced_grid.h"

namespace sundog::cpu {
namespace {

using namespace kernel;

/// Of such a radius, spheres are found in double (accel::kLargeRadius).
constexpr float kLargeSphere = 1000;

/// What a point's neighbours may be taken to see: convex shapes that a single test in float finds.
sampling::SeenPrimitive seen_primitive(const SceneView& scene, unsigned geometry, unsigned primitive) {
    if (geometry == NONE) return {};
    const Geometry& g = scene.geometries[geometry];
    if (g.kind == GEOMETRY_SOLID) return {};
    if (g.kind == GEOMETRY_SPHERE && !(scene.spheres[primitive].radius < kLargeSphere)) return {};
    return {geometry + 1, primitive};
}

/// `ray` in the space of moving objects, in the lanes that are of one.
Ray in_object_space(const SceneView& scene, const Ray& ray, word geometry, mask alive) {
    const word instance = FIELD(geometries, geometry, instance);
    const mask moved = mask_and(alive, instance != word(NONE));
    if (!any_lane(moved)) return ray;
    const word placed = valid_index(moved, instance);
    Ray there = ray;
    there.origin = select(moved, point_to_object(scene, placed, ray.origin), ray.origin);
    const real3 direction = FIELD(instances, placed, object_from_world_x) * ray.direction.x +
                            FIELD(instances, placed, object_from_world_y) * ray.direction.y +
                            FIELD(instances, placed, object_from_world_z) * ray.direction.z;
    there.direction = select(moved, direction, ray.direction);
    return there;
}

/// One sphere, box or plane for all lanes of `same`; where it is hit.
mask hit_shape(const SceneView& scene, uint kind, uint primitive, const Ray& ray, mask same, Hit& hit) {
    real t;
    real3 normal;
    mask found = same;
    if (kind == GEOMETRY_SPHERE) {
        const Sphere& sphere = scene.spheres[primitive];
        found = mask_and(found, intersect_sphere(ray, sphere.center, sphere.radius, t, normal));
    } else if (kind == GEOMETRY_BOX) {
        const Box& box = scene.boxes[primitive];
        found = mask_and(found, intersect_box(ray, box.lower, box.upper, t, normal));
    } else {
        const Plane& plane = scene.planes[primitive];
        normal = real3(plane.normal);
        found = mask_and(found, intersect_plane(ray, plane.normal, plane.offset, t));
    }
    hit.t = select(found, t, hit.t);
    hit.normal = select(found, normal, hit.normal);
    return found;
}

/// The hits of the rays in the lanes of `alive` with the first `count` of `seen`. Rays that miss theirs (by rounding,
/// or because the camera bends lines) are searched for; those that don't are taken off `counts`, where the kernel will
/// count them.
Hit assumed_hits(const PointView& scene, const sampling::SeenPrimitive* seen, int count, const Ray& ray, mask alive,
                 RayCounts& counts) {
    alignas(64) std::array<unsigned, kLanes> geometries{}, primitives{};
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const sampling::SeenPrimitive& s = seen[std::min(lane, static_cast<std::size_t>(count - 1))];
        geometries[lane] = s.geometry - 1;
        primitives[lane] = s.primitive;
    }
    const word geometry(lanes_of(geometries.data())), primitive(lanes_of(primitives.data()));
    const word kind = FIELD(geometries, geometry, kind);
    const Ray there = FEATURE(FEATURE_INSTANCES) ? in_object_space(scene, ray, geometry, alive) : ray;

    Hit hit;
    hit.t = hit.u = hit.v = real(0.0F);
    hit.normal = real3(real(0.0F));
    mask found = mask_and(alive, kind == word(GEOMETRY_TRIANGLES));
    if (any_lane(found)) {
        const word triangle = valid_index(found, primitive);
        real t, u, v;
        real3 normal;
        found = mask_and(found, intersect_triangle(there, GET(positions, FIELD(triangles, triangle, p0)),
                                                   GET(positions, FIELD(triangles, triangle, p1)),
                                                   GET(positions, FIELD(triangles, triangle, p2)), t, u, v, normal));
        hit.t = select(found, t, hit.t);
        hit.u = select(found, u, hit.u);
        hit.v = select(found, v, hit.v);
        hit.normal = select(found, normal, hit.normal);
    }
    mask todo = mask_and(alive, kind != word(GEOMETRY_TRIANGLES));
    while (any_lane(todo)) {
        const uint one = first_lane(todo, geometry), which = first_lane(todo, primitive);
        const mask same = mask_and(todo, mask_and(geometry == word(one), primitive == word(which)));
        found = mask_or(found, hit_shape(scene, scene.geometries[one].kind, which, there, same, hit));
        todo = mask_and(todo, mask_not(same));
    }
    counts.rays = counts.rays - select(found, word(1U), word(0U));
    hit.geometry = select(found, geometry, word(NONE));
    hit.primitive = primitive;
    const mask missed = mask_and(alive, mask_not(found));
    if (!any_lane(missed)) return hit;
    const Hit searched = trace_closest(scene, ray, missed, word(scene.first_ray_kind), true);
    hit.t = select(found, hit.t, searched.t);
    hit.u = select(found, hit.u, searched.u);
    hit.v = select(found, hit.v, searched.v);
    hit.normal = select(found, hit.normal, searched.normal);
    hit.geometry = select(found, hit.geometry, searched.geometry);
    hit.primitive = select(found, hit.primitive, searched.primitive);
    return hit;
}

}  // namespace
}  // namespace sundog::cpu
