// SPDX-License-Identifier: Apache-2.0
// Every operation of functions over ranges (fields/affine.h), for fields/run.h.
#pragma once

#include <algorithm>
#include <numbers>
#include <optional>

#include "fields/affine.h"
#include "fields/double_math.h"

namespace sundog::fields {

template <std::size_t N>
struct AffineMath {
    using Value = Affine<N>;
    const PigmentSource* pigments = nullptr;
    NoiseCells* cells = nullptr;
    bool* undefined = nullptr;  ///< Set where an operation may have no value (the square root of -1).

    static Value constant(double v) { return exactly<N>(v); }
    static std::optional<double> plain(const Value& a) {
        return a.lower == a.upper ? std::optional(a.lower) : std::nullopt;
    }
    static Value unknown() { return anywhere<N>(-kInfinite, kInfinite); }

    static Value negate(const Value& a) { return negated(a); }
    static Value add(const Value& a, const Value& b) { return sum_of(a, b); }
    static Value subtract(const Value& a, const Value& b) { return sum_of(a, negated(b)); }
    static Value multiply(const Value& a, const Value& b) { return product_of(a, b); }
    Value divide(const Value& a, const Value& b) const {
        if (b.lower == b.upper && b.lower != 0) {
            const double p = a.lower / b.lower, q = a.upper / b.lower, by = 1 / b.lower;
            return line_of(a, by, 0, (std::fabs(a.centre) + slope_sum(a)) * std::fabs(by) * kRounding,
                           below(std::min(p, q)), above(std::max(p, q)));
        }
        if (b.lower <= 0 && b.upper >= 0 && a.lower <= 0 && a.upper >= 0) note_undefined();
        Value out = product_of(a, reciprocal(b));
        if (b.lower > 0 || b.upper < 0) {
            // Tighter than by way of the reciprocal's rounded ends.
            const double p = a.lower / b.lower, q = a.lower / b.upper, r = a.upper / b.lower, s = a.upper / b.upper;
            out.lower = std::max(out.lower, below(std::min(std::min(p, q), std::min(r, s))));
            out.upper = std::min(out.upper, above(std::max(std::max(p, q), std::max(r, s))));
        }
        return out;
    }
    static Value reciprocal(const Value& a) {
        if (a.lower <= 0 && a.upper >= 0) return unknown();
        if (a.upper < 0) return negated(reciprocal(negated(a)));
        const double low = 1 / a.upper, high = 1 / a.lower;
        const double gap = std::sqrt(high) - std::sqrt(low);
        return chord_of(a, high, low, gap * gap * (1 + 1e-14), 0.0, below(low), above(high));
    }

