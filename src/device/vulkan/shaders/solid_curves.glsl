// SPDX-License-Identifier: Apache-2.0
// Shapes made of outlines: polygons, prisms (letters among them), surfaces of revolution and lathes.

/// A piece of an outline: Bernstein's coefficients of degree 3 of both coordinates, in eight numbers.
const uint PIECE_NUMBERS = 8u;

dvec4 piece_x(uint piece) { return dvec4(solid_vector(piece), solid_number(piece + 3u)); }
dvec4 piece_y(uint piece) { return piece_x(piece + 4u); }

double cubic_at(dvec4 b, double u) {
    double v = 1.0lf - u;
    return v * v * (v * b.x + 3.0lf * u * b.y) + u * u * (3.0lf * v * b.z + u * b.w);
}
double cubic_slope(dvec4 b, double u) {
    double v = 1.0lf - u;
    return 3.0lf * (v * v * (b.y - b.x) + 2.0lf * u * v * (b.z - b.y) + u * u * (b.w - b.z));
}

/// The roots of a polynomial in Bernstein's form of which the first and last coefficient are those of its ends. A root at a
/// joint of two pieces belongs to one of them, which the ends' signs tell: their number is odd where those differ.
uint piece_roots(inout double c[MOST_DEGREE + 1u], uint degree, out double roots[MOST_DEGREE + 1u]) {
    double first = c[0];
    double last = c[degree];
    bool changes = (first >= 0.0lf) != (last >= 0.0lf);
    power_from_bernstein(c, degree);
    double inner[MOST_DEGREE];
    uint count = roots_in_unit(c, degree, inner);
    for (uint i = 0u; i < count; ++i) roots[i] = inner[i];
    if (((count & 1u) == 1u) != changes) {
        roots[count] = first == 0.0lf ? 0.0lf : 1.0lf;
        ++count;
    }
    return count;
}

uint cubic_roots(dvec4 b, out double roots[MOST_DEGREE + 1u]) {
    double c[MOST_DEGREE + 1u];
    c[0] = b.x;
    c[1] = b.y;
    c[2] = b.z;
    c[3] = b.w;
    return piece_roots(c, 3u, roots);
}

bool same_sign(dvec4 b) {
    return all(greaterThan(b, dvec4(0.0lf))) || all(lessThan(b, dvec4(0.0lf)));
}

/// Whether a point is inside of an odd number of loops: pieces are counted that a line in +x direction meets.
bool inside_outline(uint first_piece, uint count, double x, double y) {
    bool odd = false;
    for (uint i = 0u; i < count; ++i) {
        uint piece = first_piece + PIECE_NUMBERS * i;
        dvec4 across = piece_x(piece);
        dvec4 height = piece_y(piece) - y;
        if (max(max(across.x, across.y), max(across.z, across.w)) < x || same_sign(height)) continue;
        double roots[MOST_DEGREE + 1u];
        uint found = cubic_roots(height, roots);
        for (uint k = 0u; k < found; ++k)
            if (cubic_at(across, roots[k]) > x) odd = !odd;
    }
    return odd;
}

// A polygon's numbers: normal, a point of its plane, the two axes that its edges are seen along, how many edges; of each,
// both ends. A mere surface.
void polygon_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    dvec3 normal = solid_vector(numbers);
    double speed = dot(normal, ray.direction);
    if (speed == 0.0lf) return;
    double t = dot(normal, solid_vector(numbers + 3u) - ray.origin) / speed;
    dvec3 p = ray.origin + ray.direction * t;
    double u = p[uint(solid_number(numbers + 6u))];
    double v = p[uint(solid_number(numbers + 7u))];
    uint count = uint(solid_number(numbers + 8u));
    // Even-odd, by the edges that a line along +u crosses; an edge holds its lower end, not its upper.
    bool odd = false;
    for (uint i = 0u; i < count; ++i) {
        dvec4 edge = piece_x(numbers + 9u + 4u * i);
        if ((edge.y <= v) == (edge.w <= v)) continue;
        if (u < edge.x + (v - edge.y) / (edge.w - edge.y) * (edge.z - edge.x)) odd = !odd;
    }
    if (odd) tell_crossing(t, 0.0lf, 0u, CROSSING_VISIBLE, search);
}

