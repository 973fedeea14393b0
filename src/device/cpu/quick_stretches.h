// SPDX-License-Identifier: Apache-2.0
// The stretches of a packet's rays that lie inside parts of a solid. Formulas and their order are those of
// solids/sphere.cpp, box.cpp, cone.cpp, half_space.cpp and quadric.cpp, so that lanes give the bits of single rays.
// Only units of one width include it.
#pragma once

#include "device/cpu/double_lanes.h"
#include "device/cpu/quick_solid.h"

namespace sundog::kernel {
inline namespace SUNDOG_KERNEL_SPACE {

using cpu::QuickPart;

inline constexpr double kEndless = __builtin_inf();

/// Half of a packet's rays, and the open ranges in which hits count.
struct WideRays {
    wide3 origin, direction;
    wide lower, upper;
    wide_mask asking;  ///< Other lanes hold anything.
};

/// Where rays go into a shape and out of it, and on which of its faces; endless where they don't.
struct WideStretch {
    wide lower, upper, lower_part, upper_part;
    wide_mask misses;   ///< The ray is nowhere inside.
    wide_mask outer;    ///< The ray is inside before `lower` and behind `upper` instead.
    wide_mask unknown;  ///< Lanes that this can't tell of.
};

FN wide3 uniform3(const double* p) { return {wide(p[0]), wide(p[1]), wide(p[2])}; }
FN wide3 carried(const Affine3d& m, wide3 v) {
    return {m.x.x * v.x + m.y.x * v.y + m.z.x * v.z, m.x.y * v.x + m.y.y * v.y + m.z.y * v.z,
            m.x.z * v.x + m.y.z * v.y + m.z.z * v.z};
}
FN wide clamped(wide x, wide lower, wide upper) { return select(x < lower, lower, select(upper < x, upper, x)); }

FN void set_ends(wide lower, wide upper, WideStretch& out) {
    out.lower = lower;
    out.upper = upper;
    out.lower_part = out.upper_part = wide(0.0);
    out.misses = out.outer = out.unknown = mask_of(0);
}

FN void set_missed(WideStretch& out) {
    set_ends(wide(kEndless), wide(-kEndless), out);
    out.misses = mask_of((1U << kWideLanes) - 1U);
}

FN void sphere_stretch(const double* p, const wide3& o, const wide3& d, wide_mask asking, WideStretch& out) {
    const wide3 center = uniform3(p);
    const wide radius(p[3]);
    const wide a = dot(d, d);
    const wide middle = dot(center - o, d) / a;
    const wide3 offset = o + d * middle - center;
    const wide discriminant = radius * radius - dot(offset, offset);
    const wide_mask meets = discriminant > wide(0.0);
    if (!any_lane(meets & asking)) return set_missed(out);
    const wide half = sqrt(select(meets, discriminant, wide(0.0)) / a);
    set_ends(middle - half, middle + half, out);
    out.misses = ~meets;
}

FN void box_stretch(const double* p, const wide3& o, const wide3& d, WideStretch& out) {
    set_ends(wide(-kEndless), wide(kEndless), out);
    const wide zero(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const wide from = axis == 0 ? o.x : axis == 1 ? o.y : o.z;
        const wide along = axis == 0 ? d.x : axis == 1 ? d.y : d.z;
        const wide_mask beside = along == zero;
        const wide_mask between = (from > wide(p[axis])) & (from < wide(p[axis + 3]));
        out.misses = out.misses | (beside & ~between);
        const wide t_lower = (wide(p[axis]) - from) / along;
        const wide t_upper = (wide(p[axis + 3]) - from) / along;
        const wide_mask forward = along > zero;
        const wide first = select(forward, t_lower, t_upper);
        const wide second = select(forward, t_upper, t_lower);
        const wide_mask later = (first > out.lower) & ~beside;
        const wide_mask earlier = (second < out.upper) & ~beside;
        out.lower = select(later, first, out.lower);
        out.upper = select(earlier, second, out.upper);
        const wide low_face(2.0 * axis);
        const wide high_face(2.0 * axis + 1);
        out.lower_part = select(later, select(forward, low_face, high_face), out.lower_part);
        out.upper_part = select(earlier, select(forward, high_face, low_face), out.upper_part);
    }
    out.misses = out.misses | ~(out.lower < out.upper);
}

FN void half_space_stretch(const double* p, const wide3& o, const wide3& d, wide start, WideStretch& out) {
    const wide3 normal = uniform3(p);
    const wide distance(p[3]);
    const wide zero(0.0);
    const wide speed = dot(normal, d);
    const wide t = (distance - dot(normal, o)) / speed;
    set_ends(select(speed < zero, t, wide(-kEndless)), select(speed > zero, t, wide(kEndless)), out);
    out.misses = (speed == zero) & ~(dot(normal, o + d * start) < distance);
}

/// What is behind the disc's plane; off the disc that has face 1.
FN void disc_stretch(const double* p, const wide3& o, const wide3& d, wide start, WideStretch& out) {
    const wide3 center = uniform3(p);
    const wide3 normal = uniform3(p + 3);
    const wide zero(0.0);
    const wide speed = dot(normal, d);
    const wide t = dot(normal, center - o) / speed;
    set_ends(select(speed < zero, t, wide(-kEndless)), select(speed > zero, t, wide(kEndless)), out);
    out.misses = (speed == zero) & ~(dot(normal, o + d * start - center) < zero);
    const wide3 from_center = o + d * t - center;
    const wide squared = dot(from_center, from_center);
    const wide_mask on_disc = (squared <= wide(p[6] * p[6])) & (squared >= wide(p[7] * p[7]));
    out.lower_part = out.upper_part = select(on_disc, zero, wide(1.0));
}

FN void cone_stretch(const double* p, const wide3& o, const wide3& d, wide_mask asking, WideStretch& out) {
    const wide3 base = uniform3(p);
    const double height = p[3];
    const wide3 axis = uniform3(p + 4);
    const double base_radius = p[7];
    const double slope = p[8];
    const wide zero(0.0);
    const wide end(height);
    // Between the end planes.
    const wide z_from = dot(o - base, axis);
    const wide dz = dot(d, axis);
    const wide_mask level = dz == zero;
    const wide_mask up = dz > zero;
    const wide t_base = (zero - z_from) / dz;
    const wide t_cap = (end - z_from) / dz;
    const wide enter = select(level, wide(-kEndless), select(up, t_base, t_cap));
    const wide leave = select(level, wide(kEndless), select(up, t_cap, t_base));
    out.misses = level & ~((z_from > zero) & (z_from < end));
    const wide t_near = clamped(dot(base + axis * wide(height / 2) - o, d) / dot(d, d), enter, leave);
    const wide3 from_base = o + d * t_near - base;
    const wide z = dot(from_base, axis);
    const wide3 off_axis = from_base - axis * z;
    const wide3 d_off_axis = d - axis * dz;
    const wide radius = base_radius + slope * z;
    const wide d_radius = slope * dz;
    const wide a = dot(d_off_axis, d_off_axis) - d_radius * d_radius;
    const wide b = dot(off_axis, d_off_axis) - radius * d_radius;
    const wide c = dot(off_axis, off_axis) - radius * radius;
    const wide discriminant = b * b - a * c;
    const wide_mask meets = discriminant > zero;
    if (!any_lane((meets | (a <= zero)) & ~out.misses & asking)) return set_missed(out);
    const wide root = sqrt(select(meets, discriminant, zero));
    const wide q = -(b + select(b < zero, -root, root));
    const wide s0 = q / a;
    const wide s1 = select(q == zero, -s0, c / q);
    const wide first = t_near + min(s0, s1);
    const wide second = t_near + max(s0, s1);
    wide_mask at_enter = enter >= first;
    wide_mask at_leave = leave <= second;
    out.lower = select(at_enter, enter, first);
    out.upper = select(at_leave, leave, second);
    wide_mask beside = ~meets;
    wide_mask torn = mask_of(0);
    const wide_mask steep = a < zero;
    if (slope != 0 && any_lane(steep & asking)) {
        // Where a ray runs steeper than the side, inside is what lies before its first crossing and behind its second.
        const wide_mask before = enter < min(first, leave);
        const wide_mask behind = max(enter, second) < leave;
        at_enter = (steep & (~meets | before | (enter >= second))) | (~steep & at_enter);
        at_leave = (steep & (~meets | behind | (leave <= first))) | (~steep & at_leave);
        out.lower = select(at_enter, enter, select(steep, second, first));
        out.upper = select(at_leave, leave, select(steep, first, second));
        beside = beside & ~steep;
        torn = steep & meets & before & behind;
    }
    out.lower_part = select(at_enter, select(up, wide(1.0), wide(2.0)), zero);
    out.upper_part = select(at_leave, select(up, wide(2.0), wide(1.0)), zero);
    // Along the side or the axis: as far as the end planes say.
    const wide_mask along = a == zero;
    out.misses = out.misses | (~along & (beside | ~(out.lower < out.upper)));
    out.unknown = along & ~out.misses;
    // The two parts of what is inside touch in the apex, where open cones have an end that isn't seen.
    if (p[9] != 0) out.unknown = out.unknown | torn;
    out.outer = mask_of(0);
    out.lower = select(along, enter, out.lower);
    out.upper = select(along, leave, out.upper);
}

FN void quadric_stretch(const double* p, const wide3& o, const wide3& d, const WideRays& rays, WideStretch& out) {
    const wide3 row_x{wide(p[0]), wide(p[3]), wide(p[4])};
    const wide3 row_y{wide(p[3]), wide(p[1]), wide(p[5])};
    const wide3 row_z{wide(p[4]), wide(p[5]), wide(p[2])};
    const auto squared = [&](wide3 v) { return wide3{dot(row_x, v), dot(row_y, v), dot(row_z, v)}; };
    const wide3 linear = uniform3(p + 6);
    const wide zero(0.0);
    const wide t_near = clamped(-dot(o, d) / dot(d, d), rays.lower, rays.upper);
    const wide3 at = o + d * t_near;
    const wide3 squared_d = squared(d);
    const wide a = dot(d, squared_d);
    const wide b = wide(2.0) * dot(at, squared_d) + dot(linear, d);
    const wide c = dot(at, squared(at) + linear) + wide(p[9]);
    const wide discriminant = b * b - wide(4.0) * a * c;
    const wide_mask meets = discriminant > zero;
    if (!any_lane((meets | (a <= zero)) & rays.asking)) return set_missed(out);
    const wide root = sqrt(select(meets, discriminant, zero));
    const wide q = wide(-0.5) * (b + select(b < zero, -root, root));
    const wide s0 = q / a;
    const wide s1 = select(q == zero, -s0, c / q);
    set_ends(t_near + min(s0, s1), t_near + max(s0, s1), out);
    out.unknown = a == zero;
    out.outer = a < zero;
    const wide_mask everywhere = out.unknown | (out.outer & ~meets);
    out.outer = out.outer & meets;
    out.misses = ~meets & ~everywhere;
    out.lower = select(everywhere, wide(-kEndless), out.lower);
    out.upper = select(everywhere, wide(kEndless), out.upper);
}

/// A stretch around all of a torus: between the planes that it touches, in the cylinder around it, and not all of the
/// way in its hole.
FN void torus_stretch(const double* p, const wide3& o, const wide3& d, const WideRays& rays, WideStretch& out) {
    const double outer = p[0] + p[1];
    const double hole = p[0] - p[1];
    const double room = 1e-6 * outer;
    const wide zero(0.0);
    const wide reach(p[1] + room);
    const wide_mask level = d.y == zero;
    const wide t_a = (-reach - o.y) / d.y;
    const wide t_b = (reach - o.y) / d.y;
    wide lower = select(level, wide(-kEndless), min(t_a, t_b));
    wide upper = select(level, wide(kEndless), max(t_a, t_b));
    out.misses = level & ~(abs(o.y) < reach);
    // Around the axis, from the point that is nearest to it.
    const wide a = d.x * d.x + d.z * d.z;
    const wide_mask upright = a == zero;
    const wide middle = select(upright, zero, -(o.x * d.x + o.z * d.z) / a);
    const wide x = o.x + d.x * middle;
    const wide z = o.z + d.z * middle;
    const wide discriminant = wide((outer + room) * (outer + room)) - (x * x + z * z);
    out.misses = out.misses | ~(discriminant > zero);
    const wide half = sqrt(max(discriminant, zero) / a);
    lower = max(rays.lower, select(upright, lower, max(lower, middle - half)));
    upper = min(rays.upper, select(upright, upper, min(upper, middle + half)));
    if (hole > room) {
        const auto in_hole = [&](wide t) {
            const wide x_t = o.x + d.x * t;
            const wide z_t = o.z + d.z * t;
            return x_t * x_t + z_t * z_t < wide((hole - room) * (hole - room));
        };
        out.misses = out.misses | (in_hole(lower) & in_hole(upper));
    }
    if (any_lane(~out.misses & (lower <= upper) & rays.asking)) {
        // The polynomial that is negative inside (torus.cpp), in units of the torus and of this stretch: where all of
        // its Bernstein coefficients are positive, so is it.
        const double unit = 1 / outer;
        const double big = p[0] * unit;
        const double k = 4 * big * big;
        const wide3 q = (o + d * lower) * wide(unit);
        const wide3 e = d * ((upper - lower) * wide(unit));
        const wide a2 = dot(e, e);
        const wide b2 = dot(q, e);
        const wide c2 = dot(q, q) + wide(hole * unit);
        const wide c0 = c2 * c2 - wide(k) * (q.x * q.x + q.z * q.z);
        const wide c1 = b2 * c2 - wide(0.5 * k) * (q.x * e.x + q.z * e.z);  // a quarter of the power coefficient
        const wide sixth =
            (wide(4.0) * b2 * b2 + wide(2.0) * a2 * c2 - wide(k) * (e.x * e.x + e.z * e.z)) * wide(1.0 / 6);
        const wide quarter = a2 * b2;
        const wide first = c0 + c1;
        const wide second = first + c1 + sixth;
        const wide third = second + c1 + wide(2.0) * sixth + quarter;
        const wide last = c0 + wide(4.0) * c1 + wide(6.0) * sixth + wide(4.0) * quarter + a2 * a2;
        out.misses = out.misses | (min(min(c0, first), min(min(second, third), last)) > wide(1e-9));
    }
    out.lower = lower;
    out.upper = upper;
    out.lower_part = out.upper_part = zero;
    out.unknown = out.outer = mask_of(0);
}

FN void shape_stretch(const QuickPart& part, const WideRays& rays, WideStretch& out) {
    const Affine3d& m = part.shape_from_world;
    const wide3 o = carried(m, rays.origin) + wide3{wide(m.t.x), wide(m.t.y), wide(m.t.z)};
    const wide3 d = carried(m, rays.direction);
    const double* p = part.numbers.data();
    switch (part.kind) {
        case QuickPart::Kind::sphere:
            return sphere_stretch(p, o, d, rays.asking, out);
        case QuickPart::Kind::box:
            return box_stretch(p, o, d, out);
        case QuickPart::Kind::half_space:
            return half_space_stretch(p, o, d, rays.lower, out);
        case QuickPart::Kind::cone:
            return cone_stretch(p, o, d, rays.asking, out);
        case QuickPart::Kind::quadric:
            return quadric_stretch(p, o, d, rays, out);
        case QuickPart::Kind::disc:
            return disc_stretch(p, o, d, rays.lower, out);
        case QuickPart::Kind::torus:
            return torus_stretch(p, o, d, rays, out);
        case QuickPart::Kind::anything:
            set_ends(wide(-kEndless), wide(kEndless), out);
    }
}

/// Normals of an exact part, of any length and outward, where rays meet its faces; as the shapes' own normal().
FN wide3 shape_normal(const QuickPart& part, const wide3& at, wide face) {
    const double* p = part.numbers.data();
    const wide zero(0.0);
    switch (part.kind) {
        case QuickPart::Kind::sphere:
            return at - uniform3(p);
        case QuickPart::Kind::box: {
            const auto along = [&](double low) {
                return select(face == wide(low), wide(-1.0), select(face == wide(low + 1), wide(1.0), zero));
            };
            return {along(0), along(2), along(4)};
        }
        case QuickPart::Kind::cone: {
            const wide3 axis = uniform3(p + 4);
            const double slope = p[8];
            const wide3 from_base = at - uniform3(p);
            const wide3 off_axis = from_base - axis * dot(from_base, axis);
            const wide off = sqrt(dot(off_axis, off_axis));
            const wide3 side = off_axis - axis * (wide(slope) * off);
            const wide along = select(face == wide(1.0), wide(-1.0),
                                      select(face == wide(2.0), wide(1.0), wide(slope < 0 ? 1.0 : -1.0)));
            const wide_mask on_side = (face == zero) & (off > zero);
            return {select(on_side, side.x, axis.x * along), select(on_side, side.y, axis.y * along),
                    select(on_side, side.z, axis.z * along)};
        }
        case QuickPart::Kind::quadric: {
            const wide3 row_x{wide(p[0]), wide(p[3]), wide(p[4])};
            const wide3 row_y{wide(p[3]), wide(p[1]), wide(p[5])};
            const wide3 row_z{wide(p[4]), wide(p[5]), wide(p[2])};
            return wide3{dot(row_x, at), dot(row_y, at), dot(row_z, at)} * wide(2.0) + uniform3(p + 6);
        }
        case QuickPart::Kind::disc:
            return uniform3(p + 3);
        default:
            return uniform3(p);
    }
}

/// Unit normals in the world, towards where rays come from in the lanes of `faces_ray` and away from there in others.
/// False lanes of `fine` are those whose slopes are too steep or flat for this.
FN wide3 part_normal(const QuickPart& part, const WideRays& rays, wide t, wide face, wide_mask faces_ray,
                     wide_mask& fine) {
    const Affine3d& m = part.shape_from_world;
    const wide3 o = carried(m, rays.origin) + wide3{wide(m.t.x), wide(m.t.y), wide(m.t.z)};
    const wide3 n = shape_normal(part, o + carried(m, rays.direction) * t, face);
    const wide squared = dot(n, n);
    fine = (squared > wide(1e-60)) & (squared < wide(1e60));
    const wide3 column_x{wide(m.x.x), wide(m.x.y), wide(m.x.z)};
    const wide3 column_y{wide(m.y.x), wide(m.y.y), wide(m.y.z)};
    const wide3 column_z{wide(m.z.x), wide(m.z.y), wide(m.z.z)};
    const wide3 in_world{dot(column_x, n), dot(column_y, n), dot(column_z, n)};
    const wide length = sqrt(dot(in_world, in_world));
    fine = fine & (length > wide(0.0));
    const wide3 unit{in_world.x / length, in_world.y / length, in_world.z / length};
    // As CompiledSolid::hit_of turns it: first as the part is inverted, which decides where it is across the ray.
    const wide sign(part.flips ? -1.0 : 1.0);
    const wide3 turned = unit * sign;
    const wide_mask against = dot(turned, rays.direction) < wide(0.0);
    const wide_mask agrees = (against & faces_ray) | (~against & ~faces_ray);
    return turned * select(agrees, wide(1.0), wide(-1.0));
}

/// The stretches of rays that are inside a part; of one that isn't exact, `unknown` where it may be in the rays'
/// ranges.
inline void part_stretch(const QuickPart& part, const WideRays& rays, WideStretch& out) {
    shape_stretch(part, rays, out);
    if (part.exact) return;
    out.misses = out.misses | ~(max(out.lower, rays.lower) <= min(out.upper, rays.upper));
    out.unknown = ~out.misses;
}

}  // namespace SUNDOG_KERNEL_SPACE
}  // namespace sundog::kernel