    static Value absolute(const Value& a) {
        if (a.lower >= 0) return a;
        if (a.upper <= 0) return negated(a);
        const double dip = 2 * -a.lower * a.upper / (a.upper - a.lower);
        return chord_of(a, -a.lower, a.upper, dip * (1 + 1e-14), 0.0, 0.0, std::max(-a.lower, a.upper));
    }
    static Value square(const Value& a) {
        const double p = a.lower * a.lower, q = a.upper * a.upper, width = a.upper - a.lower;
        const double least = a.lower <= 0 && a.upper >= 0 ? 0 : std::max(0.0, below(std::min(p, q)));
        return chord_of(a, p, q, 0.25 * width * width * (1 + 1e-14), 0.0, least, above(std::max(p, q)));
    }
    Value square_root(const Value& a) const {
        if (a.lower < 0) note_undefined();
        const Value b = at_least(a, 0);
        const double p = std::sqrt(b.lower), q = std::sqrt(b.upper);
        const double gap = q - p, rise = q + p > 0 ? gap * gap / (4 * (q + p)) : 0;
        return chord_of(b, p, q, 0.0, rise * (1 + 1e-14), std::max(0.0, below(p)), above(q));
    }
    static Value exponential(const Value& a) {
        const double p = std::exp(a.lower), q = std::exp(a.upper), width = a.upper - a.lower;
        // The chord of a convex function lies above it by an eighth of the largest second derivative at most.
        return chord_of(a, p, q, std::min(0.125 * q * width * width * (1 + 1e-13), q), 0.0,
                        std::max(0.0, well_below(p)), well_above(q));
    }
    Value logarithm(const Value& a) const {
        if (a.lower < 0) note_undefined();
        const Value b = at_least(a, 0);
        const double p = std::log(b.lower), q = std::log(b.upper), width = b.upper - b.lower;
        const double rise = 0.125 * width * width / (b.lower * b.lower);
        return chord_of(b, p, q, 0.0, rise * (1 + 1e-13), well_below(p), well_above(q));
    }
    static Value sine(const Value& a) { return wave(a, 0); }
    static Value cosine(const Value& a) { return wave(a, 0.25); }
    static Value tangent(const Value& a) {
        // Poles lie half a turn apart; sin and cos know how far they can be told.
        const Value c = cosine(a);
        if (c.lower <= 1e-12 && c.upper >= -1e-12) return unknown();
        if (!(a.upper - a.lower < 3)) return unknown();
        const double p = std::tan(a.lower), q = std::tan(a.upper);
        const double slack = (std::fabs(a.lower) + std::fabs(a.upper)) * kRounding;
        const double steep = 1 / std::min(c.lower * c.lower, c.upper * c.upper);
        const double most = std::max(std::fabs(p), std::fabs(q));
        return curved(a, p, q, 2 * most * steep, slack * steep, well_below(p), well_above(q));
    }
    static Value arc_sine(const Value& a) {
        const Value b = cut_off(a, -1, 1);
        const double p = std::asin(b.lower), q = std::asin(b.upper);
        return sloped(b, p, q, std::fmax(1 / std::sqrt(1 - b.lower * b.lower), 1 / std::sqrt(1 - b.upper * b.upper)), 1,
                      well_below(p), well_above(q));
    }
    static Value arc_cosine(const Value& a) { return subtract(constant_about(std::numbers::pi / 2), arc_sine(a)); }
    static Value arc_tangent(const Value& a) {
        const double p = std::atan(a.lower), q = std::atan(a.upper);
        return curved(a, p, q, 0.6496, 0.0, well_below(p), well_above(q));
    }
    static Value hyperbolic_sine(const Value& a) {
        const double p = std::sinh(a.lower), q = std::sinh(a.upper);
        return curved(a, p, q, std::max(std::fabs(p), std::fabs(q)), 0.0, well_below(p), well_above(q));
    }
    static Value hyperbolic_cosine(const Value& a) {
        const double p = std::cosh(a.lower), q = std::cosh(a.upper), most = std::max(p, q);
        const double least = a.lower <= 0 && a.upper >= 0 ? 1 : std::max(1.0, well_below(std::min(p, q)));
        return curved(a, p, q, most, 0.0, least, well_above(most));
    }
    static Value hyperbolic_tangent(const Value& a) {
        const double p = std::tanh(a.lower), q = std::tanh(a.upper);
        return curved(a, p, q, 0.7699, 0.0, std::max(-1.0, well_below(p)), std::min(1.0, well_above(q)));
    }
    static Value inverse_hyperbolic_sine(const Value& a) {
        const double p = std::asinh(a.lower), q = std::asinh(a.upper);
        return curved(a, p, q, 0.385, 0.0, well_below(p), well_above(q));
    }
    Value inverse_hyperbolic_cosine(const Value& a) const {
        if (a.lower < 1) note_undefined();
        const Value b = at_least(a, 1);
        const double p = std::acosh(b.lower), q = std::acosh(b.upper);
        return sloped(b, p, q, 1 / std::sqrt(b.lower * b.lower - 1), 1 / std::sqrt(b.upper * b.upper - 1),
                      std::max(0.0, well_below(p)), well_above(q));
    }
    Value inverse_hyperbolic_tangent(const Value& a) const {
        if (a.lower < -1 || a.upper > 1) note_undefined();
        const Value b = cut_off(a, -1, 1);
        const double p = std::atanh(b.lower), q = std::atanh(b.upper);
        return sloped(b, p, q, 1, std::fmax(1 / (1 - b.lower * b.lower), 1 / (1 - b.upper * b.upper)), well_below(p),
                      well_above(q));
    }
    static Value floor(const Value& a) {
        const double p = std::floor(a.lower), q = std::floor(a.upper);
        if (p == q) return exactly<N>(p);
        return line_of(a, 1, -0.5, 0.5, p, q);
    }
    static Value truncate(const Value& a) {
        const double p = std::trunc(a.lower), q = std::trunc(a.upper);
        if (p == q) return exactly<N>(p);
        if (a.lower >= 0) return floor(a);
        if (a.upper <= 0) return negated(floor(negated(a)));
        return line_of(a, 1, 0, 1, p, q);
    }

