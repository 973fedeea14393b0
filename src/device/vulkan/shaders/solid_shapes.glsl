// SPDX-License-Identifier: Apache-2.0
// The shapes that exact solids consist of, in double precision: where a ray meets them, what is inside, normals, texture
// coordinates. What src/solids computes, in the same way, for each kind; `numbers` is where a shape's numbers begin.
#include "device/vulkan/shaders/polynomial_roots.glsl"

/// Which SHAPE_* kinds the scene's solids consist of, as bits.
layout(constant_id = 4) const uint solid_kinds = 0u;

bool is_kind(uint kind, uint wanted) { return (solid_kinds & (1u << wanted)) != 0u && kind == wanted; }

double solid_number(uint place) { return solid_slots[place]; }
dvec3 solid_vector(uint place) { return dvec3(solid_slots[place], solid_slots[place + 1u], solid_slots[place + 2u]); }

/// A ray, and the part of it that is asked about: shapes see no more of it, so that what they find is the same however
/// far the search has come.
struct SolidRay {
    dvec3 origin, direction;
    double from, to;
};

const uint CROSSING_TOGGLES = 1u;  ///< The ray changes between inside and outside; a mere surface has no inside.
const uint CROSSING_VISIBLE = 2u;  ///< A surface is there; not where an open shape lacks its end.
const uint CROSSING_ENTERS = 4u;   ///< From outside to inside.

/// A place where a ray meets a shape's boundary.
struct SolidCrossing {
    double t;
    double u;    ///< The shape's own: where on the part.
    uint part;   ///< The shape's own: which of its faces or segments.
    uint flags;  ///< CROSSING_*
    uint leaf;   ///< Which node.
};

/// The crossing that comes next after `after`: in t, and where t is the same, in the order of the leaves.
struct SolidSearch {
    double after;
    bool with_ties;  ///< A crossing at `after` itself comes next, too.
    uint leaf;       ///< Whose crossings are being told.
    SolidCrossing next;
    bool odd;  ///< See tell_parity().
};

void tell_crossing(double t, double u, uint part, uint flags, inout SolidSearch search) {
    if ((t > search.after || (search.with_ties && t == search.after)) && t < search.next.t)
        search.next = SolidCrossing(t, u, part, flags, search.leaf);
}

const uint SOLID_FACE = CROSSING_TOGGLES | CROSSING_VISIBLE;

/// The same for shapes whose crossings aren't told in order: from the ray's far end, outside, each one leads from
/// outside to inside or back. Between begin_parity() and end_parity().
void tell_parity(double t, double u, uint part, bool visible, inout SolidSearch search) {
    bool ahead = t > search.after || (search.with_ties && t == search.after);
    if (!ahead) search.odd = !search.odd;
    tell_crossing(t, u, part, visible ? SOLID_FACE : CROSSING_TOGGLES, search);
}
void begin_parity(inout SolidSearch search) { search.odd = false; }
void end_parity(inout SolidSearch search) {
    if (search.next.leaf == search.leaf && !search.odd) search.next.flags |= CROSSING_ENTERS;
}

/// An end of an interval.
struct SolidEnd {
    double t;
    uint part;
    bool visible;
};

void tell_interval(SolidEnd lower, SolidEnd upper, inout SolidSearch search) {
    if (!(lower.t < upper.t)) return;
    uint seen = lower.visible ? SOLID_FACE : CROSSING_TOGGLES;
    tell_crossing(lower.t, 0.0lf, lower.part, seen | CROSSING_ENTERS, search);
    tell_crossing(upper.t, 0.0lf, upper.part, upper.visible ? SOLID_FACE : CROSSING_TOGGLES, search);
}

const double SOLID_FAR = 1e300lf;

void sphere_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    dvec3 center = solid_vector(numbers);
    double radius = solid_number(numbers + 3u);
    double a = dot(ray.direction, ray.direction);
    double middle = dot(center - ray.origin, ray.direction) / a;
    dvec3 offset = ray.origin + ray.direction * middle - center;
    double discriminant = radius * radius - dot(offset, offset);
    if (!(discriminant > 0.0lf)) return;
    double half_way = sqrt(discriminant / a);
    tell_interval(SolidEnd(middle - half_way, 0u, true), SolidEnd(middle + half_way, 0u, true), search);
}

