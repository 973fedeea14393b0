// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_SHAPES_BOX_H
#define SUNDOG_KERNEL_SHAPES_BOX_H

#include "kernel/rays.h"

KERNEL_BEGIN

/// Of one slab: where the ray enters and leaves it (in order); infinite ends (or none) for a ray that runs along it.
FN void slab_interval(real origin, real direction, float lower, float upper, OUT(real) enter, OUT(real) leave) {
    // 0 times infinity would be NaN for an origin on a face, so parallel rays are told apart.
    mask parallel = abs(direction) < real(1e-30f);
    real inverse = 1.0f / select(parallel, real(1.0f), direction);
    real a = (lower - origin) * inverse;
    real b = (upper - origin) * inverse;
    mask within = mask_and(origin >= real(lower), origin <= real(upper));
    real none_enter = select(within, real(-3.0e38f), real(3.0e38f));
    enter = select(parallel, none_enter, min(a, b));
    leave = select(parallel, -none_enter, max(a, b));
}

/// Nearest hit with the faces of an axis-aligned box in (t_min, t_max): the slab test (Kay and Kajiya 1986).
FN mask intersect_box(Ray ray, vec3 lower, vec3 upper, OUT(real) t, OUT(real3) normal) {
    real enter_x;
    real enter_y;
    real enter_z;
    real leave_x;
    real leave_y;
    real leave_z;
    slab_interval(ray.origin.x, ray.direction.x, lower.x, upper.x, enter_x, leave_x);
    slab_interval(ray.origin.y, ray.direction.y, lower.y, upper.y, enter_y, leave_y);
    slab_interval(ray.origin.z, ray.direction.z, lower.z, upper.z, enter_z, leave_z);
    real enter = max(enter_x, max(enter_y, enter_z));
    real leave = min(leave_x, min(leave_y, leave_z));
    mask reached = enter <= leave;
    mask enter_valid = mask_and(enter > ray.t_min, enter < ray.t_max);
    mask leave_valid = mask_and(leave > ray.t_min, leave < ray.t_max);
    t = select(enter_valid, enter, leave);
    // The face is that of the slab which set t; its outward normal runs against the ray on entry, along it on exit.
    mask on_x = select_mask(enter_valid, enter_x >= enter, leave_x <= leave);
    mask on_y = select_mask(enter_valid, enter_y >= enter, leave_y <= leave);
    real against_x = select(ray.direction.x < real(0.0f), real(1.0f), real(-1.0f));
    real against_y = select(ray.direction.y < real(0.0f), real(1.0f), real(-1.0f));
    real against_z = select(ray.direction.z < real(0.0f), real(1.0f), real(-1.0f));
    real side = select(enter_valid, real(1.0f), real(-1.0f));
    real zero = real(0.0f);
    normal = select(on_x, real3(against_x * side, zero, zero),
                    select(on_y, real3(zero, against_y * side, zero), real3(zero, zero, against_z * side)));
    return mask_and(reached, mask_or(enter_valid, leave_valid));
}

/// Texture coordinates on a box: each face carries the unit square once.
FN real2 box_uv(real3 point, real3 outward_normal, real3 lower, real3 upper) {
    real3 p = point - lower;
    real3 extent = upper - lower;
    real x = p.x / max(extent.x, real(1e-30f));
    real y = p.y / max(extent.y, real(1e-30f));
    real z = p.z / max(extent.z, real(1e-30f));
    mask on_x = abs(outward_normal.x) > real(0.5f);
    mask on_y = abs(outward_normal.y) > real(0.5f);
    return select(on_x, real2(y, z), select(on_y, real2(x, z), real2(x, y)));
}

KERNEL_END

#endif
