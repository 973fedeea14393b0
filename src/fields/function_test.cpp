// SPDX-License-Identifier: Apache-2.0
// Flat functions: what builders make of them, their values, derivatives and bounds.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "fields/function_evaluator.h"
#include "fields/internal_functions.h"

namespace sundog::fields {
namespace {

using Op = scene::FunctionOp;

class RandomNumbers {
public:
    double number(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(random_); }

private:
    std::mt19937 random_{3};
};

FunctionEvaluator evaluator_of(const FunctionBuilder& builder, std::initializer_list<Number> outputs) {
    const std::vector<Number> list(outputs);
    return FunctionEvaluator(std::make_shared<const scene::Function>(builder.finish(list)));
}

struct Case {
    const char* name;
    double lower, upper;  ///< Of both operands.
    std::function<Number(FunctionBuilder&, Number, Number)> build;
    std::function<long double(long double, long double)> value;
    bool smooth = true;
};

Case unary(const char* name, Op op, double lower, double upper, long double (*value)(long double), bool smooth = true) {
    return {name,
            lower,
            upper,
            [op](FunctionBuilder& b, Number x, Number) { return b.unary(op, x); },
            [value](long double x, long double) { return value(x); },
            smooth};
}
Case binary(const char* name, Op op, double lower, double upper, std::function<long double(long double, long double)> v,
            bool smooth = true) {
    return {name,         lower, upper, [op](FunctionBuilder& b, Number x, Number y) { return b.binary(op, x, y); },
            std::move(v), smooth};
}

std::vector<Case> cases() {
    using L = long double;
    return {
        unary("negate", Op::negate, -9, 9, [](L x) { return -x; }),
        unary(
            "absolute", Op::absolute, -9, 9, [](L x) { return std::fabs(x); }, false),
        unary("square", Op::square, -9, 9, [](L x) { return x * x; }),
        unary(
            "square_root", Op::square_root, 0, 9, [](L x) { return std::sqrt(x); }, false),
        unary("exponential", Op::exponential, -5, 5, [](L x) { return std::exp(x); }),
        unary("logarithm", Op::logarithm, 0.01, 9, [](L x) { return std::log(x); }),
        unary("sine", Op::sine, -20, 20, [](L x) { return std::sin(x); }),
        unary("cosine", Op::cosine, -20, 20, [](L x) { return std::cos(x); }),
        unary("tangent", Op::tangent, -1.5, 1.5, [](L x) { return std::tan(x); }),
        unary(
            "arc_sine", Op::arc_sine, -1, 1, [](L x) { return std::asin(x); }, false),
        unary(
            "arc_cosine", Op::arc_cosine, -1, 1, [](L x) { return std::acos(x); }, false),
        unary("arc_tangent", Op::arc_tangent, -9, 9, [](L x) { return std::atan(x); }),
        unary("hyperbolic_sine", Op::hyperbolic_sine, -4, 4, [](L x) { return std::sinh(x); }),
        unary("hyperbolic_cosine", Op::hyperbolic_cosine, -4, 4, [](L x) { return std::cosh(x); }),
        unary("hyperbolic_tangent", Op::hyperbolic_tangent, -4, 4, [](L x) { return std::tanh(x); }),
        unary("inverse_hyperbolic_sine", Op::inverse_hyperbolic_sine, -9, 9, [](L x) { return std::asinh(x); }),
        unary(
            "inverse_hyperbolic_cosine", Op::inverse_hyperbolic_cosine, 1, 9, [](L x) { return std::acosh(x); }, false),
        unary("inverse_hyperbolic_tangent", Op::inverse_hyperbolic_tangent, -0.999, 0.999,
              [](L x) { return std::atanh(x); }),
        unary(
            "floor", Op::floor, -5, 5, [](L x) { return std::floor(x); }, false),
        unary(
            "ceiling", Op::ceiling, -5, 5, [](L x) { return std::ceil(x); }, false),
        unary(
            "truncate", Op::truncate, -5, 5, [](L x) { return std::trunc(x); }, false),
        binary("add", Op::add, -9, 9, [](L x, L y) { return x + y; }),
        binary("subtract", Op::subtract, -9, 9, [](L x, L y) { return x - y; }),
        binary("multiply", Op::multiply, -9, 9, [](L x, L y) { return x * y; }),
        binary("divide", Op::divide, 0.1, 9, [](L x, L y) { return x / y; }),
        binary(
            "divide by either sign", Op::divide, -9, 9, [](L x, L y) { return x / y; }, false),
        binary(
            "minimum", Op::minimum, -9, 9, [](L x, L y) { return std::min(x, y); }, false),
        binary(
            "maximum", Op::maximum, -9, 9, [](L x, L y) { return std::max(x, y); }, false),
        binary("power", Op::power, 0.1, 4, [](L x, L y) { return std::pow(x, y); }),
        binary(
            "arc_tangent2", Op::arc_tangent2, -9, 9, [](L y, L x) { return std::atan2(y, x); }, false),
        binary(
            "modulo", Op::modulo, 0.5, 9, [](L x, L y) { return std::fmod(x, y); }, false),
        binary(
            "truncated_quotient", Op::truncated_quotient, 0.5, 9, [](L x, L y) { return std::trunc(x / y); }, false),
        binary(
            "less", Op::less, -2, 2, [](L x, L y) { return x < y ? 1.0L : 0.0L; }, false),
        binary(
            "less_equal", Op::less_equal, -2, 2, [](L x, L y) { return x <= y ? 1.0L : 0.0L; }, false),
        binary(
            "bitwise_and", Op::bitwise_and, 0, 99,
            [](L x, L y) { return static_cast<L>(static_cast<long>(x) & static_cast<long>(y)); }, false),
        binary(
            "bitwise_or", Op::bitwise_or, 0, 99,
            [](L x, L y) { return static_cast<L>(static_cast<long>(x) | static_cast<long>(y)); }, false),
        binary(
            "bitwise_xor", Op::bitwise_xor, 0, 99,
            [](L x, L y) { return static_cast<L>(static_cast<long>(x) ^ static_cast<long>(y)); }, false),
        {"modulo 0.7", -5, 5,
         [](FunctionBuilder& b, Number x, Number) { return b.binary(Op::modulo, x, b.constant(0.7)); },
         [](L x, L) { return std::fmod(x, static_cast<L>(0.7)); }, false},
        {"power 2.5", 0, 5, [](FunctionBuilder&, Number x, Number) { return pow(x, x.builder->constant(2.5)); },
         [](L x, L) { return std::pow(x, 2.5L); }},
        {"power 0.3", 0.01, 5, [](FunctionBuilder&, Number x, Number) { return pow(x, x.builder->constant(0.3)); },
         [](L x, L) { return std::pow(x, static_cast<L>(0.3)); }},
        {"power 7", -3, 3, [](FunctionBuilder&, Number x, Number) { return pow(x, x.builder->constant(7)); },
         [](L x, L) { return x * x * x * x * x * x * x; }},
        {"power -3", 0.2, 3, [](FunctionBuilder&, Number x, Number) { return pow(x, x.builder->constant(-3)); },
         [](L x, L) { return 1 / (x * x * x); }},
        {"select_negative", -3, 3,
         [](FunctionBuilder& b, Number x, Number y) { return b.select_negative(x, y, 2 * x); },
         [](L x, L y) { return x < 0 ? y : 2 * x; }, false},
        {"select_zero", -3, 3, [](FunctionBuilder& b, Number x, Number y) { return b.select_zero(floor(x), y, x); },
         [](L x, L y) { return std::floor(x) == 0 ? y : x; }, false},
        {"a sum of 1000 terms", -1, 1,
         [](FunctionBuilder& b, Number x, Number) {
             const Number i = b.begin_loop(b.constant(1), b.constant(1000));
             return b.end_loop(i, sin(i * x) / i, false);
         },
         [](L x, L) {
             L sum = 0;
             for (int i = 1; i <= 1000; ++i) sum += std::sin(static_cast<L>(i) * x) / i;
             return sum;
         }},
    };
}

// A wrong formula, or operands the wrong way round.
TEST(FieldsFunction, OperationsHaveTheirValues) {
    RandomNumbers random;
    for (const Case& c : cases()) {
        FunctionBuilder b(2);
        const FunctionEvaluator f = evaluator_of(b, {c.build(b, b.input(0), b.input(1))});
        NoiseCells cells;
        PointEvaluation evaluation(f, cells);
        for (int i = 0; i < 200; ++i) {
            const std::array<double, 2> at{random.number(c.lower, c.upper), random.number(c.lower, c.upper)};
            const auto wanted = static_cast<double>(c.value(at[0], at[1]));
            EXPECT_NEAR(evaluation.value(at), wanted, 1e-12 * (1 + std::abs(wanted)))
                << c.name << " of " << at[0] << ", " << at[1];
        }
    }
}

// A wrong derivative: normals of isosurfaces would tilt.
TEST(FieldsFunction, DerivativesAreLimitsOfDifferences) {
    RandomNumbers random;
    for (const Case& c : cases()) {
        if (!c.smooth) continue;
        FunctionBuilder b(2);
        const FunctionEvaluator f = evaluator_of(b, {c.build(b, b.input(0), b.input(1))});
        NoiseCells cells;
        GradientEvaluation<2> evaluation(f, cells);
        PointEvaluation points(f, cells);
        const double margin = 0.01 * (c.upper - c.lower), step = 1e-6;
        for (int i = 0; i < 50; ++i) {
            std::array<double, 2> at{random.number(c.lower + margin, c.upper - margin),
                                     random.number(c.lower + margin, c.upper - margin)};
            evaluation.run(at);
            const Derived<2> found = evaluation.output(0);
            for (std::size_t k = 0; k < 2; ++k) {
                auto above = at, below = at;
                above[k] += step, below[k] -= step;
                const double slope = (points.value(above) - points.value(below)) / (2 * step);
                EXPECT_NEAR(found.by[k], slope, 1e-4 * (1 + std::abs(slope)))
                    << c.name << " of " << at[0] << ", " << at[1];
            }
        }
    }
}

/// Checks the bounds of a function of two numbers over random boxes at random points within.
void expect_bounds_hold(const char* name, const FunctionEvaluator& f, double lower, double upper) {
    RandomNumbers random;
    NoiseCells cells;
    RangeEvaluation<2> ranges(f, cells);
    PointEvaluation points(f, cells);
    for (int i = 0; i < 400; ++i) {
        std::array<double, 2> low{}, high{};
        for (std::size_t k = 0; k < 2; ++k) {
            const double width = (upper - lower) * std::exp(random.number(-12, 0));
            low[k] = random.number(lower, upper - width);
            high[k] = low[k] + width;
            ranges.set_input(k, input_range<2>(k, low[k], high[k]));
        }
        ranges.run();
        const Affine<2> bounds = ranges.output(0);
        for (int j = 0; j < 12; ++j) {
            std::array<double, 2> at{}, place{};
            for (std::size_t k = 0; k < 2; ++k) {
                // Ends, too.
                at[k] = j < 4 ? ((j >> k & 1) != 0 ? high[k] : low[k]) : random.number(low[k], high[k]);
                const double middle = 0.5 * (low[k] + high[k]);
                place[k] = (at[k] - middle) / std::max(high[k] - middle, middle - low[k]);
            }
            const double value = points.value(at);
            if (std::isnan(value)) {
                EXPECT_TRUE(ranges.may_be_undefined()) << name;
                continue;
            }
            ASSERT_GE(value, bounds.lower) << name << " at " << at[0] << ", " << at[1];
            ASSERT_LE(value, bounds.upper) << name << " at " << at[0] << ", " << at[1];
            if (bounds.error < kInfinite) {
                const double linear = bounds.centre + bounds.slope[0] * place[0] + bounds.slope[1] * place[1];
                // The test's own rounding of the places.
                const double slack = 1e-14 * (std::abs(bounds.slope[0]) + std::abs(bounds.slope[1]) + std::abs(linear));
                ASSERT_LE(std::abs(value - linear), bounds.error + slack) << name << " at " << at[0] << ", " << at[1];
            }
        }
    }
}

// Sums and products of numbers that can't be negative, said to be perhaps negative: no part of a ray through a rounded
// box would ever be settled.
TEST(FieldsFunction, SumsAndProductsKeepTheirSign) {
    FunctionBuilder b(2);
    const auto beyond = [&](Number x) { return max(x - 1, b.constant(0)); };
    const Number u = beyond(b.input(0)), v = beyond(b.input(1));
    const FunctionEvaluator f = evaluator_of(b, {sqrt(u * u + v * v), sqrt(u * v), sqrt(-u * (-u - v))});
    NoiseCells cells;
    RangeEvaluation<2> ranges(f, cells);
    for (const double lower : {-3.0, 0.5, 1.0, 2.0}) {
        for (std::size_t i = 0; i < 2; ++i) ranges.set_input(i, input_range<2>(i, lower, lower + 0.75));
        ranges.run();
        EXPECT_FALSE(ranges.may_be_undefined()) << "from " << lower;
    }
}

// A bound that some value exceeds: isosurfaces would get holes.
TEST(FieldsFunction, BoundsHoldForEveryOperation) {
    for (const Case& c : cases()) {
        FunctionBuilder b(2);
        expect_bounds_hold(c.name, evaluator_of(b, {c.build(b, b.input(0), b.input(1))}), c.lower, c.upper);
    }
    // Beyond their domains, too.
    for (const Op op : {Op::square_root, Op::logarithm, Op::arc_sine, Op::inverse_hyperbolic_cosine,
                        Op::inverse_hyperbolic_tangent, Op::tangent}) {
        FunctionBuilder b(2);
        expect_bounds_hold("beyond its domain", evaluator_of(b, {b.unary(op, b.input(0) + 0.5 * b.input(1))}), -3, 3);
    }
    for (const Op op : {Op::power, Op::modulo, Op::divide, Op::logical_and, Op::logical_or, Op::equal}) {
        FunctionBuilder b(2);
        expect_bounds_hold("of either sign", evaluator_of(b, {b.binary(op, b.input(0), b.input(1))}), -3, 3);
    }
    FunctionBuilder b(2);
    const Number x = b.input(0), y = b.input(1);
    expect_bounds_hold("noise", evaluator_of(b, {b.noise(3 * x, y, x - y, 2)}), -4, 4);
}

// The same for POV-Ray's functions, with parameters as their descriptions propose.
TEST(FieldsFunction, BoundsHoldForInternalFunctions) {
    int known = 0;
    for (std::uint32_t number = 0; number < 80; ++number) {
        const InternalFunction* internal = internal_function(number);
        if (internal == nullptr) continue;
        ++known;
        FunctionBuilder b(2);
        std::vector<Number> arguments{b.input(0), b.input(1), 0.3 + 0.5 * b.input(0) - 0.2 * b.input(1)};
        while (arguments.size() < internal->argument_count)
            arguments.push_back(b.constant(0.3 + 0.2 * static_cast<double>(arguments.size())));
        expect_bounds_hold(internal->name.data(), evaluator_of(b, {build_internal_function(number, arguments)}), -1.5,
                           1.5);
    }
    EXPECT_GE(known, 47);
}

// Constants that aren't folded, parts computed twice, dead parts kept.
TEST(FieldsFunction, WhatNeedNotBeComputedIsNot) {
    FunctionBuilder b(3);
    const Number x = b.input(0), y = b.input(1);
    const Number unused = exp(y);
    static_cast<void>(unused);
    const Number folded = sqrt(b.constant(4)) * x;
    const scene::Function f = b.finish(std::array{folded + sin(x * y) * sin(y * x) + 0 * x});
    EXPECT_EQ(f.constants.size(), 1U);  // 2
    EXPECT_EQ(f.code.size(), 5U);       // 2x, xy, sin, square, sum
}

// A function that grows without end through calls.
TEST(FieldsFunction, TooLargeFunctionsAreRefused) {
    FunctionBuilder b(1);
    const auto grow = [&] {
        Number sum = b.input(0);
        for (int i = 0; i < 300'000; ++i) sum = sin(sum);
    };
    EXPECT_THROW(grow(), FunctionTooLarge);
}

}  // namespace
}  // namespace sundog::fields