// Parts are faces: twice the axis, plus one for the upper side.
void box_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    dvec3 lower = solid_vector(numbers);
    dvec3 upper = solid_vector(numbers + 3u);
    SolidEnd enter = SolidEnd(-SOLID_FAR, 0u, true);
    SolidEnd leave = SolidEnd(SOLID_FAR, 0u, true);
    for (uint axis = 0u; axis < 3u; ++axis) {
        double o = ray.origin[axis];
        double d = ray.direction[axis];
        if (d == 0.0lf) {
            if (!(o > lower[axis] && o < upper[axis])) return;
            continue;
        }
        bool rises = d > 0.0lf;
        double first = ((rises ? lower[axis] : upper[axis]) - o) / d;
        double second = ((rises ? upper[axis] : lower[axis]) - o) / d;
        if (first > enter.t) enter = SolidEnd(first, 2u * axis + (rises ? 0u : 1u), true);
        if (second < leave.t) leave = SolidEnd(second, 2u * axis + (rises ? 1u : 0u), true);
    }
    tell_interval(enter, leave, search);
    if (enter.t != leave.t) return;
    // A box without thickness is a surface, as povray shows it.
    for (uint axis = 0u; axis < 3u; ++axis) {
        if (lower[axis] != upper[axis] || ray.direction[axis] == 0.0lf) continue;
        if ((lower[axis] - ray.origin[axis]) / ray.direction[axis] != enter.t) continue;
        tell_crossing(enter.t, 0.0lf, 2u * axis + (ray.direction[axis] > 0.0lf ? 0u : 1u), CROSSING_VISIBLE, search);
        break;
    }
}

void half_space_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    dvec3 normal = solid_vector(numbers);
    double speed = dot(normal, ray.direction);
    if (speed == 0.0lf) return;
    double t = (solid_number(numbers + 3u) - dot(normal, ray.origin)) / speed;
    tell_crossing(t, 0.0lf, 0u, speed < 0.0lf ? SOLID_FACE | CROSSING_ENTERS : SOLID_FACE, search);
}

// Part of a plane is to be seen; inside is all that lies behind the plane.
void disc_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    dvec3 center = solid_vector(numbers);
    dvec3 normal = solid_vector(numbers + 3u);
    double radius = solid_number(numbers + 6u);
    double hole = solid_number(numbers + 7u);
    double speed = dot(normal, ray.direction);
    if (speed == 0.0lf) return;
    double t = dot(normal, center - ray.origin) / speed;
    dvec3 from_center = ray.origin + ray.direction * t - center;
    double square = dot(from_center, from_center);
    uint flags = square <= radius * radius && square >= hole * hole ? SOLID_FACE : CROSSING_TOGGLES;
    tell_crossing(t, 0.0lf, 0u, speed < 0.0lf ? flags | CROSSING_ENTERS : flags, search);
}

const uint CONE_BASE = 1u;  // the side is 0
const uint CONE_CAP = 2u;

SolidEnd later_end(SolidEnd a, SolidEnd b) { return a.t >= b.t ? a : b; }
SolidEnd earlier_end(SolidEnd a, SolidEnd b) { return b.t <= a.t ? b : a; }

