// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_SHAPES_SPHERE_H
#define SUNDOG_KERNEL_SHAPES_SPHERE_H

#include "kernel/math.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// Nearest hit with a sphere in (t_min, t_max); the direction need not be a unit vector. The discriminant is computed
/// from the ray's closest point (Haines, Günther, Akenine-Möller: Precision Improvements for Ray/Sphere Intersection,
/// Ray Tracing Gems 2019, chapter 7), so small far spheres keep their shape.
FN mask intersect_sphere(Ray ray, vec3 center, float radius, OUT(real) t, OUT(real3) normal) {
    real3 f = ray.origin - center;
    real a = dot(ray.direction, ray.direction);
    real b = -dot(f, ray.direction);
    real3 offset = f + ray.direction * (b / a);
    real discriminant = radius * radius - dot(offset, offset);
    mask reached = discriminant >= real(0.0f);
    real root = sqrt(a * max(discriminant, real(0.0f)));
    real q = select(b < real(0.0f), b - root, b + root);
    real c = dot(f, f) - radius * radius;
    mask q_zero = abs(q) <= real(0.0f);
    real t_a = c / select(q_zero, real(1.0f), q);
    real t_b = q / a;
    real near = min(t_a, t_b);
    real far = max(t_a, t_b);
    mask near_valid = mask_and(near > ray.t_min, near < ray.t_max);
    mask far_valid = mask_and(far > ray.t_min, far < ray.t_max);
    t = select(near_valid, near, far);
    normal = f + ray.direction * t;
    return mask_and(reached, mask_or(near_valid, far_valid));
}

/// Texture coordinates of a point on a sphere from its outward normal: u once around Z from +X, v from south to north
/// pole.
FN real2 sphere_uv(real3 unit_normal) {
    real around = angle_of(unit_normal.y, unit_normal.x) * 0.159154943f;
    real radius_xy = sqrt(unit_normal.x * unit_normal.x + unit_normal.y * unit_normal.y);
    real u = select(around < real(0.0f), around + 1.0f, around);
    return real2(u, angle_of(unit_normal.z, radius_xy) * 0.318309886f + 0.5f);
}

KERNEL_END

#endif
