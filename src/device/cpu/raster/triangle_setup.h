// SPDX-License-Identifier: Apache-2.0
// As many triangles at a time as there are lanes: where they are in the picture, and their linear functions. Only units
// of the rasteriser include it.
#pragma once

#include "device/cpu/raster/eye_view.h"
#include "kernel/rays.h"

KERNEL_BEGIN

using sundog::cpu::raster::EyeView;
using sundog::cpu::raster::kRounding;

/// Corners, seen from the eye.
struct Corners {
    real3 v0, v1, v2;
};

FN Corners corners_of(SCENE const EyeView& view, word triangle) {
    const real3 eye = real3(view.eye);
    return {GET(positions, FIELD(triangles, triangle, p0)) - eye, GET(positions, FIELD(triangles, triangle, p1)) - eye,
            GET(positions, FIELD(triangles, triangle, p2)) - eye};
}

FN real sum_of_sizes(real3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }
FN float sum_of_sizes(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }
FN real greatest(real a, real b, real c) { return max(max(a, b), c); }
FN real least(real a, real b, real c) { return min(min(a, b), c); }

/// Rectangles around triangles, in pixels, with room for rounding.
struct ScreenBounds {
    real x0, x1, y0, y1;
    real inverse;  ///< Of the length of the way to the nearest corner, if bounded.
    mask seen;     ///< Not beside or behind what the picture shows.
    mask bounded;  ///< Not near the plane of the eye; else the rectangle says nothing.
};

/// Lanes in which all three lie farther out than their rounding.
FN mask all_out(real a, real b, real c, real na, real nb, real nc) {
    return mask_and(mask_and(a > na, b > nb), c > nc);
}

FN ScreenBounds screen_bounds(const EyeView& view, const Corners& c, mask alive) {
    const real n0 = sum_of_sizes(c.v0), n1 = sum_of_sizes(c.v1), n2 = sum_of_sizes(c.v2);
    const real n = greatest(n0, n1, n2);
    const real f0 = dot(c.v0, real3(view.forward)), f1 = dot(c.v1, real3(view.forward));
    const real f2 = dot(c.v2, real3(view.forward));
    const real r0 = dot(c.v0, real3(view.right)), r1 = dot(c.v1, real3(view.right)), r2 = dot(c.v2, real3(view.right));
    const real u0 = dot(c.v0, real3(view.up)), u1 = dot(c.v1, real3(view.up)), u2 = dot(c.v2, real3(view.up));
    const float forward_size = sum_of_sizes(view.forward);
    const float size = forward_size + max(sum_of_sizes(view.right), sum_of_sizes(view.up));
    const real q0 = n0 * (kRounding * size), q1 = n1 * (kRounding * size), q2 = n2 * (kRounding * size);
    mask out = all_out(-f0, -f1, -f2, q0, q1, q2);
    out = mask_or(out, all_out(r0 - f0, r1 - f1, r2 - f2, q0, q1, q2));
    out = mask_or(out, all_out(-r0 - f0, -r1 - f1, -r2 - f2, q0, q1, q2));
    out = mask_or(out, all_out(u0 - f0, u1 - f1, u2 - f2, q0, q1, q2));
    out = mask_or(out, all_out(-u0 - f0, -u1 - f1, -u2 - f2, q0, q1, q2));
    ScreenBounds b;
    b.seen = mask_and(alive, mask_not(out));
    // Steeper than this, and rounding is no longer small against a pixel.
    const float flat = 0.01f * forward_size;
    b.bounded = all_out(f0, f1, f2, n0 * flat, n1 * flat, n2 * flat);
    const real i0 = 1.0f / select(b.bounded, f0, real(1.0f)), i1 = 1.0f / select(b.bounded, f1, real(1.0f));
    const real i2 = 1.0f / select(b.bounded, f2, real(1.0f));
    const float half_width = view.width * 0.5f, half_height = view.height * 0.5f;
    const real x0 = r0 * i0 * half_width, x1 = r1 * i1 * half_width, x2 = r2 * i2 * half_width;
    const real y0 = -u0 * i0 * half_height, y1 = -u1 * i1 * half_height, y2 = -u2 * i2 * half_height;
    b.x0 = least(x0, x1, x2), b.x1 = greatest(x0, x1, x2);
    b.y0 = least(y0, y1, y2), b.y1 = greatest(y0, y1, y2);
    // Where two edges meet in an acute angle, what lies within their rounding reaches out farther: by their distances
    // from the corner's lines over the angle's sine. In pixels, by the triangle's area: m is an edge function's
    // rounding in those units.
    const real side = b.x1 - b.x0 + (b.y1 - b.y0);
    const real area = abs((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0));
    const real inverse = b.inverse = greatest(i0, i1, i2);
    const real edge = greatest(sum_of_sizes(c.v1 - c.v0), sum_of_sizes(c.v2 - c.v1), sum_of_sizes(c.v0 - c.v2));
    const real m = edge * n * inverse * inverse * (kRounding * view.spread / view.volume);
    const real corner = min(2.0f * m * side / max(area, real(1e-20f)), side + 4.0f);
    const real room =
        corner + n * inverse * (kRounding * (forward_size + size) * max(half_width, half_height)) + real(1e-3f);
    b.x0 = b.x0 + half_width - room, b.x1 = b.x1 + half_width + room;
    b.y0 = b.y0 + half_height - room, b.y1 = b.y1 + half_height + room;
    return b;
}

