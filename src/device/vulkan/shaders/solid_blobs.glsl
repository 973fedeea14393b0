// SPDX-License-Identifier: Apache-2.0
// Blobs: inside where the components' fields, strength*(1 - d^2/radius^2)^2 of the distance to a point or an axis, add up
// to more than the threshold.

// A blob's numbers: threshold, how many components; of each, component_from_blob (columns x, y, z, t; to the unit ball, or
// the unit cylinder about z), the axis' length there (0: a ball), strength.
const uint BLOB_COMPONENTS = 2u;
const uint BLOB_NUMBERS = 14u;

uint blob_component(uint numbers, uint i) { return numbers + BLOB_COMPONENTS + BLOB_NUMBERS * i; }

dvec3 vector_to_component(uint component, dvec3 v) {
    return solid_vector(component) * v.x + solid_vector(component + 3u) * v.y + solid_vector(component + 6u) * v.z;
}
dvec3 point_to_component(uint component, dvec3 p) {
    return vector_to_component(component, p) + solid_vector(component + 9u);
}

/// From the nearest point of the axis, in the component's own space.
dvec3 off_axis(dvec3 q, double axis_length) {
    return dvec3(q.x, q.y, q.z < 0.0lf ? q.z : max(q.z - axis_length, 0.0lf));
}

bool blob_inside(uint numbers, dvec3 p) {
    uint count = uint(solid_number(numbers + 1u));
    double sum = 0.0lf;
    for (uint i = 0u; i < count; ++i) {
        uint component = blob_component(numbers, i);
        dvec3 off = off_axis(point_to_component(component, p), solid_number(component + 12u));
        double reach = 1.0lf - dot(off, off);
        if (reach > 0.0lf) sum += solid_number(component + 13u) * reach * reach;
    }
    return sum > solid_number(numbers);
}

dvec3 blob_normal(uint numbers, dvec3 p) {
    uint count = uint(solid_number(numbers + 1u));
    dvec3 sum = dvec3(0.0lf);
    for (uint i = 0u; i < count; ++i) {
        uint component = blob_component(numbers, i);
        dvec3 off = off_axis(point_to_component(component, p), solid_number(component + 12u));
        double reach = 1.0lf - dot(off, off);
        if (!(reach > 0.0lf)) continue;
        off *= 4.0lf * solid_number(component + 13u) * reach;
        sum += dvec3(dot(solid_vector(component), off), dot(solid_vector(component + 3u), off),
                     dot(solid_vector(component + 6u), off));
    }
    return sum;
}

/// Where a ray in a component's own space is within reach of one of its parts (0 and 2: the balls at the axis' ends, 1: its
/// side; a ball: 0 alone), as its lower and upper t.
dvec2 component_stretch(uint part, double axis_length, dvec3 o, dvec3 d) {
    const dvec2 none = dvec2(1.0lf, 0.0lf);
    if (axis_length == 0.0lf && part > 0u) return none;
    dvec3 weights = dvec3(1.0lf, 1.0lf, part == 1u ? 0.0lf : 1.0lf);
    dvec3 from = o - dvec3(0.0lf, 0.0lf, part == 2u ? axis_length : 0.0lf);
    dvec2 reach = dvec2(-SOLID_FAR, SOLID_FAR);
    double a = dot(d * weights, d);
    if (a == 0.0lf) {
        if (!(dot(from * weights, from) < 1.0lf)) return none;
    } else {
        double middle = -dot(from * weights, d) / a;
        dvec3 nearest = from + d * middle;
        double discriminant = 1.0lf - dot(nearest * weights, nearest);
        if (!(discriminant > 0.0lf)) return none;
        double half_way = sqrt(discriminant / a);
        reach = dvec2(middle - half_way, middle + half_way);
    }
    if (axis_length == 0.0lf) return reach;
    // Between the planes at the axis' ends, or beyond one of them.
    if (d.z == 0.0lf) {
        uint here = o.z < 0.0lf ? 0u : o.z > axis_length ? 2u : 1u;
        return part == here ? reach : none;
    }
    double t0 = -o.z / d.z;
    double t1 = (axis_length - o.z) / d.z;
    bool rises = d.z > 0.0lf;
    if (part == 1u) return dvec2(max(reach.x, min(t0, t1)), min(reach.y, max(t0, t1)));
    double plane = part == 0u ? t0 : t1;
    if ((part == 0u) == rises) reach.y = min(reach.y, plane);
    else reach.x = max(reach.x, plane);
    return reach;
}

