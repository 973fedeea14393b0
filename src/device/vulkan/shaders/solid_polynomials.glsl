// SPDX-License-Identifier: Apache-2.0
// Polynomial surfaces of third to sixth order: inside where the sum of their terms is under 0.

/// A polynomial's numbers: order, how many terms; of each term, exponents of x, y and z, and its coefficient.
const uint POLYNOMIAL_TERMS = 2u;

double power_of(double x, uint n) {
    double result = 1.0lf;
    for (uint i = 0u; i < n; ++i) result *= x;
    return result;
}

double polynomial_value(uint numbers, dvec3 p) {
    uint count = uint(solid_number(numbers + 1u));
    double sum = 0.0lf;
    for (uint i = 0u; i < count; ++i) {
        uint term = numbers + POLYNOMIAL_TERMS + 4u * i;
        uvec3 n = uvec3(solid_vector(term));
        sum += solid_number(term + 3u) * power_of(p.x, n.x) * power_of(p.y, n.y) * power_of(p.z, n.z);
    }
    return sum;
}

dvec3 polynomial_gradient(uint numbers, dvec3 p) {
    uint count = uint(solid_number(numbers + 1u));
    dvec3 gradient = dvec3(0.0lf);
    for (uint i = 0u; i < count; ++i) {
        uint term = numbers + POLYNOMIAL_TERMS + 4u * i;
        uvec3 n = uvec3(solid_vector(term));
        double coefficient = solid_number(term + 3u);
        for (uint axis = 0u; axis < 3u; ++axis) {
            if (n[axis] == 0u) continue;
            uvec3 lower = n;
            lower[axis] -= 1u;
            gradient[axis] += coefficient * double(n[axis]) * power_of(p.x, lower.x) * power_of(p.y, lower.y) *
                              power_of(p.z, lower.z);
        }
    }
    return gradient;
}

void polynomial_crossings(uint numbers, SolidRay ray, inout SolidSearch search) {
    uint order = uint(solid_number(numbers));
    uint count = uint(solid_number(numbers + 1u));
    // From the point nearest to the origin, about which such shapes lie, rounding is least.
    dvec3 d = ray.direction;
    double near = clamp(-dot(ray.origin, d) / dot(d, d), ray.from, ray.to);
    dvec3 p = ray.origin + d * near;
    // Coefficients of powers 0 to 3, and of 4 to 6.
    dvec4 low = dvec4(0.0lf);
    dvec4 high = dvec4(0.0lf);
    for (uint i = 0u; i < count; ++i) {
        uint term = numbers + POLYNOMIAL_TERMS + 4u * i;
        dvec4 term_low = dvec4(solid_number(term + 3u), 0.0lf, 0.0lf, 0.0lf);
        dvec4 term_high = dvec4(0.0lf);
        for (uint axis = 0u; axis < 3u; ++axis) {
            double at = axis == 0u ? p.x : axis == 1u ? p.y : p.z;
            double way = axis == 0u ? d.x : axis == 1u ? d.y : d.z;
            uint n = uint(solid_number(term + axis));
            for (uint times = 0u; times < n; ++times) {
                term_high = term_high * at + dvec4(term_low.w, term_high.xyz) * way;
                term_low = term_low * at + dvec4(0.0lf, term_low.xyz) * way;
            }
        }
        low += term_low;
        high += term_high;
    }
    double c[MOST_DEGREE + 1u];
    c[0] = low.x;
    c[1] = low.y;
    c[2] = low.z;
    c[3] = low.w;
    c[4] = high.x;
    c[5] = high.y;
    c[6] = high.z;
    while (order > 0u && c[order] == 0.0lf) --order;
    if (order == 0u) return;
    // About the beginning of what is asked.
    double start = ray.from - near;
    for (uint i = 0u; i < MOST_DEGREE; ++i)
        for (uint k = MOST_DEGREE; k > i; --k) c[k - 1u] += start * c[k];
    double width = ray.to - ray.from;
    // About the roots' geometric mean.
    double size = c[0] != 0.0lf ? double(pow(float(abs(c[0] / c[order])), 1.0f / float(order))) : 1.0lf;
    if (!(size > 1e-9lf && size < 1e9lf)) size = 1.0lf;
    bool endless = width > 1e4lf * size;
    double unit[MOST_DEGREE + 1u];
    double scale = 1.0lf;
    double binomial = 1.0lf;
    for (uint i = 0u; i <= order; ++i) {
        // If endless, t = size*s/(1 - s) carries all that is ahead to s in (0, 1), and the coefficients are Bernstein's
        // but for binomials.
        unit[i] = c[i] * scale / (endless ? binomial : 1.0lf);
        scale *= endless ? size : width;
        binomial *= double(order - i) / double(i + 1u);
    }
    if (endless) power_from_bernstein(unit, order);
    double roots[MOST_DEGREE];
    uint found = roots_in_unit(unit, order, roots);
    bool enters = !(c[0] < 0.0lf);
    for (uint i = 0u; i < found; ++i) {
        double s = endless ? size * roots[i] / (1.0lf - roots[i]) : roots[i] * width;
        // What carrying to (0, 1) has lost, one of Newton's steps brings back.
        double value = 0.0lf;
        double slope = 0.0lf;
        for (uint k = order + 1u; k > 0u; --k) {
            slope = slope * s + value;
            value = value * s + c[k - 1u];
        }
        double step = value / slope;
        if (abs(step) < 1e-6lf * s) s -= step;
        tell_crossing(ray.from + s, 0.0lf, 0u, enters ? SOLID_FACE | CROSSING_ENTERS : SOLID_FACE, search);
        enters = !enters;
    }
}