    static Value logical_not(const Value& a) { return truth_of(!may_be_true(a), !must_be_true(a)); }
    static Value logical_and(const Value& a, const Value& b) {
        return truth_of(must_be_true(a) && must_be_true(b), may_be_true(a) && may_be_true(b));
    }
    static Value logical_or(const Value& a, const Value& b) {
        return truth_of(must_be_true(a) || must_be_true(b), may_be_true(a) || may_be_true(b));
    }
    static Value less(const Value& a, const Value& b) { return truth_of(a.upper < b.lower, a.lower < b.upper); }
    static Value less_equal(const Value& a, const Value& b) { return truth_of(a.upper <= b.lower, a.lower <= b.upper); }
    static Value equal(const Value& a, const Value& b) {
        const Value d = subtract(a, b);
        const double e = scene::kFunctionEpsilon;
        return truth_of(d.lower >= -e && d.upper <= e, d.lower <= e && d.upper >= -e);
    }
    static Value bitwise(scene::FunctionOp op, const Value& a, const Value& b) {
        const auto x = whole(a), y = whole(b);
        if (x && y) return exactly<N>(DoubleMath::bitwise(op, *x, *y));
        // Both without a sign: below the next power of two above them.
        if (a.lower >= 0 && b.lower >= 0 && a.upper < 9e15 && b.upper < 9e15)
            return anywhere<N>(0, std::exp2(std::ceil(std::log2(std::max(a.upper, b.upper) + 1))));
        return unknown();
    }