/// A linear function of the picture's coordinates: x*X + y*Y + c.
struct Linear {
    real x, y, c;
};

FN Linear linear_of(const EyeView& view, real3 normal, real scale) {
    return {dot(normal, real3(view.across)) * scale, dot(normal, real3(view.down)) * scale,
            dot(normal, real3(view.base)) * scale};
}

/// What is scanned of triangles.
struct TriangleFunctions {
    Linear edge0, edge1, edge2;    ///< Positive inside.
    real room0, room1, room2;      ///< Their bounds on rounding.
    Linear nearness;               ///< The inverse length of the way there.
    real relative_room, far_room;  ///< Bounds on its rounding: relative to itself, and absolute.
    mask edge_on;                  ///< Rounding may decide from which side it is seen: then nearness says nothing.
};

FN TriangleFunctions functions_of(const EyeView& view, const Corners& c) {
    // Edges from differences and sums, as in Embree: small triangles far away lose nothing.
    const real3 e0 = c.v2 - c.v0, e1 = c.v0 - c.v1, e2 = c.v1 - c.v2;
    const real3 s0 = c.v2 + c.v0, s1 = c.v0 + c.v1, s2 = c.v1 + c.v2;
    const real3 normal = cross(e0, e1);
    const real volume = dot(c.v0, normal);
    const real l0 = sum_of_sizes(e0), l1 = sum_of_sizes(e1), l2 = sum_of_sizes(e2);
    // Numbers under these vanish.
    const real tiny(1e-36f);
    const real area_room = l0 * l1 * kRounding + tiny;
    const real volume_room = area_room * sum_of_sizes(c.v0) + tiny;
    TriangleFunctions f;
    f.edge_on = mask_not(abs(volume) > 4.0f * volume_room);
    const real side = select(volume < real(0.0f), real(-1.0f), real(1.0f));
    f.edge0 = linear_of(view, cross(e0, s0), side);
    f.edge1 = linear_of(view, cross(e1, s1), side);
    f.edge2 = linear_of(view, cross(e2, s2), side);
    const float room = kRounding * view.spread;
    f.room0 = l0 * sum_of_sizes(s0) * room + tiny;
    f.room1 = l1 * sum_of_sizes(s1) * room + tiny;
    f.room2 = l2 * sum_of_sizes(s2) * room + tiny;
    const real inverse = 1.0f / select(f.edge_on, real(1.0f), volume);
    f.nearness = linear_of(view, normal, inverse);
    f.relative_room = volume_room * abs(inverse);
    f.far_room = area_room * abs(inverse) * view.spread;
    return f;
}

KERNEL_END
