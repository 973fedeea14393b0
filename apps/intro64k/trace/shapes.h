// SPDX-License-Identifier: Apache-2.0
// Where rays meet solids.
#pragma once

#include "kernel/shapes/box.h"
#include "kernel/shapes/plane.h"
#include "kernel/shapes/sphere.h"
#include "stage/world.h"
#include "trace/lanes.h"

namespace sundog::intro {

inline constexpr float kFar = 3.0e38f;

/// A part number that says "the torus", "the sphere": what has only one surface.
inline constexpr uint kWhole = 0xffu;

FN real3 to_own_space(const Solid& s, real3 v) {
    return real3(dot(v, real3(s.x)), dot(v, real3(s.y)), dot(v, real3(s.z)));
}

FN real3 from_own_space(const Solid& s, real3 v) { return real3(s.x) * v.x + real3(s.y) * v.y + real3(s.z) * v.z; }

/// Where a quadratic a t^2 - 2 b t + c is negative.
FN void quadratic_interval(real a, real b, real c, OUT(real) enter, OUT(real) leave) {
    mask flat = a < real(1e-9f);
    real discriminant = b * b - a * c;
    real root = sqrt(max(discriminant, real(0.0f)));
    real inverse = 1.0f / select(flat, real(1.0f), a);
    mask some = select_mask(flat, c<real(0.0f), discriminant> real(0.0f));
    real wide_enter = select(some, real(-kFar), real(kFar));
    enter = select(mask_or(flat, mask_not(some)), wide_enter, (b - root) * inverse);
    leave = select(mask_or(flat, mask_not(some)), -wide_enter, (b + root) * inverse);
}

/// Where a ray in the solid's own space is inside a part; enter > leave where it never is.
[[gnu::noinline]] inline void part_interval(const Part& part, const real3& o, const real3& d, real& enter,
                                            real& leave) {
    real3 f = o - real3(part.place);
    if (part.kind == PartKind::kBox) {
        const real from[3] = {f.x, f.y, f.z};
        const real way[3] = {d.x, d.y, d.z};
        const float half[3] = {part.half.x, part.half.y, part.half.z};
        enter = real(-kFar);
        leave = real(kFar);
        for (uint i = 0u; i < 3u; i = i + 1u) {
            real e;
            real l;
            slab_interval(from[i], way[i], -half[i], half[i], e, l);
            enter = max(enter, e);
            leave = min(leave, l);
        }
    } else if (part.kind == PartKind::kHalfSpace) {
        real slope = dot(real3(part.place), d);
        real gap = part.radius - dot(real3(part.place), o);
        mask along = abs(slope) < real(1e-12f);
        real t = gap / select(along, real(1.0f), slope);
        mask in = slope < real(0.0f);
        enter = select(in, t, real(-kFar));
        leave = select(in, real(kFar), t);
        enter = select(along, select(gap >= real(0.0f), real(-kFar), real(kFar)), enter);
        leave = select(along, real(kFar), leave);
    } else {
        real3 g = d;
        if (part.kind == PartKind::kTube) {
            real zero = real(0.0f);
            if (part.axis == 0u) g.x = f.x = zero;
            if (part.axis == 1u) g.y = f.y = zero;
            if (part.axis == 2u) g.z = f.z = zero;
        }
        quadratic_interval(dot(g, g), -dot(f, g), dot(f, f) - part.radius * part.radius, enter, leave);
    }
}

/// The first point of a carved solid's surface beyond t_min, in the lanes of `alive`.
[[gnu::noinline]] inline mask carved_hit(const World& world, const Solid& solid, const Ray& ray, mask alive, real& t,
                                         word& part) {
    real3 o = to_own_space(solid, ray.origin - real3(solid.origin));
    real3 d = to_own_space(solid, ray.direction);
    real enter = real(-kFar);
    real leave = ray.t_max;
    part = word(solid.first_part);
    uint first_cut = solid.first_part + solid.base_count;
    for (uint i = solid.first_part; i < first_cut; i = i + 1u) {
        real e;
        real l;
        part_interval(world.parts[i], o, d, e, l);
        mask later = e > enter;
        part = select(later, word(i), part);
        enter = max(enter, e);
        leave = min(leave, l);
    }
    alive = mask_and(alive, mask_and(enter<leave, leave> ray.t_min));
    if (!any_lane(alive)) return alive;
    // Cuts push the entry back until it lies in none of them. One that is pushed into another is pushed on by a second
    // round.
    t = max(enter, ray.t_min);
    mask hit = enter > ray.t_min;
    uint rounds = solid.cut_count > 1u ? 2u : 1u;
    for (uint round = 0u; round < rounds; round = round + 1u) {
        mask any_moved = mask(false);
        for (uint i = first_cut; i < first_cut + solid.cut_count; i = i + 1u) {
            real e;
            real l;
            part_interval(world.parts[i], o, d, e, l);
            mask moved = mask_and(e <= t, t < l);
            t = select(moved, l, t);
            part = select(moved, word(i), part);
            hit = mask_or(hit, moved);
            any_moved = mask_or(any_moved, moved);
        }
        if (!any_lane(mask_and(any_moved, alive))) break;
    }
    return mask_and(alive, mask_and(hit, t < leave));
}

/// The first point of a torus beyond t_min: steps as long as the distance to it (Hart, Sphere Tracing, 1996), then
/// Newton's.
[[gnu::noinline]] inline mask torus_hit(const Solid& solid, const Ray& ray, mask alive, real& t) {
    real3 o = to_own_space(solid, ray.origin - real3(solid.origin));
    real3 d = to_own_space(solid, ray.direction);
    // The flat disc that holds it.
    real enter;
    real leave;
    real e;
    real l;
    slab_interval(o.z, d.z, -solid.tube, solid.tube, e, l);
    float outer = solid.ring + solid.tube;
    quadratic_interval(d.x * d.x + d.y * d.y, -(o.x * d.x + o.y * d.y), o.x * o.x + o.y * o.y - outer * outer, enter,
                       leave);
    enter = max(max(enter, e), ray.t_min);
    leave = min(min(leave, l), ray.t_max);
    alive = mask_and(alive, enter < leave);
    // Most rays pass through the hole: what enters and leaves the disc there never comes near.
    real3 in = o + d * enter;
    real3 out = o + d * leave;
    float inner = solid.ring - solid.tube;
    real farthest = max(in.x * in.x + in.y * in.y, out.x * out.x + out.y * out.y);
    alive = mask_and(alive, farthest > real(inner * inner));
    t = enter;
    float close = solid.tube * 0.02f;
    mask walking = alive;
    mask found = mask(false);
    for (uint step = 0u; step < 40u; step = step + 1u) {
        if (!any_lane(walking)) break;
        real3 p = o + d * t;
        real off = sqrt(p.x * p.x + p.y * p.y) - solid.ring;
        real gap = sqrt(off * off + p.z * p.z) - solid.tube;
        mask here = mask_and(walking, gap < real(close));
        found = mask_or(found, here);
        walking = mask_and(walking, mask_not(here));
        t = select(walking, t + gap, t);
        walking = mask_and(walking, t < leave);
    }
    if (!any_lane(found)) return found;
    for (uint step = 0u; step < 3u; step = step + 1u) {
        real3 p = o + d * t;
        real around = sqrt(p.x * p.x + p.y * p.y);
        real off = around - solid.ring;
        real distance = sqrt(off * off + p.z * p.z);
        real slope = (off * (p.x * d.x + p.y * d.y) / around + p.z * d.z) / distance;
        // Where it only grazes, it stays.
        t = select(slope < real(-0.05f), t - (distance - solid.tube) / slope, t);
    }
    return mask_and(found, mask_and(t > ray.t_min, t < leave));
}

/// True in lanes whose rays come near enough to a solid to be tried on it.
FN mask may_hit(const Solid& s, const Ray& ray) {
    if (s.kind == SolidKind::kPlane) return mask(true);
    real3 f = real3(s.middle) - ray.origin;
    real b = dot(f, ray.direction);
    real c = dot(f, f) - s.radius * s.radius;
    mask reached = b * b > c;
    mask ahead = mask_or(b > real(0.0f), c < real(0.0f));
    // Its near end: b - sqrt(b^2 - c) < t_max, without the root.
    real beyond = b - ray.t_max;
    mask near = mask_or(beyond < real(0.0f), beyond * beyond < b * b - c);
    return mask_and(reached, mask_and(ahead, near));
}

/// One solid's nearest hit in the lanes of `alive`, all of which may_hit() it.
[[gnu::noinline]] inline mask solid_hit(const World& world, const Solid& solid, const Ray& ray, mask alive, real& t,
                                        word& part) {
    part = word(kWhole);
    if (solid.kind == SolidKind::kPlane) return mask_and(alive, intersect_plane(ray, solid.middle, solid.radius, t));
    if (solid.kind == SolidKind::kSphere) {
        real3 normal;
        return mask_and(alive, intersect_sphere(ray, solid.middle, solid.radius, t, normal));
    }
    if (solid.kind == SolidKind::kTorus) return torus_hit(solid, ray, alive, t);
    return carved_hit(world, solid, ray, alive, t, part);
}

/// Outward unit normal (into a cut, for a cut's face) at a point on a solid.
[[gnu::noinline]] inline real3 solid_normal(const World& world, const Solid& solid, word part, const real3& position) {
    if (solid.kind == SolidKind::kPlane) return real3(solid.middle);
    if (solid.kind == SolidKind::kSphere) return (position - real3(solid.middle)) * (1.0f / solid.radius);
    real3 p = to_own_space(solid, position - real3(solid.origin));
    real zero = real(0.0f);
    if (solid.kind == SolidKind::kTorus) {
        real share = 1.0f - solid.ring / max(sqrt(p.x * p.x + p.y * p.y), real(1e-6f));
        return from_own_space(solid, normalize(real3(p.x * share, p.y * share, p.z)));
    }
    real3 n = real3(zero, zero, real(1.0f));
    uint first_cut = solid.first_part + solid.base_count;
    for (uint i = solid.first_part; i < first_cut + solid.cut_count; i = i + 1u) {
        mask here = part == word(i);
        if (!any_lane(here)) continue;
        const Part& shape = world.parts[i];
        real3 f = p - real3(shape.place);
        if (shape.kind == PartKind::kHalfSpace) {
            f = real3(shape.place);
        } else if (shape.kind == PartKind::kBox) {
            real3 a = abs(f) * real3(1.0f / shape.half.x, 1.0f / shape.half.y, 1.0f / shape.half.z);
            mask on_x = mask_and(a.x >= a.y, a.x >= a.z);
            mask on_y = mask_and(mask_not(on_x), a.y >= a.z);
            mask on_z = mask_not(mask_or(on_x, on_y));
            f = real3(select(on_x, f.x, zero), select(on_y, f.y, zero), select(on_z, f.z, zero));
        } else if (shape.kind == PartKind::kTube) {
            if (shape.axis == 0u) f.x = zero;
            if (shape.axis == 1u) f.y = zero;
            if (shape.axis == 2u) f.z = zero;
        }
        if (i >= first_cut) f = -f;
        n = select(here, f, n);
    }
    return from_own_space(solid, normalize(n));
}

}  // namespace sundog::intro
