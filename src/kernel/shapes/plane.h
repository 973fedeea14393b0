// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_SHAPES_PLANE_H
#define SUNDOG_KERNEL_SHAPES_PLANE_H

#include "kernel/rays.h"

KERNEL_BEGIN

/// Hit with the plane dot(normal, p) = offset in (t_min, t_max). `normal` is also the hit's normal.
FN mask intersect_plane(Ray ray, vec3 normal, float offset, OUT(real) t) {
    real slope = dot(real3(normal), ray.direction);
    mask parallel = abs(slope) < real(1e-30f);
    t = (offset - dot(real3(normal), ray.origin)) / select(parallel, real(1.0f), slope);
    return mask_and(mask_not(parallel), mask_and(t > ray.t_min, t < ray.t_max));
}

/// Texture coordinates on a plane: one unit of length is one unit of uv, along two axes perpendicular to the unit
/// normal. For a horizontal plane those are X and Y. (Basis: Duff et al., Building an Orthonormal Basis, Revisited,
/// JCGT 2017.)
FN real2 plane_uv(real3 point, real3 normal) {
    real side = select(normal.z < real(0.0f), real(-1.0f), real(1.0f));
    real a = -1.0f / (side + normal.z);
    real b = normal.x * normal.y * a;
    real3 axis_u = real3(1.0f + side * normal.x * normal.x * a, side * b, -side * normal.x);
    real3 axis_v = real3(b, side + normal.y * normal.y * a, -normal.y);
    return real2(dot(point, axis_u), dot(point, axis_v));
}

KERNEL_END

#endif
