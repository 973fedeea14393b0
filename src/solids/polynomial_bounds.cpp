// SPDX-License-Identifier: Apache-2.0
#include "solids/polynomial_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace sundog::solids {
namespace {

using Term = scene::Polynomial::Term;

struct Interval {
    double lower = 0, upper = 0;
};

double power(double x, unsigned n) {
    double result = 1;
    for (; n > 0; --n) result *= x;
    return result;
}

Interval power(Interval x, unsigned n) {
    if (n == 0) return {1, 1};
    const double a = power(x.lower, n);
    const double b = power(x.upper, n);
    if (n % 2 == 1) return {a, b};
    return {x.lower <= 0 && x.upper >= 0 ? 0 : std::min(a, b), std::max(a, b)};
}

Interval product(Interval a, Interval b) {
    const double p = a.lower * b.lower;
    const double q = a.lower * b.upper;
    const double r = a.upper * b.lower;
    const double s = a.upper * b.upper;
    return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}

/// Not above the polynomial's least value in the box.
double lower_bound(std::span<const Term> terms, const Bounds3d& box) {
    double sum = 0;
    double size = 0;
    for (const Term& t : terms) {
        Interval value = power({box.lower.x, box.upper.x}, t.x);
        value = product(value, power({box.lower.y, box.upper.y}, t.y));
        value = product(value, power({box.lower.z, box.upper.z}, t.z));
        sum += std::min(t.coefficient * value.lower, t.coefficient * value.upper);
        size += std::abs(t.coefficient) * std::max(std::abs(value.lower), std::abs(value.upper));
    }
    return sum - 1e-12 * size;  // room for rounding
}

/// Half the side of a cube around the origin that holds everything, after Cauchy: the terms of the highest order are
/// at least `least` times the n-th power of the largest coordinate, and those below can't make up for that farther out.
/// 0 where the terms of the highest order have another form.
double reach_of(std::span<const Term> terms, std::size_t order) {
    if (order == 0 || order % 2 == 1) return 0;
    std::vector<double> below(order, 0.0);  // Of each order below: how much its terms can take away.
    double least = std::numeric_limits<double>::infinity();
    std::size_t pure = 0;
    for (const Term& t : terms) {
        const std::size_t degree = std::size_t{t.x} + t.y + t.z;
        const bool even = t.x % 2 == 0 && t.y % 2 == 0 && t.z % 2 == 0;
        if (even && t.coefficient >= 0) {
            if (degree < order || std::max({t.x, t.y, t.z}) < order || t.coefficient == 0) continue;
            least = std::min(least, t.coefficient);
            ++pure;
        } else if (degree == order) {
            return 0;
        } else {
            below[degree] += std::abs(t.coefficient);
        }
    }
    if (pure < 3) return 0;
    const auto holds_all = [&](double reach) {
        double sum = 0;
        for (std::size_t degree = 0; degree < order; ++degree)
            sum += below[degree] * std::pow(reach, static_cast<double>(degree) - static_cast<double>(order));
        return sum < least;
    };
    double reach = 1e-6;
    while (!holds_all(reach)) {
        reach *= 1.1;
        if (reach > 1e9) return 0;
    }
    return reach;
}

/// The largest value of a coordinate (or the least, for sign -1) at which the polynomial isn't positive in the box, or
/// a little beyond: branch and bound, the farthest part first.
double extreme(std::span<const Term> terms, const Bounds3d& within, std::size_t axis, double sign) {
    constexpr int kSteps = 300;           // Some milliseconds in all.
    constexpr double kPrecision = 0.005;  // Of the size of `within`: closer bounds save nothing.
    const double fine = kPrecision * (within.upper - within.lower)[axis];
    struct Part {
        Bounds3d box;
        double end;  ///< How far it reaches, times the sign.
    };
    const auto nearer = [](const Part& a, const Part& b) { return a.end < b.end; };
    std::priority_queue<Part, std::vector<Part>, decltype(nearer)> parts(nearer);
    const auto add = [&](const Bounds3d& box) {
        if (lower_bound(terms, box) <= 0) parts.push({box, sign * (sign > 0 ? box.upper : box.lower)[axis]});
    };
    add(within);
    for (int step = 0; step < kSteps && !parts.empty(); ++step) {
        const Bounds3d box = parts.top().box;
        Vec3d size = box.upper - box.lower;
        // Somewhere in a flat enough part that the polynomial isn't known to be positive in: as good as it gets.
        if (size[axis] <= fine && std::max({size.x, size.y, size.z}) <= fine) break;
        parts.pop();
        size[axis] *= 4;
        const std::size_t longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const double middle = 0.5 * (box.lower[longest] + box.upper[longest]);
        Bounds3d half = box;
        half.upper[longest] = middle;
        add(half);
        half = box;
        half.lower[longest] = middle;
        add(half);
    }
    return parts.empty() ? -std::numeric_limits<double>::infinity() : sign * parts.top().end;
}

}  // namespace