// Along a ray the field is, between the places where it enters or leaves a part of a component, one polynomial of degree
// four: the sum of squares of quadratics. The ray is followed from one such place to the next.
void blob_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    double threshold = solid_number(numbers);
    uint count = uint(solid_number(numbers + 1u));
    bool is_inside = false;
    double lower = -SOLID_FAR;
    while (lower < search.next.t) {
        double upper = SOLID_FAR;
        double first = -threshold;
        dvec4 rest = dvec4(-threshold);
        bool any_part = false;
        // First the end of the piece is looked for, then what lies all along it is added up.
        for (uint i = 0u; i < 2u * 3u * count; ++i) {
            bool adding = i >= 3u * count;
            uint number = adding ? i - 3u * count : i;
            uint component = blob_component(numbers, number / 3u);
            uint part = number % 3u;
            double axis_length = solid_number(component + 12u);
            if (axis_length == 0.0lf && part > 0u) continue;
            dvec3 o = point_to_component(component, ray.origin);
            dvec3 d = vector_to_component(component, ray.direction);
            dvec2 stretch = component_stretch(part, axis_length, o, d);
            if (!(stretch.x < stretch.y)) continue;
            if (!adding) {
                if (stretch.x > lower) upper = min(upper, stretch.x);
                if (stretch.y > lower) upper = min(upper, stretch.y);
                continue;
            }
            if (!(stretch.x <= lower && stretch.y >= upper)) continue;
            any_part = true;
            // A quadratic's Bernstein coefficients from its values at the ends and in the middle, then their square's.
            dvec3 weights = dvec3(1.0lf, 1.0lf, part == 1u ? 0.0lf : 1.0lf);
            o.z -= part == 2u ? axis_length : 0.0lf;
            dvec3 q0 = o + d * lower;
            dvec3 q1 = o + d * (0.5lf * (lower + upper));
            dvec3 q2 = o + d * upper;
            double b0 = 1.0lf - dot(q0 * weights, q0);
            double b2 = 1.0lf - dot(q2 * weights, q2);
            double b1 = 2.0lf * (1.0lf - dot(q1 * weights, q1)) - 0.5lf * (b0 + b2);
            double strength = solid_number(component + 13u);
            first += strength * b0 * b0;
            rest += strength * dvec4(b0 * b1, (b0 * b2 + 2.0lf * b1 * b1) / 3.0lf, b1 * b2, b2 * b2);
        }
        // What is inside is carried from piece to piece: where rounding disagrees at their joint, the surface is there.
        bool begins_inside = any_part && first > 0.0lf;
        if (begins_inside != is_inside && (first != 0.0lf || !any_part)) {
            tell_crossing(lower, 0.0lf, 0u, is_inside ? SOLID_FACE : SOLID_FACE | CROSSING_ENTERS, search);
            is_inside = !is_inside;
        }
        if (any_part) {
            double c[MOST_DEGREE + 1u];
            c[0] = first;
            c[1] = rest.x;
            c[2] = rest.y;
            c[3] = rest.z;
            c[4] = rest.w;
            power_from_bernstein(c, 4u);
            double roots[MOST_DEGREE];
            uint found = roots_in_unit(c, 4u, roots);
            for (uint k = 0u; k < found; ++k) {
                tell_crossing(lower + roots[k] * (upper - lower), 0.0lf, 0u,
                              is_inside ? SOLID_FACE : SOLID_FACE | CROSSING_ENTERS, search);
                is_inside = !is_inside;
            }
        }
        if (!(upper < SOLID_FAR)) break;
        lower = upper;
    }
}
