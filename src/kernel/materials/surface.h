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
    real2 weights;  ///< Of a triangle's second and third corner.
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

/// What stands in a vertex's entry `which` of `uvs` (VERTEX_*), interpolated in the lanes of `present`. Only if
/// FEATURE_VERTEX_ATTRIBUTES.
FN real2 vertex_pair(SCENE word triangle, mask present, real2 weights, uint which) {
    word ia = valid_index(present, FIELD(triangle_uvs, triangle, a)) + word(which);
    word ib = valid_index(present, FIELD(triangle_uvs, triangle, b)) + word(which);
    word ic = valid_index(present, FIELD(triangle_uvs, triangle, c)) + word(which);
    return interpolate(GET(uvs, ia), GET(uvs, ib), GET(uvs, ic), weights.x, weights.y);
}

/// Lanes of `asked` whose triangle has vertex attributes.
FN mask has_vertex_attributes(SCENE word triangle, mask asked) {
    return mask_and(asked, FIELD(triangle_uvs, triangle, a) != word(NONE));
}

/// A triangle's colour at a point, 1 where it has none, and its alpha. Only if FEATURE_VERTEX_ATTRIBUTES.
FN real3 vertex_color(SCENE word triangle, mask asked, real2 weights, OUT(real) alpha) {
    mask present = has_vertex_attributes(SCENE_ triangle, asked);
    real2 red_green = vertex_pair(SCENE_ triangle, present, weights, VERTEX_COLOR);
    real2 blue_alpha = vertex_pair(SCENE_ triangle, present, weights, VERTEX_COLOR + 1u);
    alpha = select(present, blue_alpha.y, real(1.0f));
    return select(present, real3(red_green.x, red_green.y, blue_alpha.x), real3(real(1.0f)));
}

/// Lanes whose surface is a triangle; `triangle` is its number there, and some valid one in others.
FN mask on_triangle(SCENE Surface s, OUT(word) triangle) {
    mask is_triangle = FIELD(geometries, s.geometry, kind) == word(GEOMETRY_TRIANGLES);
    triangle = valid_index(is_triangle, s.primitive);
    return is_triangle;
}

/// The texture coordinates that a map with those flags is looked up by.
FN real2 map_uv(SCENE Surface s, word flags) {
    real2 uv = s.uv;
    if (FEATURE(FEATURE_VERTEX_ATTRIBUTES)) {
        mask second = (flags & word(TEXTURE_SECOND_UV)) != word(0u);
        if (any_lane(second)) {
            word triangle;
            mask is_triangle = on_triangle(SCENE_ s, triangle);
            mask present = has_vertex_attributes(SCENE_ triangle, mask_and(is_triangle, second));
            uv = select(present, vertex_pair(SCENE_ triangle, present, s.weights, VERTEX_SECOND_UV), uv);
        }
    }
    return uv;
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

/// The normal that a triangle's vertices give a surface, on the side that the ray came from: the geometric one in lanes
/// that aren't `asked`, or have none. Only if FEATURE_SMOOTH.
FN real3 smooth_normal(SCENE Surface s, mask asked) {
    word triangle = valid_index(asked, s.primitive);
    word a = FIELD(triangle_normals, triangle, a);
    mask smoothed = mask_and(asked, a != word(NONE));
    if (!any_lane(smoothed)) return s.geometric_normal;
    word ia = valid_index(smoothed, a);
    word ib = valid_index(smoothed, FIELD(triangle_normals, triangle, b));
    word ic = valid_index(smoothed, FIELD(triangle_normals, triangle, c));
    real3 n = interpolate(GET(normals, ia), GET(normals, ib), GET(normals, ic), s.weights.x, s.weights.y);
    // Opposed vertex normals can cancel: the face's own normal stands in.
    smoothed = mask_and(smoothed, dot(n, n) > real(1e-20f));
    if (FEATURE(FEATURE_INSTANCES)) {
        word instance = FIELD(geometries, s.geometry, instance);
        mask moved = instance != word(NONE);
        n = select(moved, normal_to_world(SCENE_ valid_index(moved, instance), n), n);
    }
    // Vertex normals may have been written for either side; the face's orientation is what the ray goes by.
    n = normalize(n);
    real agree = select(dot(n, s.geometric_normal) < real(0.0f), real(-1.0f), real(1.0f));
    return select(smoothed, n * agree, s.geometric_normal);
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
    s.weights = real2(hit.u, hit.v);
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
    }
    real3 unit_geometric = normalize(outward);
    s.from_behind = dot(unit_geometric, ray.direction) > real(0.0f);
    real side = select(s.from_behind, real(-1.0f), real(1.0f));
    s.geometric_normal = unit_geometric * side;
    s.normal = s.geometric_normal;
    if (FEATURE(FEATURE_SMOOTH)) s.normal = smooth_normal(SCENE_ s, mask_and(is_triangle, found));
    return s;
}

KERNEL_END

#endif
