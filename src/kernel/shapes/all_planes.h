// SPDX-License-Identifier: Apache-2.0
// Infinite planes have no bounds for an acceleration structure: after its own traversal a device asks them one by one.
#ifndef SUNDOG_KERNEL_SHAPES_ALL_PLANES_H
#define SUNDOG_KERNEL_SHAPES_ALL_PLANES_H

#include "kernel/shapes/plane.h"

KERNEL_BEGIN

/// Where a plane is hit nearer than t_max, in the lanes of `alive`; honours back-face culling.
FN mask hit_plane(SCENE Plane plane, Ray ray, word ray_kind, mask alive, OUT(real) t) {
    if (FEATURE(FEATURE_HIDDEN)) {
        alive = mask_and(alive, (ray_kind & word(AT(geometries, plane.geometry).hidden_from)) == word(0u));
    }
    uint instance = AT(geometries, plane.geometry).instance;
    if (instance != NONE) {
        Instance i = AT(instances, instance);
        real3 o = ray.origin;
        real3 d = ray.direction;
        ray.origin = real3(i.object_from_world_x) * o.x + real3(i.object_from_world_y) * o.y +
                     real3(i.object_from_world_z) * o.z + real3(i.object_from_world_t);
        ray.direction = real3(i.object_from_world_x) * d.x + real3(i.object_from_world_y) * d.y +
                        real3(i.object_from_world_z) * d.z;
    }
    mask found = mask_and(alive, intersect_plane(ray, plane.normal, plane.offset, t));
    if (FEATURE(FEATURE_CULL)) {
        if ((AT(materials, plane.material).flags & MATERIAL_TRANSPARENT) == 0u) {
            found = mask_and(found, dot(real3(plane.normal), ray.direction) < real(0.0f));
        }
    }
    return found;
}

/// Replaces `hit` by the nearest plane where one is nearer, or lies at the same place (which rounding would decide,
/// pixel by pixel) and was written before what was hit.
FN void closest_plane(SCENE Ray ray, word ray_kind, mask alive, INOUT(Hit) hit) {
    const float coincident = 1e-6f;
    for (uint i = 0u; i < FRAME.plane_count; i = i + 1u) {
        Plane plane = AT(planes, i);
        ray.t_max = select(hit.geometry != word(NONE), hit.t * (1.0f + coincident), ray.t_max);
        real t;
        mask found = hit_plane(SCENE_ plane, ray, ray_kind, alive, t);
        mask before = mask_or(word(plane.geometry) < hit.geometry, t < hit.t * (1.0f - coincident));
        found = mask_and(found, before);
        hit.t = select(found, t, hit.t);
        hit.u = select(found, real(0.0f), hit.u);
        hit.v = select(found, real(0.0f), hit.v);
        hit.geometry = select(found, word(plane.geometry), hit.geometry);
        hit.primitive = select(found, word(i), hit.primitive);
        hit.normal = select(found, real3(plane.normal), hit.normal);
    }
}

/// True where any plane is hit.
FN mask any_plane(SCENE Ray ray, word ray_kind, mask alive) {
    mask blocked = mask_and(alive, mask_not(alive));
    for (uint i = 0u; i < FRAME.plane_count; i = i + 1u) {
        Plane plane = AT(planes, i);
        real t;
        blocked = mask_or(blocked, hit_plane(SCENE_ plane, ray, ray_kind, alive, t));
    }
    return blocked;
}

KERNEL_END

#endif
