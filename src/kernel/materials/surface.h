// SPDX-License-Identifier: Apache-2.0
// What a ray finds where it hits: the place, the normals, the texture coordinates, the material.
#ifndef SUNDOG_KERNEL_MATERIALS_SURFACE_H
#define SUNDOG_KERNEL_MATERIALS_SURFACE_H

#include "kernel/rays.h"
#include "kernel/shapes/box.h"
#include "kernel/shapes/plane.h"
#include "kernel/shapes/sphere.h"
#include "kernel/shapes/triangle.h"

KERNEL_BEGIN

struct Surface {
    real3 position;          ///< World space.
    real error;              ///< How far position may lie off the surface.
    real3 geometric_normal;  ///< Unit, world space, on the side that the ray came from.
    real3 normal;            ///< Shading normal, likewise.
    mask from_behind;        ///< The ray came from the back (for a solid: from inside).
    real2 uv;
    word geometry, primitive, material;
};

/// A geometry's normal, carried from object to world space (by the inverse transposed).
FN real3 normal_to_world(SCENE word instance, real3 n) {
    return real3(dot(FIELD(instances, instance, object_from_world_x), n),
                 dot(FIELD(instances, instance, object_from_world_y), n),
                 dot(FIELD(instances, instance, object_from_world_z), n));
}

/// A point, carried from world to object space.
FN real3 point_to_object(SCENE word instance, real3 p) {
    return FIELD(instances, instance, object_from_world_x) * p.x +
           FIELD(instances, instance, object_from_world_y) * p.y +
           FIELD(instances, instance, object_from_world_z) * p.z + FIELD(instances, instance, object_from_world_t);
}

/// Texture coordinates of a triangle's point; zero where it has none.
FN real2 triangle_uv(SCENE word primitive, real u, real v) {
    word a = FIELD(triangle_uvs, primitive, a);
    mask present = a != word(NONE);
    word ia = valid_index(present, a);
    word ib = valid_index(present, FIELD(triangle_uvs, primitive, b));
    word ic = valid_index(present, FIELD(triangle_uvs, primitive, c));
    real2 uv = interpolate(GET(uvs, ia), GET(uvs, ib), GET(uvs, ic), u, v);
    return select(present, uv, real2(real(0.0f), real(0.0f)));
}

/// The material of a hit in the lanes of `found`, some valid one in others.
FN word hit_material(SCENE Hit hit, mask found) {
    word geometry = valid_index(found, hit.geometry);
    word primitive = valid_index(found, hit.primitive);
    if (!FEATURE(FEATURE_ANALYTIC)) return FIELD(triangles, primitive, material);
    word kind = FIELD(geometries, geometry, kind);
    mask is_triangle = kind == word(GEOMETRY_TRIANGLES);
    mask is_sphere = kind == word(GEOMETRY_SPHERE);
    mask is_box = kind == word(GEOMETRY_BOX);
    mask is_plane = kind == word(GEOMETRY_PLANE);
    word material = FIELD(triangles, valid_index(is_triangle, primitive), material);
    if (any_lane(is_sphere)) {
        word sphere = valid_index(is_sphere, primitive);
        material = select(is_sphere, FIELD(spheres, sphere, material), material);
    }
    if (any_lane(is_box)) {
        word box = valid_index(is_box, primitive);
        material = select(is_box, FIELD(boxes, box, material), material);
    }
    if (any_lane(is_plane)) {
        word plane = valid_index(is_plane, primitive);
        material = select(is_plane, FIELD(planes, plane, material), material);
    }
    material = select(kind == word(GEOMETRY_SOLID), primitive, material);
    return material;
}

