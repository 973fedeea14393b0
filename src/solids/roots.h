// SPDX-License-Identifier: Apache-2.0
// Real roots of polynomials in an interval, none lost at which the sign changes.
#pragma once

#include <span>

#include "solids/small_vector.h"

namespace sundog::solids {

/// Highest degree that the solvers take.
inline constexpr std::size_t kMaxDegree = 35;

using RootList = SmallVector<double, 12>;

/// Appends the roots in (0, 1) at which a polynomial in Bernstein form changes its sign, ascending. An even multiple
/// root touches zero without a change and is not one; how near two roots may be and still count depends on rounding
/// alone. Their number is odd where the ends' signs differ, whatever rounding does.
void append_bernstein_roots(std::span<const double> coefficients, RootList& roots);
/// The first of these alone.
void append_first_bernstein_root(std::span<const double> coefficients, RootList& roots);

/// Bernstein coefficients on [0, 1] of the polynomial sum of coefficients[i]*s^i, in place.
void bernstein_from_power(std::span<double> coefficients);

/// Coefficients of p(lower + s*(upper - lower)) from those of p(t) = sum of coefficients[i]*t^i, in place.
void change_interval(std::span<double> coefficients, double lower, double upper);

/// Value of sum of coefficients[i]*t^i.
inline double evaluate(std::span<const double> coefficients, double t) {
    double value = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;) value = value * t + coefficients[i];
    return value;
}

/// Appends the roots of sum of coefficients[i]*t^i in (lower, upper), at which its sign changes, ascending. `upper` may
/// be infinite.
void append_roots(std::span<const double> coefficients, double lower, double upper, RootList& roots);

}  // namespace sundog::solids
