// SPDX-License-Identifier: Apache-2.0
// Rays against single spheres and boxes of a RenderScene: the same for Embree's callbacks and for structures of ours.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/vec3d.h"
#include "device/accel/primitive_facts.h"
#include "kernel/shapes/box.h"
#include "kernel/shapes/sphere.h"

namespace sundog::accel {

inline bool hit_large_sphere(const kernel::Sphere& sphere, const kernel::Ray& ray, float& t, kernel::real3& normal) {
    const Vec3d direction{ray.direction.x, ray.direction.y, ray.direction.z};
    const Vec3d from =
        Vec3d{ray.origin.x, ray.origin.y, ray.origin.z} - Vec3d{sphere.center.x, sphere.center.y, sphere.center.z};
    const double a = dot(direction, direction), b = dot(from, direction);
    const double c = dot(from, from) - double{sphere.radius} * sphere.radius;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return false;
    const double root = std::sqrt(discriminant);
    const double q = b < 0 ? root - b : -root - b;
    const double one = q == 0 ? 0 : c / q, other = q / a;
    const auto near = static_cast<float>(std::min(one, other)), far = static_cast<float>(std::max(one, other));
    t = near > ray.t_min && near < ray.t_max ? near : far;
    const Vec3d out = from + direction * (t == near ? std::min(one, other) : std::max(one, other));
    normal = kernel::real3(static_cast<float>(out.x), static_cast<float>(out.y), static_cast<float>(out.z));
    return t > ray.t_min && t < ray.t_max;
}

/// The nearest hit with a sphere or box; false for none. With `culls`, a hit from behind is passed over: the front of a
/// convex shape is never behind its back, so the ray then misses it altogether.
inline bool hit_shape(const RenderScene& scene, const kernel::Geometry& geometry, std::uint32_t primitive,
                      const kernel::Ray& ray, bool culls, float& t, kernel::real3& normal) {
    const std::uint32_t i = geometry.first_primitive + primitive;
    const bool sphere = geometry.kind == kernel::GEOMETRY_SPHERE;
    const bool found =
        sphere && scene.spheres[i].radius >= kLargeRadius ? hit_large_sphere(scene.spheres[i], ray, t, normal)
        : sphere ? kernel::intersect_sphere(ray, scene.spheres[i].center, scene.spheres[i].radius, t, normal)
                 : kernel::intersect_box(ray, scene.boxes[i].lower, scene.boxes[i].upper, t, normal);
    return found && !(culls && dot(normal, ray.direction) >= 0);
}

}  // namespace sundog::accel
