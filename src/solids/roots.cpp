// SPDX-License-Identifier: Apache-2.0
#include "solids/roots.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sundog::solids {
namespace {

using Coefficients = std::array<double, kMaxDegree + 1>;

/// Deepest subdivision: what is left is 2^-44 of the interval, where rounding decides.
constexpr int kMaxDepth = 44;

int sign_changes(std::span<const double> c) {
    int changes = 0;
    bool last_negative = false;
    bool any = false;
    for (const double v : c) {
        if (v == 0) continue;
        const bool negative = v < 0;
        if (any && negative != last_negative) ++changes;
        last_negative = negative;
        any = true;
    }
    return changes;
}

double evaluate_bernstein(std::span<const double> c, double s) {
    if (c.size() <= 7) {  // de Casteljau's scheme, which needs no division
        std::array<double, 7> b;
        std::copy(c.begin(), c.end(), b.begin());
        for (std::size_t n = c.size() - 1; n > 0; --n)
            for (std::size_t i = 0; i < n; ++i) b[i] += s * (b[i + 1] - b[i]);
        return b[0];
    }
    // Horner's scheme in s/(1-s) or its inverse, whichever is at most 1.
    const std::size_t n = c.size() - 1;
    const bool low = s <= 0.5;
    const double larger = low ? 1 - s : s;
    const double x = (1 - larger) / larger;
    double weight = 1;
    double scale = 1;
    double sum = 0;
    for (std::size_t i = 0; i <= n; ++i) {
        sum += weight * (low ? c[i] : c[n - i]);
        weight *= x * static_cast<double>(n - i) / static_cast<double>(i + 1);
        if (i > 0) scale *= larger;
    }
    return sum * scale;
}

/// The only root between 0 and 1 of a polynomial whose ends differ in sign: inverse quadratic steps where they can be
/// trusted, else bisection (Chandrupatla: A new hybrid quadratic/bisection algorithm for finding the zero of a
/// nonlinear function without using derivatives, Advances in Engineering Software 28, 1997).
double single_root(std::span<const double> c) {
    double newest = 1;
    double opposite = 0;
    double f_newest = c.back();
    double f_opposite = c.front();
    double step = 0.5;
    for (int i = 0; i < 200; ++i) {
        const double s = newest + step * (opposite - newest);
        const double f = evaluate_bernstein(c, s);
        double before = newest;
        double f_before = f_newest;
        if ((f < 0) != (f_newest < 0)) {
            before = opposite, f_before = f_opposite;
            opposite = newest, f_opposite = f_newest;
        }
        newest = s, f_newest = f;
        const bool newest_is_best = std::abs(f_newest) < std::abs(f_opposite);
        const double best = newest_is_best ? newest : opposite;
        const double tolerance = 4e-16 * best + 1e-18;
        const double share = tolerance / std::abs(opposite - newest);
        if (f == 0) return s;
        if (!(share < 0.5)) return best;
        const double xi = (newest - opposite) / (before - opposite);
        const double phi = (f_newest - f_opposite) / (f_before - f_opposite);
        step = 0.5;
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
            step = f_newest / (f_opposite - f_newest) * f_before / (f_opposite - f_before) +
                   (before - newest) / (opposite - newest) * f_newest / (f_before - f_newest) * f_opposite /
                       (f_before - f_opposite);
        step = std::clamp(step, share, 1 - share);
    }
    return newest;
}

/// Sign of the first coefficient that is not 0: the polynomial's just after the interval's beginning.
int first_sign(std::span<const double> c) {
    for (const double v : c)
        if (v != 0) return v < 0 ? -1 : 1;
    return 0;
}
int last_sign(std::span<const double> c) {
    for (std::size_t i = c.size(); i-- > 0;)
        if (c[i] != 0) return c[i] < 0 ? -1 : 1;
    return 0;
}

/// De Casteljau at the middle: c becomes the left half's coefficients, right gets the right half's.
void split(std::span<double> c, std::span<double> right) {
    const std::size_t n = c.size();
    for (std::size_t level = 0; level < n; ++level) {
        right[n - 1 - level] = c[n - 1];
        for (std::size_t i = n - 1; i > level; --i) c[i] = 0.5 * (c[i] + c[i - 1]);
    }
}

void append_in(std::span<double> c, double lower, double width, int depth, RootList& roots) {
    const int changes = sign_changes(c);
    if (changes == 0) return;
    if (changes == 1 && c.front() != 0 && c.back() != 0) {
        roots.push_back(lower + width * single_root(c));
        return;
    }
    if (depth == kMaxDepth) {
        if (changes % 2 == 1) roots.push_back(lower + 0.5 * width);
        return;
    }
    Coefficients right_half{};
    const std::span<double> right(right_half.data(), c.size());
    split(c, right);
    // A root at the very middle belongs to neither half's inside: the change of sign across it tells.
    const bool at_middle = right.front() == 0 && last_sign(c) * first_sign(right) < 0;
    append_in(c, lower, 0.5 * width, depth + 1, roots);
    if (at_middle) roots.push_back(lower + 0.5 * width);
    append_in(right, lower + 0.5 * width, 0.5 * width, depth + 1, roots);
}

}  // namespace