// Between the two end planes, and nearer to the axis than a radius that is linear along it.
void cone_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    dvec3 base = solid_vector(numbers);
    double height = solid_number(numbers + 3u);
    dvec3 axis = solid_vector(numbers + 4u);
    double base_radius = solid_number(numbers + 7u);
    double slope = solid_number(numbers + 8u);
    bool closed = solid_number(numbers + 9u) == 0.0lf;
    double start = dot(ray.origin - base, axis);
    double dz = dot(ray.direction, axis);
    SolidEnd enter = SolidEnd(-SOLID_FAR, CONE_BASE, closed);
    SolidEnd leave = SolidEnd(SOLID_FAR, CONE_CAP, closed);
    if (dz == 0.0lf) {
        if (!(start > 0.0lf && start < height)) return;
    } else {
        enter = SolidEnd(((dz > 0.0lf ? 0.0lf : height) - start) / dz, dz > 0.0lf ? CONE_BASE : CONE_CAP, closed);
        leave = SolidEnd(((dz > 0.0lf ? height : 0.0lf) - start) / dz, dz > 0.0lf ? CONE_CAP : CONE_BASE, closed);
    }
    // Seen from the ray's point nearest to the frustum's middle, rounding is least.
    dvec3 to_middle = base + axis * (0.5lf * height) - ray.origin;
    double near =
        clamp(dot(to_middle, ray.direction) / dot(ray.direction, ray.direction), enter.t, max(enter.t, leave.t));
    dvec3 from_base = ray.origin + ray.direction * near - base;
    double z = dot(from_base, axis);
    dvec3 off_axis = from_base - axis * z;
    dvec3 d_off_axis = ray.direction - axis * dz;
    double radius = base_radius + slope * z;
    double d_radius = slope * dz;
    // a*s^2 + 2*b*s + c < 0 is inside, t = near + s.
    double a = dot(d_off_axis, d_off_axis) - d_radius * d_radius;
    double b = dot(off_axis, d_off_axis) - radius * d_radius;
    double c = dot(off_axis, off_axis) - radius * radius;
    double discriminant = b * b - a * c;
    if (a == 0.0lf && b == 0.0lf) {
        if (c < 0.0lf) tell_interval(enter, leave, search);
    } else if (a == 0.0lf) {
        SolidEnd root = SolidEnd(near - c / (2.0lf * b), 0u, true);
        if (b > 0.0lf) tell_interval(enter, earlier_end(root, leave), search);
        else tell_interval(later_end(enter, root), leave, search);
    } else if (!(discriminant > 0.0lf)) {
        if (a < 0.0lf) tell_interval(enter, leave, search);
    } else {
        double q = -(b + (b < 0.0lf ? -sqrt(discriminant) : sqrt(discriminant)));
        double s0 = q / a;
        double s1 = q != 0.0lf ? c / q : -s0;
        SolidEnd first = SolidEnd(near + min(s0, s1), 0u, true);
        SolidEnd second = SolidEnd(near + max(s0, s1), 0u, true);
        if (a > 0.0lf) {
            tell_interval(later_end(enter, first), earlier_end(second, leave), search);
        } else {
            tell_interval(enter, earlier_end(first, leave), search);
            tell_interval(later_end(enter, second), leave, search);
        }
    }
}

dvec3 quadric_squared(uint numbers, dvec3 v) {
    dvec3 diagonal = solid_vector(numbers);
    dvec3 mixed = solid_vector(numbers + 3u);  // xy, xz, yz
    return dvec3(diagonal.x * v.x + mixed.x * v.y + mixed.y * v.z, mixed.x * v.x + diagonal.y * v.y + mixed.z * v.z,
                 mixed.y * v.x + mixed.z * v.y + diagonal.z * v.z);
}
double quadric_value(uint numbers, dvec3 p) {
    return dot(p, quadric_squared(numbers, p) + solid_vector(numbers + 6u)) + solid_number(numbers + 9u);
}

