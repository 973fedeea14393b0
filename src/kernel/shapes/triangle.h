// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_SHAPES_TRIANGLE_H
#define SUNDOG_KERNEL_SHAPES_TRIANGLE_H

#include "kernel/rays.h"

KERNEL_BEGIN

/// Hit with a triangle in (t_min, t_max) by Möller and Trumbore (1997): p = (1-u-v)*a + u*b + v*c, either side.
/// `normal` is cross(b-a, c-a). For traversals of our own; Embree brings its own.
FN mask intersect_triangle(Ray ray, real3 a, real3 b, real3 c, OUT(real) t, OUT(real) u, OUT(real) v,
                           OUT(real3) normal) {
    real3 e1 = b - a;
    real3 e2 = c - a;
    normal = cross(e1, e2);
    real3 to_a = a - ray.origin;
    real3 r = cross(ray.direction, to_a);
    real determinant = dot(normal, ray.direction);
    mask edge_on = abs(determinant) <= real(0.0f);
    real inverse = 1.0f / select(edge_on, real(1.0f), determinant);
    u = -dot(r, e2) * inverse;
    v = dot(r, e1) * inverse;
    t = dot(normal, to_a) * inverse;
    mask inside = mask_and(mask_and(u >= real(0.0f), v >= real(0.0f)), u + v <= real(1.0f));
    return mask_and(mask_and(inside, mask_not(edge_on)), mask_and(t > ray.t_min, t < ray.t_max));
}

/// Linear interpolation between three corners' values.
FN real3 interpolate(real3 a, real3 b, real3 c, real u, real v) { return a * (1.0f - u - v) + b * u + c * v; }
FN real2 interpolate(real2 a, real2 b, real2 c, real u, real v) { return a * (1.0f - u - v) + b * u + c * v; }

KERNEL_END

#endif