// A prism's numbers: lower and upper end, 1 if they are open, how many pieces its outlines have, and these.
const uint PRISM_PIECES = 4u;
const uint PRISM_BOTTOM = 0xfffffffeu;
const uint PRISM_TOP = 0xffffffffu;

// The outline lies in the xz plane (its y is the space's z). Its walls, which go on above and below, are met by points of
// the outline in the vertical plane through the ray.
void prism_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    double lower = solid_number(numbers);
    double upper = solid_number(numbers + 1u);
    bool closed = solid_number(numbers + 2u) == 0.0lf;
    uint count = uint(solid_number(numbers + 3u));
    dvec3 o = ray.origin;
    dvec3 d = ray.direction;
    double enter = -SOLID_FAR;
    double leave = SOLID_FAR;
    if (d.y == 0.0lf) {
        if (!(o.y > lower && o.y < upper)) return;
    } else {
        enter = ((d.y > 0.0lf ? lower : upper) - o.y) / d.y;
        leave = ((d.y > 0.0lf ? upper : lower) - o.y) / d.y;
    }
    double square = d.x * d.x + d.z * d.z;
    begin_parity(search);
    bool within_at_enter = false;
    bool within_at_leave = false;
    if (square == 0.0lf) {
        within_at_enter = inside_outline(numbers + PRISM_PIECES, count, o.x, o.z);
        within_at_leave = within_at_enter;
        count = 0u;
    }
    for (uint i = 0u; i < count; ++i) {
        uint piece = numbers + PRISM_PIECES + PIECE_NUMBERS * i;
        dvec4 x = piece_x(piece);
        dvec4 z = piece_y(piece);
        dvec4 off_plane = (z - o.z) * d.x - (x - o.x) * d.z;
        if (same_sign(off_plane)) continue;
        double roots[MOST_DEGREE + 1u];
        uint found = cubic_roots(off_plane, roots);
        for (uint k = 0u; k < found; ++k) {
            double u = roots[k];
            double t = ((cubic_at(x, u) - o.x) * d.x + (cubic_at(z, u) - o.z) * d.z) / square;
            if (t <= enter) within_at_enter = !within_at_enter;
            if (t < leave) within_at_leave = !within_at_leave;
            if (t > enter && t < leave) tell_parity(t, u, i, true, search);
        }
    }
    bool rises = d.y > 0.0lf;
    if (within_at_enter) tell_parity(enter, 0.0lf, rises ? PRISM_BOTTOM : PRISM_TOP, closed, search);
    if (within_at_leave) tell_parity(leave, 0.0lf, rises ? PRISM_TOP : PRISM_BOTTOM, closed, search);
    end_parity(search);
}

bool prism_inside(uint numbers, dvec3 p) {
    return p.y > solid_number(numbers) && p.y < solid_number(numbers + 1u) &&
           inside_outline(numbers + PRISM_PIECES, uint(solid_number(numbers + 3u)), p.x, p.z);
}

dvec3 prism_normal(uint numbers, SolidCrossing crossing) {
    if (crossing.part == PRISM_BOTTOM) return dvec3(0.0lf, -1.0lf, 0.0lf);
    if (crossing.part == PRISM_TOP) return dvec3(0.0lf, 1.0lf, 0.0lf);
    uint piece = numbers + PRISM_PIECES + PIECE_NUMBERS * crossing.part;
    return dvec3(cubic_slope(piece_y(piece), crossing.u), 0.0lf, -cubic_slope(piece_x(piece), crossing.u));
}

// A surface of revolution's numbers: 1 if its ends are open, lower and upper end, its largest radius, how many pieces; of
// each, its ends and the four coefficients of the square of the radius by the height above the piece's lower end.
const uint REVOLUTION_PIECES = 5u;
const uint REVOLUTION_NUMBERS = 6u;

double revolution_square(uint piece, double height) {
    dvec4 c = piece_x(piece + 2u);
    return ((c.w * height + c.z) * height + c.y) * height + c.x;
}