void quadric_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    // From the point nearest to the origin, about which such shapes lie, rounding is least.
    dvec3 d = ray.direction;
    double near = clamp(-dot(ray.origin, d) / dot(d, d), ray.from, ray.to);
    dvec3 p = ray.origin + d * near;
    dvec3 squared_d = quadric_squared(numbers, d);
    double a = dot(d, squared_d);
    double b = 2.0lf * dot(p, squared_d) + dot(solid_vector(numbers + 6u), d);
    double c = quadric_value(numbers, p);
    if (a == 0.0lf) {
        if (b != 0.0lf)
            tell_crossing(near - c / b, 0.0lf, 0u, b < 0.0lf ? SOLID_FACE | CROSSING_ENTERS : SOLID_FACE, search);
        return;
    }
    double discriminant = b * b - 4.0lf * a * c;
    if (!(discriminant > 0.0lf)) return;
    double q = -0.5lf * (b + (b < 0.0lf ? -sqrt(discriminant) : sqrt(discriminant)));
    double s0 = q / a;
    double s1 = q != 0.0lf ? c / q : -s0;
    // Between the roots the polynomial's sign is the opposite of a's.
    tell_crossing(near + min(s0, s1), 0.0lf, 0u, a > 0.0lf ? SOLID_FACE | CROSSING_ENTERS : SOLID_FACE, search);
    tell_crossing(near + max(s0, s1), 0.0lf, 0u, a > 0.0lf ? SOLID_FACE : SOLID_FACE | CROSSING_ENTERS, search);
}

/// The part of a ray that is in a box, as its lower and upper t; none where the first is the larger.
dvec2 clip_to_box(dvec3 lower, dvec3 upper, SolidRay ray) {
    dvec2 part = dvec2(ray.from, ray.to);
    for (uint axis = 0u; axis < 3u; ++axis) {
        double o = ray.origin[axis];
        double d = ray.direction[axis];
        if (d == 0.0lf) {
            if (o < lower[axis] || o > upper[axis]) return dvec2(1.0lf, 0.0lf);
            continue;
        }
        double t0 = (lower[axis] - o) / d;
        double t1 = (upper[axis] - o) / d;
        part = dvec2(max(part.x, min(t0, t1)), min(part.y, max(t0, t1)));
    }
    return part;
}

// Inside where (|p|^2 + R^2 - r^2)^2 < 4*R^2*(x^2 + z^2).
void torus_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    double major = solid_number(numbers);
    double minor = solid_number(numbers + 1u);
    double reach = (major + minor) * (1.0lf + 1e-6lf);
    double thick = minor + 1e-6lf * (major + minor);
    dvec3 corner = dvec3(reach, thick, reach);
    dvec2 part = clip_to_box(-corner, corner, ray);
    if (!(part.x < part.y)) return;
    // In units of the torus and of the way through its box, where all coefficients are of one size.
    double unit = 1.0lf / (major + minor);
    dvec3 o = (ray.origin + ray.direction * part.x) * unit;
    dvec3 d = ray.direction * ((part.y - part.x) * unit);
    double big = major * unit;
    double small = minor * unit;
    double a = dot(d, d);
    double b = dot(o, d);
    double c = dot(o, o) + (big - small) * (big + small);
    double k = 4.0lf * big * big;
    double quartic[MOST_DEGREE + 1u];
    quartic[0] = c * c - k * (o.x * o.x + o.z * o.z);
    quartic[1] = 4.0lf * b * c - 2.0lf * k * (o.x * d.x + o.z * d.z);
    quartic[2] = 4.0lf * b * b + 2.0lf * a * c - k * (d.x * d.x + d.z * d.z);
    quartic[3] = 4.0lf * a * b;
    quartic[4] = a * a;
    double roots[MOST_DEGREE];
    uint count = roots_in_unit(quartic, 4u, roots);
    bool enters = !(quartic[0] < 0.0lf);
    for (uint i = 0u; i < count; ++i) {
        tell_crossing(part.x + roots[i] * (part.y - part.x), 0.0lf, 0u,
                      enters ? SOLID_FACE | CROSSING_ENTERS : SOLID_FACE, search);
        enters = !enters;
    }
}

#include "device/vulkan/shaders/solid_blobs.glsl"
#include "device/vulkan/shaders/solid_curves.glsl"
#include "device/vulkan/shaders/solid_polynomials.glsl"