/// Everything about a hit, in the lanes of `found`; others hold some valid surface.
FN Surface surface_at(SCENE Ray ray, Hit hit, mask found) {
    Surface s;
    s.geometry = valid_index(found, hit.geometry);
    s.primitive = valid_index(found, hit.primitive);
    real t = select(found, hit.t, real(0.0f));
    s.position = point_at(ray, t);
    s.error = hit_error(ray.origin, s.position, t);
    real3 outward = select(found, hit.normal, real3(real(0.0f), real(0.0f), real(1.0f)));
    real3 shading = outward;  // object space until both are carried to the world's
    s.uv = real2(real(0.0f), real(0.0f));

    word kind = word(GEOMETRY_TRIANGLES);
    word instance = word(NONE);
    real3 object_point = s.position;
    if (FEATURE(FEATURE_ANALYTIC | FEATURE_INSTANCES)) {
        kind = FIELD(geometries, s.geometry, kind);
        instance = FIELD(geometries, s.geometry, instance);
    }
    mask moved = instance != word(NONE);
    word placed = valid_index(moved, instance);
    if (FEATURE(FEATURE_INSTANCES))
        object_point = select(moved, point_to_object(SCENE_ placed, s.position), s.position);

    mask is_triangle = kind == word(GEOMETRY_TRIANGLES);
    word triangle = valid_index(is_triangle, s.primitive);
    s.material = hit_material(SCENE_ hit, found);
    mask smoothed = mask_and(found, mask_not(found));
    if (FEATURE(FEATURE_SMOOTH)) {
        word a = FIELD(triangle_normals, triangle, a);
        smoothed = mask_and(mask_and(is_triangle, found), a != word(NONE));
        if (any_lane(smoothed)) {
            word ia = valid_index(smoothed, a);
            word ib = valid_index(smoothed, FIELD(triangle_normals, triangle, b));
            word ic = valid_index(smoothed, FIELD(triangle_normals, triangle, c));
            real3 n = interpolate(GET(normals, ia), GET(normals, ib), GET(normals, ic), hit.u, hit.v);
            // Opposed vertex normals can cancel: the face's own normal stands in.
            shading = select(mask_and(smoothed, dot(n, n) > real(1e-20f)), n, shading);
        }
    }
    if (FEATURE(FEATURE_TEXTURES)) s.uv = triangle_uv(SCENE_ triangle, hit.u, hit.v);

    if (FEATURE(FEATURE_ANALYTIC)) {
        if (FEATURE(FEATURE_TEXTURES)) {
            real3 unit_outward = normalize(outward);
            mask is_sphere = kind == word(GEOMETRY_SPHERE);
            if (any_lane(is_sphere)) s.uv = select(is_sphere, sphere_uv(unit_outward), s.uv);
            mask is_box = kind == word(GEOMETRY_BOX);
            if (any_lane(is_box)) {
                word box = valid_index(is_box, s.primitive);
                real2 uv = box_uv(object_point, unit_outward, FIELD(boxes, box, lower), FIELD(boxes, box, upper));
                s.uv = select(is_box, uv, s.uv);
            }
            s.uv = select(kind == word(GEOMETRY_SOLID), real2(hit.u, hit.v), s.uv);
            mask is_plane = kind == word(GEOMETRY_PLANE);
            if (any_lane(is_plane)) s.uv = select(is_plane, plane_uv(object_point, unit_outward), s.uv);
        }
    }

    if (FEATURE(FEATURE_INSTANCES)) {
        outward = select(moved, normal_to_world(SCENE_ placed, outward), outward);
        shading = select(moved, normal_to_world(SCENE_ placed, shading), shading);
    }
    real3 unit_geometric = normalize(outward);
    s.from_behind = dot(unit_geometric, ray.direction) > real(0.0f);
    real side = select(s.from_behind, real(-1.0f), real(1.0f));
    s.geometric_normal = unit_geometric * side;
    s.normal = s.geometric_normal;
    if (any_lane(smoothed)) {
        // Vertex normals may have been written for either side; the face's orientation is what the ray goes by.
        real3 unit_shading = normalize(shading);
        real agree = select(dot(unit_shading, s.geometric_normal) < real(0.0f), real(-1.0f), real(1.0f));
        s.normal = select(smoothed, unit_shading * agree, s.normal);
    }
    return s;
}

KERNEL_END

#endif
