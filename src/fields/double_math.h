// SPDX-License-Identifier: Apache-2.0
// Plain numbers, for fields/run.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/vec3d.h"
#include "fields/noise.h"
#include "scene/function.h"

namespace sundog::fields {

/// Asks for the colour (red, green, blue, filter, transmit) of a function's pigment number `index` at a point.
class PigmentSource {
public:
    PigmentSource() = default;
    PigmentSource(const PigmentSource&) = delete;
    PigmentSource& operator=(const PigmentSource&) = delete;
    virtual ~PigmentSource() = default;
    [[nodiscard]] virtual std::array<double, 5> color(std::uint32_t index, double x, double y, double z) const = 0;
    /// The same of many points.
    [[nodiscard]] virtual std::vector<std::array<double, 5>> colors(std::uint32_t index,
                                                                    std::span<const Vec3d> points) const {
        std::vector<std::array<double, 5>> all;
        for (const Vec3d& p : points) all.push_back(color(index, p.x, p.y, p.z));
        return all;
    }
    /// The least and the most that a component can be anywhere.
    [[nodiscard]] virtual std::array<double, 2> range(std::uint32_t index, std::uint8_t component) const = 0;
    /// The most that a component changes over a distance of 1; infinite where that isn't known.
    [[nodiscard]] virtual double slope_limit(std::uint32_t index) const = 0;
};

/// Remembers the last colours that were asked for: bounds and values of one place ask for the same.
class PigmentMemo final : public PigmentSource {
public:
    explicit PigmentMemo(const PigmentSource* source) : source_(source) {}
    [[nodiscard]] std::array<double, 5> color(std::uint32_t index, double x, double y, double z) const override {
        Entry& e = entries_[index % kEntries];
        if (e.index != index || e.x != x || e.y != y || e.z != z) e = {index, x, y, z, source_->color(index, x, y, z)};
        return e.color;
    }
    [[nodiscard]] std::array<double, 2> range(std::uint32_t index, std::uint8_t component) const override {
        return source_->range(index, component);
    }
    [[nodiscard]] double slope_limit(std::uint32_t index) const override { return source_->slope_limit(index); }

private:
    struct Entry {
        std::uint32_t index = 0xffffffffU;
        double x, y, z;
        std::array<double, 5> color;
    };
    static constexpr std::size_t kEntries = 4;
    const PigmentSource* source_;
    mutable std::array<Entry, kEntries> entries_;
};

struct DoubleMath {
    using Value = double;
    const PigmentSource* pigments = nullptr;
    NoiseCells* cells = nullptr;

    static double constant(double v) { return v; }
    static std::optional<double> plain(double v) { return v; }
    static double unknown() { return std::numeric_limits<double>::quiet_NaN(); }

    static double negate(double a) { return -a; }
    static double absolute(double a) { return std::fabs(a); }
    static double square(double a) { return a * a; }
    static double square_root(double a) { return std::sqrt(a); }
    static double exponential(double a) { return std::exp(a); }
    static double logarithm(double a) { return std::log(a); }
    static double sine(double a) { return std::sin(a); }
    static double cosine(double a) { return std::cos(a); }
    static double tangent(double a) { return std::tan(a); }
    static double arc_sine(double a) { return std::asin(std::clamp(a, -1.0, 1.0)); }
    static double arc_cosine(double a) { return std::acos(std::clamp(a, -1.0, 1.0)); }
    static double arc_tangent(double a) { return std::atan(a); }
    static double hyperbolic_sine(double a) { return std::sinh(a); }
    static double hyperbolic_cosine(double a) { return std::cosh(a); }
    static double hyperbolic_tangent(double a) { return std::tanh(a); }
    static double inverse_hyperbolic_sine(double a) { return std::asinh(a); }
    static double inverse_hyperbolic_cosine(double a) { return std::acosh(a); }
    static double inverse_hyperbolic_tangent(double a) { return std::atanh(a); }
    static double floor(double a) { return std::floor(a); }
    static double truncate(double a) { return std::trunc(a); }
    static double logical_not(double a) { return is_true(a) ? 0 : 1; }
    static double add(double a, double b) { return a + b; }
    static double subtract(double a, double b) { return a - b; }
    static double multiply(double a, double b) { return a * b; }
    static double divide(double a, double b) { return a / b; }
    static double minimum(double a, double b) { return b < a ? b : a; }
    static double maximum(double a, double b) { return a < b ? b : a; }
    static double power(double a, double b) { return std::pow(a, b); }
    static double arc_tangent2(double y, double x) { return std::atan2(y, x); }
    static double modulo(double a, double b) { return std::fmod(a, b); }
    static double less(double a, double b) { return a < b ? 1 : 0; }
    static double less_equal(double a, double b) { return a <= b ? 1 : 0; }
    static double equal(double a, double b) { return std::fabs(a - b) <= scene::kFunctionEpsilon ? 1 : 0; }
    static double logical_and(double a, double b) { return is_true(a) && is_true(b) ? 1 : 0; }
    static double logical_or(double a, double b) { return is_true(a) || is_true(b) ? 1 : 0; }
    static double bitwise(scene::FunctionOp op, double a, double b) {
        const std::int64_t x = whole(a), y = whole(b);
        return static_cast<double>(op == scene::FunctionOp::bitwise_and  ? x & y
                                   : op == scene::FunctionOp::bitwise_or ? x | y
                                                                         : x ^ y);
    }
    static double select_negative(double a, double b, double c) { return a < 0 ? b : c; }
    static double select_zero(double a, double b, double c) { return a == 0 ? b : c; }
    double noise(std::uint32_t generator, double x, double y, double z) const {
        return noise_at(*cells, {x, y, z},
                        generator);  // NOLINT(clang-analyzer-core.NonNullParamChecker): set where asked
    }
    static double spline(const scene::FunctionSpline& spline, double at, std::uint8_t component) {
        const double t = at > spline.last ? spline.last : at > spline.first ? at : spline.first;
        const auto& piece = spline.pieces[piece_of(spline, t)];
        const auto& c = piece.coefficients[component];
        const double s = t - piece.start;
        return ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
    }
    void pigment(std::uint32_t index, double x, double y, double z, double* out) const {
        const std::array<double, 5> color = pigments->color(index, x, y, z);
        std::copy(color.begin(), color.end(), out);
    }

    /// What an operation of one or two operands gives; for folding.
    static double unary(scene::FunctionOp op, double a);
    static double binary(scene::FunctionOp op, double a, double b);

    static bool is_true(double a) { return std::fabs(a) > scene::kFunctionEpsilon; }
    static std::int64_t whole(double a) {
        return std::isnan(a) ? 0 : static_cast<std::int64_t>(std::clamp(a, -9e15, 9e15));
    }
    /// The piece whose range has t.
    static std::size_t piece_of(const scene::FunctionSpline& spline, double t) {
        const auto above = std::upper_bound(spline.pieces.begin(), spline.pieces.end(), t,
                                            [](double v, const auto& piece) { return v < piece.start; });
        return above == spline.pieces.begin() ? 0 : static_cast<std::size_t>(above - spline.pieces.begin()) - 1;
    }
};

}  // namespace sundog::fields
