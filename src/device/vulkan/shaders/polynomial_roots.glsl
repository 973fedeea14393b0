// SPDX-License-Identifier: Apache-2.0
// Roots of polynomials in (0, 1), none lost at which the sign changes.

const uint MOST_DEGREE = 6u;

/// Value and slope at s of a polynomial's derivative number `skipped`, which is of degree `degree`, times a factor that
/// is the same everywhere: c holds the coefficients of the polynomial itself.
void derivative_at(double c[MOST_DEGREE + 1u], uint skipped, uint degree, double s, out double value,
                   out double slope) {
    value = 0.0lf;
    slope = 0.0lf;
    double factor = 1.0lf;  // of the coefficient at hand, as a share of the highest one's
    for (uint left = degree + 1u; left > 0u; --left) {
        uint i = left - 1u;
        slope = slope * s + value;
        value = value * s + factor * c[i + skipped];
        factor *= double(i) / double(i + skipped);
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
        bool negative = false;
        // The first end is asked like the others, so that the code is there once.
        for (uint i = 0u; i <= count + 1u; ++i) {
            double to = i == 0u ? 0.0lf : i <= count ? roots[i - 1u] : 1.0lf;
            double value;
            double slope;
            derivative_at(c, degree - n, n, to, value, slope);
            if (i == 0u) {
                negative = value < 0.0lf;
            } else if (value != 0.0lf && (value < 0.0lf) != negative) {
                double lower = from;
                double upper = to;
                double s = 0.5lf * (lower + upper);
                // What stands before the wanted polynomial need not be known as well.
                double tolerance = n == degree ? 4e-16lf : 1e-9lf;
                for (uint step = 0u; step < 80u; ++step) {
                    derivative_at(c, degree - n, n, s, value, slope);
                    if ((value < 0.0lf) == negative) lower = s;
                    else upper = s;
                    double next = s - value / slope;
                    if (!(next > lower && next < upper)) next = 0.5lf * (lower + upper);
                    bool done = abs(next - s) <= tolerance * next || next == lower || next == upper;
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

/// From Bernstein's form to powers, in place.
void power_from_bernstein(inout double c[MOST_DEGREE + 1u], uint degree) {
    // Differences, row by row; then binomials.
    for (uint level = 1u; level <= degree; ++level)
        for (uint i = degree; i >= level; --i) c[i] -= c[i - 1u];
    double binomial = 1.0lf;
    for (uint k = 0u; k <= degree; ++k) {
        c[k] *= binomial;
        binomial *= double(degree - k) / double(k + 1u);
    }
}
