// SPDX-License-Identifier: Apache-2.0
// Ranges of numbers that keep how they depend on N inputs: affine arithmetic (Comba and Stolfi 1993) reduced to the
// inputs' own symbols and one error term (Knoll et al. 2009, "Fast and robust ray tracing of general implicits"),
// beside an interval. Every operation's result encloses all values that its operands' enclose, rounding included.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sundog::fields {

/// Somewhere in [lower, upper], and within `error` of centre + sum of slope[i]*s[i], where s[i] in [-1, 1] are the
/// inputs' places in their ranges. An infinite error: only the interval is known. Both say nothing of values that are
/// no numbers (the square root of -1).
template <std::size_t N>
struct Affine {
    double lower = 0, upper = 0;
    double centre = 0;
    std::array<double, N> slope{};
    double error = 0;
};

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// More than what one operation's rounding adds, relatively; and what is added for results near 0.
inline constexpr double kRounding = 4.5e-16;
inline constexpr double kTiny = 1e-300;

/// The next number below (above), or one a little further. Operations of IEEE 754 are within half a step.
inline double below(double x) { return x - (std::fabs(x) * kRounding + kTiny); }
inline double above(double x) { return x + (std::fabs(x) * kRounding + kTiny); }
/// For results of the C library, whose functions are within a few steps.
inline double well_below(double x) { return x - (std::fabs(x) * 4 * kRounding + kTiny); }
inline double well_above(double x) { return x + (std::fabs(x) * 4 * kRounding + kTiny); }

template <std::size_t N>
double slope_sum(const Affine<N>& a) {
    double sum = 0;
    for (const double s : a.slope) sum += std::fabs(s);
    return sum;
}

/// Makes interval and linear form agree: each is cut by the other.
template <std::size_t N>
[[gnu::always_inline]] inline Affine<N> settled(Affine<N> a) {
    if (!(a.lower >= -kInfinite)) a.lower = -kInfinite;
    if (!(a.upper <= kInfinite)) a.upper = kInfinite;
    const double reach = (slope_sum(a) + a.error) * (1 + 4 * kRounding);
    const double low = below(a.centre - reach), high = above(a.centre + reach);
    if (low > a.lower) a.lower = low;
    if (high < a.upper) a.upper = high;
    const double half = 0.5 * (a.upper - a.lower);
    // Also where the form isn't a number.
    if (!(a.error <= half) && half < kInfinite) {
        a.centre = 0.5 * (a.lower + a.upper);
        a.slope.fill(0);
        a.error = half * (1 + 4 * kRounding) + std::fabs(a.centre) * kRounding + kTiny;
    } else if (!(a.error < kInfinite) || !(std::fabs(a.centre) < kInfinite)) {
        a.centre = 0;
        a.slope.fill(0);
        a.error = kInfinite;
    }
    return a;
}

template <std::size_t N>
[[gnu::always_inline]] inline Affine<N> exactly(double v) {
    Affine<N> a;
    a.lower = a.upper = a.centre = v;
    return a;
}

/// All of [lower, upper].
template <std::size_t N>
Affine<N> anywhere(double lower, double upper) {
    Affine<N> a;
    a.lower = lower, a.upper = upper;
    a.error = kInfinite;
    return settled(a);
}

/// Input number i over [lower, upper].
template <std::size_t N>
Affine<N> input_range(std::size_t i, double lower, double upper) {
    Affine<N> a;
    a.lower = lower, a.upper = upper;
    a.centre = 0.5 * (lower + upper);
    a.slope[i] = std::max(upper - a.centre, a.centre - lower);
    a.error = (std::fabs(lower) + std::fabs(upper)) * kRounding;
    return a;
}

/// line*a + offset, give or take `error`; its interval is [lower, upper].
template <std::size_t N>
[[gnu::always_inline]] inline Affine<N> line_of(const Affine<N>& a, double line, double offset, double error,
                                                double lower, double upper) {
    Affine<N> out;
    out.lower = lower, out.upper = upper;
    const double product = line * a.centre;
    out.centre = product + offset;
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        out.slope[i] = line * a.slope[i];
        sum += std::fabs(out.slope[i]);
    }
    out.error = (std::fabs(line) * a.error + error + (std::fabs(product) + std::fabs(offset) + sum) * kRounding) *
                    (1 + 4 * kRounding) +
                kTiny;
    return settled(out);
}

/// A function of a that is f_lower and f_upper at the ends of its interval, and in between at most `under` below and
/// `over` above the line between them. [lower, upper] is its range.
template <std::size_t N>
[[gnu::always_inline]] inline Affine<N> chord_of(const Affine<N>& a, double f_lower, double f_upper, double under,
                                                 double over, double lower, double upper) {
    const double width = a.upper - a.lower;
    const double line = width > 0 ? (f_upper - f_lower) / width : 0;
    if (!(width < kInfinite) || !(std::fabs(line) < kInfinite)) return anywhere<N>(lower, upper);
    const double offset = f_lower - line * a.lower + 0.5 * (over - under);
    const double size = std::fabs(f_lower) + std::fabs(f_upper) + std::fabs(line) * (std::fabs(a.lower) + width);
    return line_of(a, line, offset, 0.5 * (over + under) + size * 8 * kRounding, lower, upper);
}