/// Tells all crossings of a shape with the ray in its own space.
void shape_crossings(uint kind, uint numbers, SolidRay ray, inout SolidSearch search) {
    if (is_kind(kind, SHAPE_SPHERE)) sphere_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_BOX)) box_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_HALF_SPACE)) half_space_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_CONE)) cone_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_QUADRIC)) quadric_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_DISC)) disc_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_TORUS)) torus_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_POLYNOMIAL)) polynomial_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_POLYGON)) polygon_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_PRISM)) prism_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_REVOLUTION)) revolution_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_LATHE)) lathe_crossings(numbers, ray, search);
    if (is_kind(kind, SHAPE_BLOB)) blob_crossings(numbers, ray, search);
}

/// Whether a point is inside; never for mere surfaces.
bool inside_shape(uint kind, uint numbers, dvec3 p) {
    if (is_kind(kind, SHAPE_SPHERE)) {
        dvec3 off = p - solid_vector(numbers);
        double radius = solid_number(numbers + 3u);
        return dot(off, off) < radius * radius;
    }
    if (is_kind(kind, SHAPE_BOX))
        return all(greaterThan(p, solid_vector(numbers))) && all(lessThan(p, solid_vector(numbers + 3u)));
    if (is_kind(kind, SHAPE_HALF_SPACE)) return dot(solid_vector(numbers), p) < solid_number(numbers + 3u);
    if (is_kind(kind, SHAPE_CONE)) {
        dvec3 axis = solid_vector(numbers + 4u);
        dvec3 from_base = p - solid_vector(numbers);
        double z = dot(from_base, axis);
        if (!(z > 0.0lf && z < solid_number(numbers + 3u))) return false;
        dvec3 off_axis = from_base - axis * z;
        double radius = solid_number(numbers + 7u) + solid_number(numbers + 8u) * z;
        return dot(off_axis, off_axis) < radius * radius;
    }
    if (is_kind(kind, SHAPE_QUADRIC)) return quadric_value(numbers, p) < 0.0lf;
    if (is_kind(kind, SHAPE_DISC)) return dot(solid_vector(numbers + 3u), p - solid_vector(numbers)) < 0.0lf;
    if (is_kind(kind, SHAPE_TORUS)) {
        double major = solid_number(numbers);
        double minor = solid_number(numbers + 1u);
        double k = dot(p, p) + (major - minor) * (major + minor);
        return abs(k) < 2.0lf * major * sqrt(p.x * p.x + p.z * p.z);
    }
    if (is_kind(kind, SHAPE_POLYNOMIAL)) return polynomial_value(numbers, p) < 0.0lf;
    if (is_kind(kind, SHAPE_PRISM)) return prism_inside(numbers, p);
    if (is_kind(kind, SHAPE_REVOLUTION)) return revolution_inside(numbers, p);
    if (is_kind(kind, SHAPE_LATHE)) return lathe_inside(numbers, p);
    if (is_kind(kind, SHAPE_BLOB)) return blob_inside(numbers, p);
    return false;
}

/// Normal at a crossing, of any length; outward, unless the shape can't tell (then the ray's passage decides).
dvec3 shape_normal(uint kind, uint numbers, dvec3 p, SolidCrossing crossing) {
    if (is_kind(kind, SHAPE_SPHERE)) return p - solid_vector(numbers);
    if (is_kind(kind, SHAPE_BOX)) {
        dvec3 n = dvec3(0.0lf);
        n[crossing.part / 2u] = (crossing.part & 1u) != 0u ? 1.0lf : -1.0lf;
        return n;
    }
    if (is_kind(kind, SHAPE_HALF_SPACE)) return solid_vector(numbers);
    if (is_kind(kind, SHAPE_CONE)) {
        dvec3 axis = solid_vector(numbers + 4u);
        if (crossing.part == CONE_BASE) return -axis;
        if (crossing.part == CONE_CAP) return axis;
        double slope = solid_number(numbers + 8u);
        dvec3 from_base = p - solid_vector(numbers);
        dvec3 off_axis = from_base - axis * dot(from_base, axis);
        double off = length(off_axis);
        return off > 0.0lf ? off_axis - axis * (slope * off) : axis * (slope < 0.0lf ? 1.0lf : -1.0lf);
    }
    if (is_kind(kind, SHAPE_QUADRIC)) return quadric_squared(numbers, p) * 2.0lf + solid_vector(numbers + 6u);
    if (is_kind(kind, SHAPE_DISC)) return solid_vector(numbers + 3u);
    if (is_kind(kind, SHAPE_TORUS)) {
        double major = solid_number(numbers);
        double minor = solid_number(numbers + 1u);
        double k = dot(p, p) + (major - minor) * (major + minor);
        double flat_part = k - 2.0lf * major * major;
        return dvec3(p.x * flat_part, p.y * k, p.z * flat_part);
    }
    if (is_kind(kind, SHAPE_POLYNOMIAL)) return polynomial_gradient(numbers, p);
    if (is_kind(kind, SHAPE_POLYGON)) return solid_vector(numbers);
    if (is_kind(kind, SHAPE_PRISM)) return prism_normal(numbers, crossing);
    if (is_kind(kind, SHAPE_REVOLUTION)) return revolution_normal(numbers, p, crossing);
    if (is_kind(kind, SHAPE_LATHE)) return lathe_normal(numbers, p, crossing);
    if (is_kind(kind, SHAPE_BLOB)) return blob_normal(numbers, p);
    return dvec3(0.0lf, 1.0lf, 0.0lf);
}

