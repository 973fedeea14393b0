// SPDX-License-Identifier: Apache-2.0
// Numbers with their derivatives by N inputs (forward automatic differentiation: Griewank and Walther 2008), for
// fields/run.h. At kinks and steps it is the derivative of one side.
#pragma once

#include "fields/double_math.h"

namespace sundog::fields {

template <std::size_t N>
struct Derived {
    double value = 0;
    std::array<double, N> by{};
};

template <std::size_t N>
struct GradientMath {
    using Value = Derived<N>;
    const PigmentSource* pigments = nullptr;
    NoiseCells* cells = nullptr;

    static Value constant(double v) { return {v, {}}; }
    static std::optional<double> plain(const Value& a) { return a.value; }
    static Value unknown() { return constant(DoubleMath::unknown()); }

    static Value negate(const Value& a) { return times(a, -1, -a.value); }
    static Value absolute(const Value& a) { return a.value < 0 ? negate(a) : a; }
    static Value square(const Value& a) { return times(a, 2 * a.value, a.value * a.value); }
    static Value square_root(const Value& a) {
        const double root = std::sqrt(a.value);
        return times(a, root > 0 ? 0.5 / root : 0, root);
    }
    static Value exponential(const Value& a) {
        const double e = std::exp(a.value);
        return times(a, e, e);
    }
    static Value logarithm(const Value& a) { return times(a, 1 / a.value, std::log(a.value)); }
    static Value sine(const Value& a) { return times(a, std::cos(a.value), std::sin(a.value)); }
    static Value cosine(const Value& a) { return times(a, -std::sin(a.value), std::cos(a.value)); }
    static Value tangent(const Value& a) {
        const double t = std::tan(a.value);
        return times(a, 1 + t * t, t);
    }
    static Value arc_sine(const Value& a) { return times(a, arc_slope(a.value), DoubleMath::arc_sine(a.value)); }
    static Value arc_cosine(const Value& a) { return times(a, -arc_slope(a.value), DoubleMath::arc_cosine(a.value)); }
    static Value arc_tangent(const Value& a) { return times(a, 1 / (1 + a.value * a.value), std::atan(a.value)); }
    static Value hyperbolic_sine(const Value& a) { return times(a, std::cosh(a.value), std::sinh(a.value)); }
    static Value hyperbolic_cosine(const Value& a) { return times(a, std::sinh(a.value), std::cosh(a.value)); }
    static Value hyperbolic_tangent(const Value& a) {
        const double t = std::tanh(a.value);
        return times(a, 1 - t * t, t);
    }
    static Value inverse_hyperbolic_sine(const Value& a) {
        return times(a, 1 / std::sqrt(a.value * a.value + 1), std::asinh(a.value));
    }
    static Value inverse_hyperbolic_cosine(const Value& a) {
        return times(a, 1 / std::sqrt(a.value * a.value - 1), std::acosh(a.value));
    }
    static Value inverse_hyperbolic_tangent(const Value& a) {
        return times(a, 1 / (1 - a.value * a.value), std::atanh(a.value));
    }
    static Value floor(const Value& a) { return constant(std::floor(a.value)); }
    static Value truncate(const Value& a) { return constant(std::trunc(a.value)); }
    static Value logical_not(const Value& a) { return constant(DoubleMath::logical_not(a.value)); }
    static Value spline(const scene::FunctionSpline& s, const Value& at, std::uint8_t component) {
        const double value = DoubleMath::spline(s, at.value, component);
        if (!(at.value > s.first && at.value < s.last)) return constant(value);
        const auto& piece = s.pieces[DoubleMath::piece_of(s, at.value)];
        const auto& c = piece.coefficients[component];
        const double u = at.value - piece.start;
        return times(at, (3 * c[3] * u + 2 * c[2]) * u + c[1], value);
    }
    static Value add(const Value& a, const Value& b) {
        Value out{a.value + b.value, {}};
        for (std::size_t i = 0; i < N; ++i) out.by[i] = a.by[i] + b.by[i];
        return out;
    }
    static Value subtract(const Value& a, const Value& b) {
        Value out{a.value - b.value, {}};
        for (std::size_t i = 0; i < N; ++i) out.by[i] = a.by[i] - b.by[i];
        return out;
    }
    static Value multiply(const Value& a, const Value& b) { return both(a, b.value, b, a.value, a.value * b.value); }
    static Value divide(const Value& a, const Value& b) {
        const double q = a.value / b.value;
        return both(a, 1 / b.value, b, -q / b.value, q);
    }
    static Value minimum(const Value& a, const Value& b) { return b.value < a.value ? b : a; }
    static Value maximum(const Value& a, const Value& b) { return a.value < b.value ? b : a; }
    static Value power(const Value& a, const Value& b) {
        const double p = std::pow(a.value, b.value);
        const double by_base = b.value == 0 ? 0 : b.value * std::pow(a.value, b.value - 1);
        return both(a, std::isfinite(by_base) ? by_base : 0, b, a.value > 0 ? p * std::log(a.value) : 0, p);
    }
    static Value arc_tangent2(const Value& y, const Value& x) {
        const double r2 = x.value * x.value + y.value * y.value;
        const double angle = std::atan2(y.value, x.value);
        return r2 > 0 ? both(y, x.value / r2, x, -y.value / r2, angle) : constant(angle);
    }
    static Value modulo(const Value& a, const Value& b) {
        return both(a, 1, b, -std::trunc(a.value / b.value), std::fmod(a.value, b.value));
    }
    static Value less(const Value& a, const Value& b) { return constant(DoubleMath::less(a.value, b.value)); }
    static Value less_equal(const Value& a, const Value& b) {
        return constant(DoubleMath::less_equal(a.value, b.value));
    }
    static Value equal(const Value& a, const Value& b) { return constant(DoubleMath::equal(a.value, b.value)); }
    static Value logical_and(const Value& a, const Value& b) {
        return constant(DoubleMath::logical_and(a.value, b.value));
    }
    static Value logical_or(const Value& a, const Value& b) {
        return constant(DoubleMath::logical_or(a.value, b.value));
    }
    static Value bitwise(scene::FunctionOp op, const Value& a, const Value& b) {
        return constant(DoubleMath::bitwise(op, a.value, b.value));
    }
    static Value select_negative(const Value& a, const Value& b, const Value& c) { return a.value < 0 ? b : c; }
    static Value select_zero(const Value& a, const Value& b, const Value& c) { return a.value == 0 ? b : c; }
    Value noise(std::uint32_t generator, const Value& x, const Value& y, const Value& z) const {
        const NoiseSample n = noise_with_gradient(*cells, {x.value, y.value, z.value}, generator);
        if (!(n.value > 0 && n.value < 1)) return constant(n.value > 0 ? 1 : 0);
        return along(x, y, z, n.gradient, n.value);
    }
    /// By differences over a thousandth: pigments are computed in single precision.
    void pigment(std::uint32_t index, const Value& x, const Value& y, const Value& z, Value* out) const {
        constexpr double kStep = 1e-3;
        const auto at = [&](double dx, double dy, double dz) {
            return pigments->color(index, x.value + dx, y.value + dy, z.value + dz);
        };
        const std::array<double, 5> here = at(0, 0, 0);
        const std::array right{at(kStep, 0, 0), at(0, kStep, 0), at(0, 0, kStep)};
        const std::array left{at(-kStep, 0, 0), at(0, -kStep, 0), at(0, 0, -kStep)};
        for (std::size_t i = 0; i < 5; ++i) {
            Vec3d g;
            for (std::size_t axis = 0; axis < 3; ++axis) g[axis] = (right[axis][i] - left[axis][i]) / (2 * kStep);
            out[i] = along(x, y, z, g, here[i]);
        }
    }

private:
    static double arc_slope(double a) { return std::fabs(a) < 1 ? 1 / std::sqrt(1 - a * a) : 0; }
    static Value times(const Value& a, double slope, double value) {
        Value out{value, {}};
        for (std::size_t i = 0; i < N; ++i) out.by[i] = slope * a.by[i];
        return out;
    }
    static Value both(const Value& a, double by_a, const Value& b, double by_b, double value) {
        Value out{value, {}};
        for (std::size_t i = 0; i < N; ++i) out.by[i] = by_a * a.by[i] + by_b * b.by[i];
        return out;
    }
    static Value along(const Value& x, const Value& y, const Value& z, Vec3d g, double value) {
        Value out{value, {}};
        for (std::size_t i = 0; i < N; ++i) out.by[i] = g.x * x.by[i] + g.y * y.by[i] + g.z * z.by[i];
        return out;
    }
};

}  // namespace sundog::fields