void revolution_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    bool closed = solid_number(numbers) == 0.0lf;
    double reach = solid_number(numbers + 3u) * (1.0lf + 1e-6lf);
    uint count = uint(solid_number(numbers + 4u));
    SolidRay line = ray;
    line.from = -SOLID_FAR;
    line.to = SOLID_FAR;
    dvec3 corner = dvec3(reach, SOLID_FAR, reach);
    dvec2 near = clip_to_box(-corner, corner, line);
    if (!(near.x < near.y)) return;
    bool rises = ray.direction.y >= 0.0lf;
    bool is_inside = false;
    begin_parity(search);
    // In the order in which the ray comes through the pieces: each begins as the one before ended, or the surface is at
    // their joint.
    for (uint k = 0u; k < count; ++k) {
        uint number = rises ? k : count - 1u - k;
        uint piece = numbers + REVOLUTION_PIECES + REVOLUTION_NUMBERS * number;
        double lower = solid_number(piece);
        double upper = solid_number(piece + 1u);
        dvec2 within = near;
        double first = -SOLID_FAR;
        double last = SOLID_FAR;
        if (ray.direction.y == 0.0lf) {
            if (ray.origin.y < lower || ray.origin.y > upper) continue;
        } else {
            first = ((rises ? lower : upper) - ray.origin.y) / ray.direction.y;
            last = ((rises ? upper : lower) - ray.origin.y) / ray.direction.y;
            within = dvec2(max(near.x, first), min(near.y, last));
        }
        if (within.x < within.y) {
            dvec3 o = ray.origin + ray.direction * within.x;
            dvec3 d = ray.direction * (within.y - within.x);
            // The square of the radius, along this part of the ray.
            double c[MOST_DEGREE + 1u];
            dvec4 square = piece_x(piece + 2u);
            double h = o.y - lower;
            c[0] = o.x * o.x + o.z * o.z - (((square.w * h + square.z) * h + square.y) * h + square.x);
            c[1] = 2.0lf * (o.x * d.x + o.z * d.z) - ((3.0lf * square.w * h + 2.0lf * square.z) * h + square.y) * d.y;
            c[2] = d.x * d.x + d.z * d.z - (3.0lf * square.w * h + square.z) * d.y * d.y;
            c[3] = -square.w * d.y * d.y * d.y;
            if (c[0] != 0.0lf && (c[0] < 0.0lf) != is_inside) {
                bool at_cap = k == 0u && first >= within.x - 1e-9lf * (within.y - within.x);
                tell_parity(at_cap ? first : within.x, 0.0lf, at_cap ? (rises ? PRISM_BOTTOM : PRISM_TOP) : number,
                            !at_cap || closed, search);
                is_inside = !is_inside;
            }
            double roots[MOST_DEGREE];
            uint found = roots_in_unit(c, 3u, roots);
            for (uint i = 0u; i < found; ++i)
                tell_parity(within.x + roots[i] * (within.y - within.x), 0.0lf, number, true, search);
            if ((found & 1u) == 1u) is_inside = !is_inside;
        }
        if (k + 1u == count && is_inside) tell_parity(last, 0.0lf, rises ? PRISM_TOP : PRISM_BOTTOM, closed, search);
    }
    end_parity(search);
}

bool revolution_inside(uint numbers, dvec3 p) {
    uint count = uint(solid_number(numbers + 4u));
    for (uint i = 0u; i < count; ++i) {
        uint piece = numbers + REVOLUTION_PIECES + REVOLUTION_NUMBERS * i;
        double lower = solid_number(piece);
        if (p.y >= lower && p.y <= solid_number(piece + 1u))
            return p.x * p.x + p.z * p.z < revolution_square(piece, p.y - lower);
    }
    return false;
}

dvec3 revolution_normal(uint numbers, dvec3 p, SolidCrossing crossing) {
    if (crossing.part == PRISM_BOTTOM) return dvec3(0.0lf, -1.0lf, 0.0lf);
    if (crossing.part == PRISM_TOP) return dvec3(0.0lf, 1.0lf, 0.0lf);
    uint piece = numbers + REVOLUTION_PIECES + REVOLUTION_NUMBERS * crossing.part;
    dvec4 c = piece_x(piece + 2u);
    double h = p.y - solid_number(piece);
    return dvec3(2.0lf * p.x, -(c.y + h * (2.0lf * c.z + 3.0lf * h * c.w)), 2.0lf * p.z);
}

// A lathe's numbers: how many pieces its curve has; of an open curve's two ends, radius and height (radius 0 if it is
// closed); and the pieces. Radius and height are their x and y.
const uint LATHE_PIECES = 5u;
const uint LATHE_END = 0xffffffffu;

