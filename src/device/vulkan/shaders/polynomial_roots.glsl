// SPDX-License-Identifier: Apache-2.0
// Roots of polynomials in (0, 1), none lost at which the sign changes.

const uint MOST_DEGREE = 4u;

/// Value and slope at s of the polynomial's derivative number `skipped`, which is of degree `degree`. Factors from
/// differentiating are left as they come: c holds the coefficients of the polynomial itself.
void derivative_at(double c[MOST_DEGREE + 1u], uint skipped, uint degree, double s, out double value,
                   out double slope) {
    value = 0.0lf;
    slope = 0.0lf;
    for (uint i = degree + 1u; i > 0u; --i) {
        double factor = 1.0lf;
        for (uint k = 0u; k < skipped; ++k) factor *= double(i - 1u + skipped - k);
        slope = slope * s + value;
        value = value * s + factor * c[i - 1u + skipped];
    }
}

/// Writes the roots at which the sign changes, ascending, and returns their number. Between the roots of the derivative,
/// found in the same way, a polynomial is monotone and has one root or none (Yuksel: High-Performance Polynomial Root
/// Finding for Graphics, HPG 2022).
uint roots_in_unit(double c[MOST_DEGREE + 1u], uint degree, out double roots[MOST_DEGREE]) {
    uint count = 0u;
    for (uint n = 1u; n <= degree; ++n) {
        double found[MOST_DEGREE];
        uint found_count = 0u;
        double from = 0.0lf;
        double at_from;
        double unused;
        derivative_at(c, degree - n, n, from, at_from, unused);
        bool negative = at_from < 0.0lf;
        for (uint i = 0u; i <= count; ++i) {
            double to = i < count ? roots[i] : 1.0lf;
            double at_to;
            derivative_at(c, degree - n, n, to, at_to, unused);
            if (at_to != 0.0lf && (at_to < 0.0lf) != negative) {
                double lower = from;
                double upper = to;
                double s = 0.5lf * (lower + upper);
                for (uint step = 0u; step < 80u; ++step) {
                    double value;
                    double slope;
                    derivative_at(c, degree - n, n, s, value, slope);
                    if ((value < 0.0lf) == negative) lower = s;
                    else upper = s;
                    double next = s - value / slope;
                    if (!(next > lower && next < upper)) next = 0.5lf * (lower + upper);
                    bool done = abs(next - s) <= 4e-16lf * next || next == lower || next == upper;
                    s = next;
                    if (done) break;
                }
                found[found_count] = s;
                ++found_count;
                negative = !negative;
            }
            from = to;
        }
        count = found_count;
        for (uint i = 0u; i < count; ++i) roots[i] = found[i];
    }
    return count;
}