std::optional<QuarticTorus> as_torus(std::span<const Term> terms) {
    // (|p|^2 + R^2 - r^2)^2 - 4*R^2*(|p|^2 - a^2), where a is the coordinate along the axis.
    const auto coefficient = [&](unsigned x, unsigned y, unsigned z) {
        double sum = 0;
        for (const Term& t : terms)
            if (t.x == x && t.y == y && t.z == z) sum += t.coefficient;
        return sum;
    };
    const double fourth = coefficient(4, 0, 0);
    const double constant = coefficient(0, 0, 0);
    const std::array<double, 3> square{coefficient(2, 0, 0), coefficient(0, 2, 0), coefficient(0, 0, 2)};
    if (!(fourth > 0)) return std::nullopt;
    double others = 0;
    for (const Term& t : terms) {
        const bool even = t.x % 2 == 0 && t.y % 2 == 0 && t.z % 2 == 0;
        if (!even || t.x + t.y + t.z > 4) others += std::abs(t.coefficient);
    }
    const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); };
    if (others != 0 || !same(coefficient(0, 4, 0), fourth) || !same(coefficient(0, 0, 4), fourth) ||
        !same(coefficient(2, 2, 0), 2 * fourth) || !same(coefficient(2, 0, 2), 2 * fourth) ||
        !same(coefficient(0, 2, 2), 2 * fourth))
        return std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double across = square[(axis + 1) % 3] / fourth;  // -2*(R^2 + r^2)
        const double along = square[axis] / fourth;             // 2*(R^2 - r^2)
        if (!same(square[(axis + 1) % 3], square[(axis + 2) % 3]) || !same(constant / fourth, 0.25 * along * along))
            continue;
        const double major = 0.25 * (along - across);
        const double minor = -0.25 * (along + across);
        if (major > 0 && minor > 0) return QuarticTorus{axis, std::sqrt(major), std::sqrt(minor)};
    }
    return std::nullopt;
}

Bounds3d polynomial_bounds(std::span<const Term> terms, std::size_t order) {
    if (const std::optional<QuarticTorus> torus = as_torus(terms)) {
        const double reach = torus->major_radius + torus->minor_radius;
        Bounds3d box{{-reach, -reach, -reach}, {reach, reach, reach}};
        box.lower[torus->axis] = -torus->minor_radius;
        box.upper[torus->axis] = torus->minor_radius;
        return box;
    }
    const double reach = reach_of(terms, order);
    if (reach == 0) return everywhere();
    Bounds3d box{{-reach, -reach, -reach}, {reach, reach, reach}};
    // Twice: what the first round finds of the other axes helps.
    for (std::size_t i = 0; i < 12; ++i) {
        const std::size_t axis = i / 2 % 3;
        const double sign = i % 2 == 0 ? 1 : -1;
        const double end = extreme(terms, box, axis, sign);
        if (std::isinf(end)) return {};
        (sign > 0 ? box.upper : box.lower)[axis] = end;
    }
    return box;
}

}  // namespace sundog::solids