template <std::size_t N>
[[gnu::always_inline]] inline Affine<N> negated(const Affine<N>& a) {
    Affine<N> out;
    out.lower = -a.upper, out.upper = -a.lower;
    out.centre = -a.centre;
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = -a.slope[i];
    out.error = a.error;
    return out;
}

template <std::size_t N>
[[gnu::always_inline]] inline Affine<N> sum_of(const Affine<N>& a, const Affine<N>& b) {
    Affine<N> out;
    out.lower = below(a.lower + b.lower), out.upper = above(a.upper + b.upper);
    // Rounding changes no sign: the root of a sum of squares has a value.
    if (a.lower >= 0 && b.lower >= 0) out.lower = std::max(out.lower, 0.0);
    if (a.upper <= 0 && b.upper <= 0) out.upper = std::min(out.upper, 0.0);
    out.centre = a.centre + b.centre;
    double size = std::fabs(out.centre);
    for (std::size_t i = 0; i < N; ++i) {
        out.slope[i] = a.slope[i] + b.slope[i];
        size += std::fabs(out.slope[i]);
    }
    out.error = (a.error + b.error + size * kRounding) * (1 + 4 * kRounding);
    return settled(out);
}

template <std::size_t N>
Affine<N> product_of(const Affine<N>& a, const Affine<N>& b) {
    Affine<N> out;
    const double p = a.lower * b.lower, q = a.lower * b.upper, r = a.upper * b.lower, s = a.upper * b.upper;
    const double least = std::min(std::min(p, q), std::min(r, s)), most = std::max(std::max(p, q), std::max(r, s));
    // Rounding changes no sign.
    out.lower = least >= 0 ? std::max(below(least), 0.0) : below(least);
    out.upper = most <= 0 ? std::min(above(most), 0.0) : above(most);
    // 0 times infinity is 0 here: ends at infinity only say that there is no bound.
    if (std::isnan(p + q + r + s)) out.lower = -kInfinite, out.upper = kInfinite;
    double centre = a.centre * b.centre;
    double size = std::fabs(centre);
    double error = std::fabs(a.centre) * b.error + std::fabs(b.centre) * a.error;
    double a_sum = 0, b_sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        out.slope[i] = a.centre * b.slope[i] + b.centre * a.slope[i];
        size += std::fabs(a.centre * b.slope[i]) + std::fabs(b.centre * a.slope[i]);
        a_sum += std::fabs(a.slope[i]), b_sum += std::fabs(b.slope[i]);
        // s[i]^2 lies in [0, 1].
        const double half = 0.5 * a.slope[i] * b.slope[i];
        centre += half;
        error += std::fabs(half);
        for (std::size_t j = 0; j < i; ++j) error += std::fabs(a.slope[i] * b.slope[j] + a.slope[j] * b.slope[i]);
    }
    error += a_sum * b.error + b_sum * a.error + a.error * b.error;
    size += a_sum * b_sum;
    out.centre = centre;
    out.error = (error + size * 3 * kRounding) * (1 + 8 * kRounding) + kTiny;
    return settled(out);
}

/// What either of the two may be.
template <std::size_t N>
Affine<N> either(const Affine<N>& a, const Affine<N>& b) {
    Affine<N> out;
    out.lower = std::min(a.lower, b.lower), out.upper = std::max(a.upper, b.upper);
    out.centre = 0.5 * (a.centre + b.centre);
    double apart = 0.5 * std::fabs(a.centre - b.centre);
    double size = std::fabs(a.centre) + std::fabs(b.centre);
    for (std::size_t i = 0; i < N; ++i) {
        out.slope[i] = 0.5 * (a.slope[i] + b.slope[i]);
        apart += 0.5 * std::fabs(a.slope[i] - b.slope[i]);
        size += std::fabs(a.slope[i]) + std::fabs(b.slope[i]);
    }
    out.error = (std::max(a.error, b.error) + apart + size * kRounding) * (1 + 4 * kRounding);
    return settled(out);
}

/// The same, held within [lower, upper]: for values that are cut off there.
template <std::size_t N>
Affine<N> cut_off(Affine<N> a, double lower, double upper) {
    if (a.lower >= lower && a.upper <= upper) return a;
    a.error += std::max({0.0, lower - a.lower, a.upper - upper});
    a.lower = std::clamp(a.lower, lower, upper), a.upper = std::clamp(a.upper, lower, upper);
    return settled(a);
}

}  // namespace sundog::fields