    static Value minimum(const Value& a, const Value& b) {
        if (a.upper <= b.lower) return a;
        if (b.upper <= a.lower) return b;
        return extreme(a, b, false);
    }
    static Value maximum(const Value& a, const Value& b) {
        if (a.lower >= b.upper) return a;
        if (b.lower >= a.upper) return b;
        return extreme(a, b, true);
    }
    Value power(const Value& a, const Value& b) const {
        const auto whole_exponent = plain(b);
        if (a.lower < 0) {
            if (!whole_exponent || *whole_exponent != std::trunc(*whole_exponent)) {
                // Negative numbers to whole powers may lie in between.
                note_undefined();
                const Value size = power_of_positive(absolute(a), b);
                return anywhere<N>(-size.upper, size.upper);
            }
            const bool even = std::fmod(*whole_exponent, 2) == 0;
            if (even) return power_of_positive(absolute(a), b);
            if (a.upper <= 0) return negated(power_of_positive(negated(a), b));
            if (*whole_exponent < 0) return unknown();
            return anywhere<N>(well_below(std::pow(a.lower, *whole_exponent)),
                               well_above(std::pow(a.upper, *whole_exponent)));
        }
        return power_of_positive(a, b);
    }
    Value modulo(const Value& a, const Value& b) const {
        if (b.lower <= 0 && b.upper >= 0) note_undefined();
        const double most = std::max(std::fabs(b.lower), std::fabs(b.upper));
        if (const auto divisor = plain(b); divisor && *divisor != 0) {
            const double p = std::trunc(a.lower / *divisor), q = std::trunc(a.upper / *divisor);
            // Where no multiple lies in between the remainder is the dividend less a constant.
            const double margin = 1e-12 * std::max(std::fabs(a.lower), std::fabs(a.upper));
            const bool clear =
                std::trunc((a.lower - margin) / *divisor) == p && std::trunc((a.upper + margin) / *divisor) == p;
            if (p == q && clear && (a.lower >= 0 || a.upper <= 0)) {
                const double whole = p * *divisor, slack = std::fabs(whole) * kRounding;
                return line_of(a, 1, -whole, slack, below(a.lower - whole) - slack, above(a.upper - whole) + slack);
            }
        }
        return anywhere<N>(a.lower >= 0 ? 0.0 : -std::min(most, -a.lower),
                           a.upper <= 0 ? 0.0 : std::min(most, a.upper));
    }
    static Value arc_tangent2(const Value& y, const Value& x) {
        constexpr double kPi = std::numbers::pi;
        const bool crosses_cut = x.lower <= 0 && y.lower <= 0 && y.upper >= 0;
        if (crosses_cut) return anywhere<N>(well_below(-kPi), well_above(kPi));
        // Off the cut the angle is extreme at corners of the box.
        double low = kInfinite, high = -kInfinite;
        for (const double v : {y.lower, y.upper}) {
            for (const double u : {x.lower, x.upper}) {
                const double angle = std::atan2(v, u);
                low = std::min(low, angle), high = std::max(high, angle);
            }
        }
        const double near_x = x.lower > 0 ? x.lower : x.upper < 0 ? -x.upper : 0;
        const double near_y = y.lower > 0 ? y.lower : y.upper < 0 ? -y.upper : 0;
        const double near = near_x * near_x + near_y * near_y;
        // About the middle of the box; the matrix of second derivatives has the norm 1/r^2.
        const double u = 0.5 * (x.lower + x.upper), v = 0.5 * (y.lower + y.upper), r2 = u * u + v * v;
        const double half_x = 0.5 * (x.upper - x.lower), half_y = 0.5 * (y.upper - y.lower);
        const double bend = 0.5 * (half_x * half_x + half_y * half_y) / near;
        if (!(bend < high - low)) return anywhere<N>(well_below(low), well_above(high));
        const double by_x = -v / r2, by_y = u / r2;
        const Value part_x = line_of(x, by_x, -by_x * u, 0, -kInfinite, kInfinite);
        const Value part_y = line_of(y, by_y, -by_y * v, 0, -kInfinite, kInfinite);
        Value out = sum_of(part_x, part_y);
        const double middle = std::atan2(v, u);
        out = line_of(out, 1, middle, bend * (1 + 1e-12) + 16 * kRounding, well_below(low), well_above(high));
        return out;
    }