float turn_around_y(vec3 n) {
    float u = atan(n.z, n.x) * 0.159154943f;
    return u < 0.0f ? u + 1.0f : u;
}

/// Texture coordinates as POV-Ray's uv_mapping has them; 0 where a shape has none.
vec2 shape_uv(uint kind, uint numbers, dvec3 p, SolidCrossing crossing) {
    if (is_kind(kind, SHAPE_SPHERE)) {
        vec3 n = vec3(normalize(p - solid_vector(numbers)));
        return vec2(turn_around_y(n), asin(clamp(n.y, -1.0f, 1.0f)) * 0.318309886f + 0.5f);
    }
    if (is_kind(kind, SHAPE_BOX)) {
        // The picture is cut as a cross of 4 by 3 squares, as the reference's figure of section 3.4.6.7.1 shows.
        dvec3 lower = solid_vector(numbers);
        dvec3 size = solid_vector(numbers + 3u) - lower;
        vec3 q = vec3(0.0f);
        for (uint axis = 0u; axis < 3u; ++axis)
            if (size[axis] > 0.0lf) q[axis] = clamp(float((p[axis] - lower[axis]) / size[axis]), 0.0f, 1.0f);
        vec2 cell = vec2(1.0f, 1.0f);
        vec2 at = vec2(q.x, q.y);  // back
        if (crossing.part == 0u) cell.x = 0.0f, at = vec2(q.z, q.y);
        if (crossing.part == 1u) cell.x = 2.0f, at = vec2(1.0f - q.z, q.y);
        if (crossing.part == 2u) cell.y = 0.0f, at = vec2(q.x, q.z);
        if (crossing.part == 3u) cell.y = 2.0f, at = vec2(q.x, 1.0f - q.z);
        if (crossing.part == 4u) cell.x = 3.0f, at = vec2(1.0f - q.x, q.y);
        return (cell + at) / vec2(4.0f, 3.0f);
    }
    if (is_kind(kind, SHAPE_TORUS)) {
        vec3 q = vec3(p);
        float around = float(sqrt(p.x * p.x + p.z * p.z) - solid_number(numbers));
        float u = 0.5f - atan(q.z, q.x) * 0.159154943f;
        return vec2(u < 0.0f ? u + 1.0f : u, 0.5f + atan(q.y, around) * 0.159154943f);
    }
    if (is_kind(kind, SHAPE_REVOLUTION)) {
        double lower = solid_number(numbers + 1u);
        return vec2(turn_around_y(vec3(p)), float((p.y - lower) / (solid_number(numbers + 2u) - lower)));
    }
    if (is_kind(kind, SHAPE_LATHE)) {
        float pieces = float(solid_number(numbers));
        return vec2(turn_around_y(vec3(p)), (float(crossing.part) + float(crossing.u)) / pieces);
    }
    return vec2(0.0f);
}
