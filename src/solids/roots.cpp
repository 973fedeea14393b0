// SPDX-License-Identifier: Apache-2.0
#include "solids/roots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sundog::solids {
namespace {

using Coefficients = std::array<double, kMaxDegree + 1>;

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

/// Value and derivative at s of a polynomial of degree N with Bernstein coefficients c: de Casteljau's scheme, whose
/// last but one row has both.
struct ValueAndSlope {
    double value, slope;
};
template <std::size_t N>
ValueAndSlope sample(const double* c, double s) {
    std::array<double, N + 1> b;
    std::copy_n(c, N + 1, b.begin());
    // Without loops all of it stays in registers, up to the degrees that lathes have.
    if constexpr (N <= 6) {
        const auto row = [&]<std::size_t... I>(std::index_sequence<I...>) { ((b[I] += s * (b[I + 1] - b[I])), ...); };
        const auto rows = [&]<std::size_t... R>(std::index_sequence<R...>) {
            (row(std::make_index_sequence<N - R>{}), ...);
        };
        rows(std::make_index_sequence<N - 1>{});
    } else {
        for (std::size_t n = N; n > 1; --n)
            for (std::size_t i = 0; i < n; ++i) b[i] += s * (b[i + 1] - b[i]);
    }
    const double rise = b[1] - b[0];
    return {b[0] + s * rise, static_cast<double>(N) * rise};
}

/// The only root between `lower` and `upper`, near s: Newton's steps, and halving where those would leave the interval.
/// Values up to `noise` are rounding; steps up to `tolerance` don't matter.
template <std::size_t N>
double root_between(const double* c, double lower, double upper, bool rises, double s, double noise, double tolerance) {
    double last_step = 0;  // of Newton's; 0 where the last step was none
    for (int i = 0; i < 200; ++i) {
        const ValueAndSlope at = sample<N>(c, s);
        ((at.value < 0) == rises ? lower : upper) = s;
        double next = s - at.value / at.slope;
        const bool newton = next > lower && next < upper;
        if (std::abs(at.value) <= noise) return newton ? next : s;
        if (!newton) next = 0.5 * (lower + upper);
        const double step = std::abs(next - s);
        const double small = tolerance * next + 1e-18;
        // Newton's steps go as the squares of those before: where the next one would be too small, this is the last.
        if (step <= small || (newton && step < 0.1 * last_step && step * step * step < small * last_step * last_step))
            return next;
        s = next;
        last_step = newton ? step : 0;
    }
    return s;
}

/// A place in an interval's end, with the polynomial's value there.
struct End {
    double s, value;
    bool turning;  ///< The derivative is 0 there.
};

/// Where a root between two ends is to be expected: by a parabola with its vertex at a turning point, else a line.
double guess_between(const End& a, const End& b) {
    const double share = a.value / (a.value - b.value);
    if (a.turning && b.turning) return a.s + (b.s - a.s) * (0.15 + 0.7 * share);
    const double part = a.turning ? std::sqrt(share) : b.turning ? 1 - std::sqrt(1 - share) : share;
    const double guess = a.s + (b.s - a.s) * part;
    return guess > a.s && guess < b.s ? guess : 0.5 * (a.s + b.s);
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

/// What a value is uncertain by.
double noise_of(std::span<const double> c) {
    double most = 0;
    for (const double v : c) most = std::max(most, std::abs(v));
    return 1e-16 * most;
}

/// Deepest halving: what is left is 2^-44 of the interval, where rounding decides.
constexpr int kMaxDepth = 44;

/// How well turning points need to be known: what a polynomial differs by there goes as the square of that.
constexpr double kTurnTolerance = 1e-9;

/// Writes the roots at which the sign changes, ascending, to `roots`, and returns their number; with `only_first`,
/// those after the first need not be there. Between the roots of the derivative, found in the same way, a polynomial is
/// monotone and has one root or none (Yuksel: High-Performance Polynomial Root Finding for Graphics, HPG 2022);
/// Descartes' rule of signs spares most of the work.
template <std::size_t N>
std::size_t find_roots(const double* c, double* roots, double tolerance, bool only_first = false) {
    const int changes = sign_changes({c, N + 1});
    if (changes == 0) return 0;
    if constexpr (N == 1) {
        if (c[0] == 0 || c[1] == 0) return 0;
        roots[0] = c[0] / (c[0] - c[1]);
        return 1;
    } else {
        const double noise = noise_of({c, N + 1});
        if (changes == 1 && c[0] != 0 && c[N] != 0) {
            const double guess = guess_between({0, c[0], false}, {1, c[N], false});
            roots[0] = root_between<N>(c, 0, 1, c[0] < 0, guess, noise, tolerance);
            return 1;
        }
        if (N == 2 && changes == 2) {
            // Both ends on one side, the middle coefficient on the other.
            const double discriminant = c[1] * c[1] - c[0] * c[2];
            if (!(discriminant > 0)) return 0;
            const double q = c[0] - c[1] + std::copysign(std::sqrt(discriminant), c[0]);
            roots[0] = c[0] / q;
            roots[1] = q / (c[0] - 2 * c[1] + c[2]);
            return 2;
        }
        std::array<double, N> derivative;
        for (std::size_t i = 0; i < N; ++i) derivative[i] = c[i + 1] - c[i];
        std::array<double, N> turns;
        bool negative = first_sign({c, N + 1}) < 0;
        if (N > 3 && only_first && find_roots<N - 1>(derivative.data(), turns.data(), kTurnTolerance, true) > 0) {
            // Mostly the first root comes before the second turn.
            const End turn{turns[0], sample<N>(c, turns[0]).value, true};
            if (turn.value != 0 && (turn.value < 0) != negative) {
                const double guess = guess_between({0, c[0], false}, turn);
                roots[0] = root_between<N>(c, 0, turn.s, negative, guess, noise, tolerance);
                return 1;
            }
        }
        const std::size_t turn_count = find_roots<N - 1>(derivative.data(), turns.data(), kTurnTolerance);
        std::size_t found = 0;
        End from{0, c[0], false};
        for (std::size_t i = 0; i <= turn_count; ++i) {
            const bool last = i == turn_count;
            const End to = last ? End{1, c[N], false} : End{turns[i], sample<N>(c, turns[i]).value, true};
            // At a turning point of value 0 the polynomial touches zero, and doesn't cross it.
            const bool differs =
                last ? (last_sign({c, N + 1}) < 0) != negative : to.value != 0 && (to.value < 0) != negative;
            if (differs) {
                roots[found++] = root_between<N>(c, from.s, to.s, negative, guess_between(from, to), noise, tolerance);
                if (only_first) return found;
                negative = !negative;
            }
            from = to;
        }
        return found;
    }
}

/// De Casteljau at the middle: c becomes the left half's coefficients, right gets the right half's.
template <std::size_t N>
void split(double* c, double* right) {
    for (std::size_t level = 0; level <= N; ++level) {
        right[N - level] = c[N];
        for (std::size_t i = N; i > level; --i) c[i] = 0.5 * (c[i] + c[i - 1]);
    }
}

/// For degrees from which on all derivatives would take longer: control polygons are halved until their sign changes
/// once (Lane, Riesenfeld: Bounds on a Polynomial, BIT 21, 1981).
template <std::size_t N>
void append_halved(double* c, double lower, double width, int depth, RootList& roots) {
    const int changes = sign_changes({c, N + 1});
    if (changes == 0) return;
    if (changes == 1 && c[0] != 0 && c[N] != 0) {
        const double guess = guess_between({0, c[0], false}, {1, c[N], false});
        roots.push_back(lower + width * root_between<N>(c, 0, 1, c[0] < 0, guess, noise_of({c, N + 1}), 4e-16));
        return;
    }
    if (depth == kMaxDepth) {
        if (changes % 2 == 1) roots.push_back(lower + 0.5 * width);
        return;
    }
    std::array<double, N + 1> right;
    split<N>(c, right.data());
    // A root at the very middle belongs to neither half's inside: the change of sign across it tells.
    const bool at_middle = right[0] == 0 && last_sign({c, N + 1}) * first_sign(right) < 0;
    append_halved<N>(c, lower, 0.5 * width, depth + 1, roots);
    if (at_middle) roots.push_back(lower + 0.5 * width);
    append_halved<N>(right.data(), lower + 0.5 * width, 0.5 * width, depth + 1, roots);
}

template <std::size_t N>
void append_of_degree(const double* c, RootList& roots) {
    if constexpr (N <= 4) {
        std::array<double, N> found;
        const std::size_t count = find_roots<N>(c, found.data(), 4e-16);
        for (std::size_t i = 0; i < count; ++i) roots.push_back(found[i]);
    } else {
        std::array<double, N + 1> copy;
        std::copy_n(c, N + 1, copy.begin());
        append_halved<N>(copy.data(), 0, 1, 0, roots);
    }
}

using RootFinder = void (*)(const double*, RootList&);
/// append_of_degree<N> at place N - 1.
constexpr auto kRootFinders = []<std::size_t... N>(std::index_sequence<N...>) {
    return std::array<RootFinder, sizeof...(N)>{append_of_degree<N + 1>...};
}
(std::make_index_sequence<kMaxDegree>{});

/// Reciprocals of the binomial coefficients.
constexpr auto kInverseBinomials = [] {
    std::array<std::array<double, kMaxDegree + 1>, kMaxDegree + 1> table{};
    for (std::size_t n = 0; n <= kMaxDegree; ++n) {
        double binomial = 1;
        for (std::size_t k = 0; k <= n; ++k) {
            table[n][k] = 1 / binomial;
            binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
        }
    }
    return table;
}();

}  // namespace

void append_bernstein_roots(std::span<const double> coefficients, RootList& roots) {
    if (coefficients.size() < 2 || coefficients.size() > kMaxDegree + 1) return;
    kRootFinders[coefficients.size() - 2](coefficients.data(), roots);
}

void append_first_bernstein_root(std::span<const double> coefficients, RootList& roots) {
    if (coefficients.size() != 5) return append_bernstein_roots(coefficients, roots);
    std::array<double, 4> found;
    if (find_roots<4>(coefficients.data(), found.data(), 4e-16, true) > 0) roots.push_back(found[0]);
}

void bernstein_from_power(std::span<double> c) {
    // b_i = sum over k <= i of C(i,k)/C(n,k) * a_k: divide by C(n,k), then Pascal's triangle of sums.
    const std::size_t n = c.size() - 1;
    for (std::size_t k = 0; k <= n; ++k) c[k] *= kInverseBinomials[n][k];
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
    if (lower != 0) change_interval(c, lower, lower + 1);
    const std::size_t n = size - 1;
    // About the roots' geometric mean.
    const int exponent = c[0] != 0 ? (std::ilogb(c[0]) - std::ilogb(c[n])) / static_cast<int>(n) : 0;
    const double scale = std::ldexp(1.0, std::clamp(exponent, -40, 40));
    const double width = upper - lower;
    if (width < 1e4 * scale) {
        change_interval(c, 0, width);
        bernstein_from_power(c);
        RootList found;
        append_bernstein_roots(c, found);
        for (const double s : found) roots.push_back(lower + s * width);
        return;
    }
    // t = lower + scale*s/(1 - s) carries all that is ahead to s in (0, 1), and the power coefficients are Bernstein's
    // but for binomials.
    std::array<double, kMaxDegree + 1> bernstein;
    double power = 1;
    for (std::size_t i = 0; i <= n; ++i) {
        bernstein[i] = c[i] * power * kInverseBinomials[n][i];
        power *= scale;
    }
    RootList found;
    append_bernstein_roots({bernstein.data(), size}, found);
    for (const double s : found) {
        double t = scale * s / (1 - s);
        // Far out 1 - s has lost digits; one of Newton's steps on the coefficients as they were brings them back.
        double value = 0;
        double slope = 0;
        for (std::size_t i = size; i-- > 0;) slope = slope * t + value, value = value * t + c[i];
        const double step = value / slope;
        if (std::abs(step) < 1e-6 * t) t -= step;
        if (t < width) roots.push_back(lower + t);
    }
}

}  // namespace sundog::solids