    static Value select_negative(const Value& a, const Value& b, const Value& c) {
        return a.upper < 0 ? b : a.lower >= 0 ? c : either(b, c);
    }
    static Value select_zero(const Value& a, const Value& b, const Value& c) {
        if (a.lower == 0 && a.upper == 0) return b;
        return a.lower > 0 || a.upper < 0 ? c : either(b, c);
    }
    Value noise(std::uint32_t generator, const Value& x, const Value& y, const Value& z) const {
        const Vec3d middle{0.5 * (x.lower + x.upper), 0.5 * (y.lower + y.upper), 0.5 * (z.lower + z.upper)};
        const Vec3d half{0.5 * (x.upper - x.lower), 0.5 * (y.upper - y.lower), 0.5 * (z.upper - z.lower)};
        // The rounded middle may be off by half a step.
        const auto roomy = [](double h, double m) { return h * (1 + 1e-15) + std::fabs(m) * kRounding; };
        if (!(half.x + half.y + half.z < 4)) return anywhere<N>(0, 1);
        const NoiseOverBox box = noise_over_box(
            *cells, middle, {roomy(half.x, middle.x), roomy(half.y, middle.y), roomy(half.z, middle.z)}, generator);
        if (!(box.error < 4)) return anywhere<N>(0, 1);
        const Vec3d g = box.centre.gradient;
        const Value along = sum_of(sum_of(line_of(x, g.x, -g.x * middle.x, 0, -kInfinite, kInfinite),
                                          line_of(y, g.y, -g.y * middle.y, 0, -kInfinite, kInfinite)),
                                   line_of(z, g.z, -g.z * middle.z, 0, -kInfinite, kInfinite));
        const Value sum = line_of(along, 1, box.centre.value, box.error, -kInfinite, kInfinite);
        return cut_off(sum, 0, 1);
    }
    static Value spline(const scene::FunctionSpline& s, const Value& at, std::uint8_t component) {
        const Value t = cut_off(at, s.first, s.last);
        const std::size_t first = DoubleMath::piece_of(s, t.lower), last = DoubleMath::piece_of(s, t.upper);
        std::optional<Value> out;
        for (std::size_t i = first; i <= last; ++i) {
            const auto& piece = s.pieces[i];
            const auto& c = piece.coefficients[component];
            // The part of the range in this piece; its linear form holds for all of the range, so it may be used.
            Value part = t;
            if (i > first) part.lower = std::max(part.lower, piece.start);
            if (i < last) part.upper = std::min(part.upper, s.pieces[i + 1].start);
            const Value u = sum_of(part, exactly<N>(-piece.start));
            Value v = exactly<N>(c[3]);
            for (int k = 2; k >= 0; --k) v = sum_of(product_of(v, u), exactly<N>(c[static_cast<std::size_t>(k)]));
            out = out ? either(*out, v) : v;
        }
        return *out;
    }
    [[gnu::noinline]] void pigment(std::uint32_t index, const Value& x, const Value& y, const Value& z,
                                   Value* out) const {
        // Where it can't change quickly, its colour in the middle says more than the range of all that it can be. (The
        // middle of the form, not of the interval: places that are asked for by themselves are the same to the bit.)
        const auto middle_of = [](const Value& a) { return std::clamp(a.centre, a.lower, a.upper); };
        const Vec3d at{middle_of(x), middle_of(y), middle_of(z)};
        const auto half_of = [](const Value& a, double c) { return std::max(a.upper - c, c - a.lower); };
        const Vec3d half{half_of(x, at.x), half_of(y, at.y), half_of(z, at.z)};
        const double reach = pigments->slope_limit(index) * length(half) * (1 + 1e-9) + 1e-5;
        std::array<double, 5> middle{};
        const bool known = reach < 1;
        if (known) middle = pigments->color(index, at.x, at.y, at.z);
        for (std::uint8_t i = 0; i < 5; ++i) {
            std::array<double, 2> range = pigments->range(index, i);
            if (known) range = {std::max(range[0], middle[i] - reach), std::min(range[1], middle[i] + reach)};
            out[i] = anywhere<N>(range[0], range[1]);
        }
    }

private:
    void note_undefined() const {
        if (undefined != nullptr) *undefined = true;
    }
    static bool may_be_true(const Value& a) {
        return a.lower < -scene::kFunctionEpsilon || a.upper > scene::kFunctionEpsilon;
    }
    static bool must_be_true(const Value& a) {
        return a.lower > scene::kFunctionEpsilon || a.upper < -scene::kFunctionEpsilon;
    }
    static Value truth_of(bool must, bool may) {
        return must ? exactly<N>(1) : !may ? exactly<N>(0) : anywhere<N>(0, 1);
    }
    static std::optional<double> whole(const Value& a) {
        const double p = std::trunc(a.lower);
        return p == std::trunc(a.upper) ? std::optional(p) : std::nullopt;
    }
    static Value constant_about(double v) {
        Value a = exactly<N>(v);
        a.lower = below(v), a.upper = above(v);
        a.error = std::fabs(v) * kRounding;
        return a;
    }
    /// What is below `lower` has no value: the rest of the range.
    static Value at_least(Value a, double lower) {
        a.lower = std::max(a.lower, lower);
        a.upper = std::max(a.upper, lower);
        return a;
    }
    /// A smooth function: f at both ends, the most of its second derivative's size in between.
    static Value curved(const Value& a, double f_lower, double f_upper, double second, double slack, double lower,
                        double upper) {
        const double width = a.upper - a.lower;
        const double bow = 0.125 * second * width * width * (1 + 1e-12) + slack +
                           4 * kRounding * (std::fabs(f_lower) + std::fabs(f_upper));
        return chord_of(a, f_lower, f_upper, bow, bow, lower, upper);
    }
    /// A rising function whose slope lies between two numbers, of which the first may be infinite.
    static Value sloped(const Value& a, double f_lower, double f_upper, double one, double other, double lower,
                        double upper) {
        const double spread = std::fabs(one - other);
        const double width = a.upper - a.lower;
        if (!(spread * width < upper - lower)) return anywhere<N>(lower, upper);
        return chord_of(a, f_lower, f_upper, spread * width, spread * width, lower, upper);
    }
    /// sin(a + shift turns).
    static Value wave(const Value& a, double shift) {
        constexpr double kTurn = 2 * std::numbers::pi;
        if (!(a.upper - a.lower < kTurn) || !(std::fabs(a.lower) + std::fabs(a.upper) < 1e9)) return anywhere<N>(-1, 1);
        const double p = shift == 0 ? std::sin(a.lower) : std::cos(a.lower);
        const double q = shift == 0 ? std::sin(a.upper) : std::cos(a.upper);
        // Crests at a quarter of a turn, troughs at three quarters; a margin for the rounding of a/turn.
        const double from = a.lower / kTurn + shift, to = a.upper / kTurn + shift;
        const double margin = 1e-15 * (1 + std::fabs(from) + std::fabs(to));
        const bool crest = std::floor(to + margin - 0.25) > std::floor(from - margin - 0.25);
        const bool trough = std::floor(to + margin - 0.75) > std::floor(from - margin - 0.75);
        const double low = trough ? -1 : std::max(-1.0, well_below(std::min(p, q)));
        const double high = crest ? 1 : std::min(1.0, well_above(std::max(p, q)));
        // The second derivative is the negative of the function; where it keeps its sign, the chord is on one side.
        const double width = a.upper - a.lower;
        const double square = 0.125 * width * width * (1 + 1e-12);
        const double rounding = 8 * kRounding;
        return chord_of(a, p, q, square * std::max(0.0, -low) + rounding, square * std::max(0.0, high) + rounding, low,
                        high);
    }
    /// By the mean of both and half of their difference's size.
    static Value extreme(const Value& a, const Value& b, bool greater) {
        const Value d = absolute(subtract(a, b));
        Value out;
        const double sign = greater ? 0.5 : -0.5;
        // a and b in one linear form each: what they share is kept.
        out.centre = 0.5 * (a.centre + b.centre) + sign * d.centre;
        double size = std::fabs(a.centre) + std::fabs(b.centre) + std::fabs(d.centre);
        for (std::size_t i = 0; i < N; ++i) {
            out.slope[i] = 0.5 * (a.slope[i] + b.slope[i]) + sign * d.slope[i];
            size += std::fabs(a.slope[i]) + std::fabs(b.slope[i]) + std::fabs(d.slope[i]);
        }
        out.error = (0.5 * (a.error + b.error + d.error) + size * kRounding) * (1 + 4 * kRounding);
        out.lower = greater ? std::max(a.lower, b.lower) : std::min(a.lower, b.lower);
        out.upper = greater ? std::max(a.upper, b.upper) : std::min(a.upper, b.upper);
        return settled(out);
    }
    /// a >= 0; b any.
    Value power_of_positive(const Value& a, const Value& b) const {
        const auto exponent = plain(b);
        if (!exponent) return exponential(multiply(b, logarithm(a)));
        const double e = *exponent;
        const double p = std::pow(a.lower, e), q = std::pow(a.upper, e);
        const double low = std::max(0.0, well_below(std::min(p, q))), high = well_above(std::max(p, q));
        // Convex but for exponents between 0 and 1. The chord is off most where the slopes agree.
        const double line = (q - p) / (a.upper - a.lower);
        const double touch = std::pow(line / e, 1 / (e - 1));
        const double bow = std::fabs(std::pow(touch, e) - (p + line * (touch - a.lower)));
        const double slack = 1e-12 * (high + std::fabs(line) * (std::fabs(a.lower) + std::fabs(a.upper)));
        if (!(bow < high - low) || !(touch > 0)) return anywhere<N>(low, high);
        const bool convex = e < 0 || e > 1;
        return chord_of(a, p, q, (convex ? bow : 0) + slack, (convex ? 0 : bow) + slack, low, high);
    }
};

}  // namespace sundog::fields