void append_bernstein_roots(std::span<const double> coefficients, RootList& roots) {
    if (coefficients.empty() || coefficients.size() > kMaxDegree + 1 || sign_changes(coefficients) == 0) return;
    Coefficients copy;
    std::copy(coefficients.begin(), coefficients.end(), copy.begin());
    append_in({copy.data(), coefficients.size()}, 0, 1, 0, roots);
}

void bernstein_from_power(std::span<double> c) {
    // b_i = sum over k <= i of C(i,k)/C(n,k) * a_k: divide by C(n,k), then Pascal's triangle of sums.
    const std::size_t n = c.size() - 1;
    double binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        c[k] /= binomial;
        binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    for (std::size_t level = 1; level <= n; ++level)
        for (std::size_t i = n; i >= level; --i) c[i] += c[i - 1];
}

void change_interval(std::span<double> c, double lower, double upper) {
    const std::size_t n = c.size();
    if (lower != 0)
        for (std::size_t i = 1; i < n; ++i)
            for (std::size_t k = n - 1; k-- + 1 > i;) c[k] += lower * c[k + 1];
    const double width = upper - lower;
    double power = 1;
    for (std::size_t i = 0; i < n; ++i) {
        c[i] *= power;
        power *= width;
    }
}

void append_roots(std::span<const double> coefficients, double lower, double upper, RootList& roots) {
    std::size_t size = std::min(coefficients.size(), kMaxDegree + 1);
    while (size > 0 && coefficients[size - 1] == 0) --size;
    if (size < 2 || !(lower < upper)) return;
    Coefficients copy;
    const std::span<double> c(copy.data(), size);
    std::copy_n(coefficients.begin(), size, copy.begin());
    if (std::isfinite(upper)) {
        change_interval(c, lower, upper);
        bernstein_from_power(c);
        RootList found;
        append_bernstein_roots(c, found);
        for (const double s : found) roots.push_back(lower + s * (upper - lower));
        return;
    }
    // [lower, lower + w] as above; beyond it in 1/t, with w so that the coefficients balance.
    change_interval(c, lower, lower + 1);
    double w = 1;
    for (std::size_t i = 1; i < size; ++i)
        if (c[0] != 0 && c[i] != 0) w = std::max(w, std::pow(std::abs(c[0] / c[i]), 1.0 / static_cast<double>(i)));
    w = std::min(w, 1e12);
    change_interval(c, 0, w);
    Coefficients reversed;
    std::reverse_copy(c.begin(), c.end(), reversed.begin());
    bernstein_from_power(c);
    RootList found;
    append_bernstein_roots(c, found);
    for (const double s : found) roots.push_back(lower + s * w);
    found.clear();
    const std::span<double> beyond(reversed.data(), size);
    bernstein_from_power(beyond);
    if (c.back() == 0 && last_sign(c) * last_sign(beyond) < 0) roots.push_back(lower + w);
    append_bernstein_roots(beyond, found);
    for (std::size_t i = found.size(); i-- > 0;)
        if (found[i] > 0) roots.push_back(lower + w / found[i]);
}

}  // namespace sundog::solids