void lathe_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    uint count = uint(solid_number(numbers));
    dvec3 o = ray.origin;
    dvec3 d = ray.direction;
    double far = length(d);
    // The ray seen from its point nearest to the axis.
    double square_speed = d.x * d.x + d.z * d.z;
    double t_near = square_speed > 0.0lf ? -(o.x * d.x + o.z * d.z) / square_speed : 0.0lf;
    dvec3 p = o + d * t_near;
    double square_nearest = p.x * p.x + p.z * p.z;
    bool horizontal = abs(d.y) <= 1e-7lf * far;
    double scale = 1.0lf / (far * far);
    begin_parity(search);
    for (uint i = 0u; i < count; ++i) {
        uint piece = numbers + LATHE_PIECES + PIECE_NUMBERS * i;
        dvec4 r = piece_x(piece);
        dvec4 y = piece_y(piece) - p.y;
        if (horizontal && same_sign(y)) continue;
        dvec4 wide = abs(r);
        double widest = max(max(wide.x, wide.y), max(wide.z, wide.w));
        if (widest * widest < square_nearest) continue;
        // speed^2*(y(u) - y0)^2 = dy^2*(r(u)^2 - nearest^2)
        double c[MOST_DEGREE + 1u];
        for (uint k = 0u; k <= 6u; ++k) c[k] = horizontal ? 0.0lf : d.y * d.y * scale * square_nearest;
        for (uint k = 0u; k < 4u; ++k) {
            if (horizontal) {
                c[k] = y[k];
                continue;
            }
            for (uint l = 0u; l < 4u; ++l) {
                double weight = (k == 0u || k == 3u ? 1.0lf : 3.0lf) * (l == 0u || l == 3u ? 1.0lf : 3.0lf);
                uint m = k + l;
                uint from_end = min(m, 6u - m);
                weight /= from_end == 0u ? 1.0lf : from_end == 1u ? 6.0lf : from_end == 2u ? 15.0lf : 20.0lf;
                c[m] += weight * scale * (square_speed * y[k] * y[l] - d.y * d.y * r[k] * r[l]);
            }
        }
        double roots[MOST_DEGREE + 1u];
        uint found = piece_roots(c, horizontal ? 3u : 6u, roots);
        for (uint k = 0u; k < found; ++k) {
            double u = roots[k];
            double radius = cubic_at(r, u);
            double beyond = radius * radius - square_nearest;
            if (horizontal) {
                if (!(beyond > 0.0lf)) continue;
                double half_way = sqrt(beyond / square_speed);
                tell_parity(t_near - half_way, u, i, true, search);
                tell_parity(t_near + half_way, u, i, true, search);
                continue;
            }
            double by_height = cubic_at(y, u) / d.y;
            // By the one of both coordinates that the ray moves faster in.
            double way = by_height;
            if (d.y * d.y <= 0.01lf * square_speed && beyond > 0.0lf) {
                way = sqrt(beyond / square_speed);
                if (by_height < 0.0lf) way = -way;
            }
            tell_parity(t_near + way, u, i, true, search);
        }
    }
    for (uint end = 0u; end < 2u; ++end) {
        double radius = solid_number(numbers + 1u + 2u * end);
        if (radius == 0.0lf || d.y == 0.0lf) continue;
        double t = (solid_number(numbers + 2u + 2u * end) - o.y) / d.y;
        dvec3 at = o + d * t;
        if (at.x * at.x + at.z * at.z < radius * radius) tell_parity(t, 0.0lf, LATHE_END, false, search);
    }
    end_parity(search);
}

bool lathe_inside(uint numbers, dvec3 p) {
    return inside_outline(numbers + LATHE_PIECES, uint(solid_number(numbers)), sqrt(p.x * p.x + p.z * p.z), p.y);
}

dvec3 lathe_normal(uint numbers, dvec3 p, SolidCrossing crossing) {
    double around = sqrt(p.x * p.x + p.z * p.z);
    if (crossing.part == LATHE_END || around == 0.0lf) return dvec3(0.0lf, 1.0lf, 0.0lf);
    uint piece = numbers + LATHE_PIECES + PIECE_NUMBERS * crossing.part;
    double rise = cubic_slope(piece_y(piece), crossing.u);
    return dvec3(rise * p.x / around, -cubic_slope(piece_x(piece), crossing.u), rise * p.z / around);
}
