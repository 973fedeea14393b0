// SPDX-License-Identifier: Apache-2.0
#include "import/pov/function_lowering.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "fields/internal_functions.h"
#include "import/pov/math_functions.h"
#include "import/pov/transform_block.h"

namespace sundog::pov {
namespace {

using fields::Number;
using Op = scene::FunctionOp;

/// Sums of no more terms, and of no more operations in all, are written out.
constexpr double kMostUnrolledTerms = 128;
constexpr double kMostUnrolledNodes = 20'000;

std::optional<Op> unary_op(Keyword keyword) {
    switch (keyword) {
        case Keyword::abs:
            return Op::absolute;
        case Keyword::acos:
            return Op::arc_cosine;
        case Keyword::acosh:
            return Op::inverse_hyperbolic_cosine;
        case Keyword::asin:
            return Op::arc_sine;
        case Keyword::asinh:
            return Op::inverse_hyperbolic_sine;
        case Keyword::atan:
            return Op::arc_tangent;
        case Keyword::atanh:
            return Op::inverse_hyperbolic_tangent;
        case Keyword::ceil:
            return Op::ceiling;
        case Keyword::cos:
            return Op::cosine;
        case Keyword::cosh:
            return Op::hyperbolic_cosine;
        case Keyword::exp:
            return Op::exponential;
        case Keyword::floor:
            return Op::floor;
        case Keyword::int_:
            return Op::truncate;
        case Keyword::ln:
            return Op::logarithm;
        case Keyword::sin:
            return Op::sine;
        case Keyword::sinh:
            return Op::hyperbolic_sine;
        case Keyword::sqr:
            return Op::square;
        case Keyword::sqrt:
            return Op::square_root;
        case Keyword::tan:
            return Op::tangent;
        case Keyword::tanh:
            return Op::hyperbolic_tangent;
        default:
            return std::nullopt;
    }
}

std::optional<Op> binary_op(Keyword keyword) {
    switch (keyword) {
        case Keyword::atan2:
            return Op::arc_tangent2;
        case Keyword::div:
            return Op::truncated_quotient;
        case Keyword::mod:
            return Op::modulo;
        case Keyword::pow:
            return Op::power;
        case Keyword::min:
            return Op::minimum;
        case Keyword::max:
            return Op::maximum;
        case Keyword::bitwise_and:
            return Op::bitwise_and;
        case Keyword::bitwise_or:
            return Op::bitwise_or;
        case Keyword::bitwise_xor:
            return Op::bitwise_xor;
        default:
            return std::nullopt;
    }
}

Number builtin(fields::FunctionBuilder& b, const FunctionNode& node, std::span<const Number> a) {
    if (const auto op = unary_op(node.keyword)) return b.unary(*op, a[0]);
    if (const auto op = binary_op(node.keyword)) {
        Number result = a[0];
        for (const Number& next : a.subspan(1)) result = b.binary(*op, result, next);
        return result;
    }
    switch (node.keyword) {
        case Keyword::degrees:
            return a[0] * b.constant(180 / std::numbers::pi);
        case Keyword::radians:
            return a[0] * b.constant(std::numbers::pi / 180);
        case Keyword::log:
            return b.unary(Op::logarithm, a[0]) * b.constant(1 / std::numbers::ln10);
        case Keyword::select: {
            const Number otherwise = a.size() == 3 ? a[2] : b.select_zero(a[0], a[2], a[3]);
            return b.select_negative(a[0], a[1], otherwise);
        }
        default:
            throw FunctionError(node.where, "this isn't known in functions");
    }
}

Number operation(fields::FunctionBuilder& b, const FunctionNode& node, std::span<const Number> a) {
    switch (node.op) {
        case FunctionOp::negate:
            return b.unary(Op::negate, a[0]);
        case FunctionOp::logical_not:
            return b.unary(Op::logical_not, a[0]);
        case FunctionOp::add:
            return b.binary(Op::add, a[0], a[1]);
        case FunctionOp::subtract:
            return b.binary(Op::subtract, a[0], a[1]);
        case FunctionOp::multiply:
            return b.binary(Op::multiply, a[0], a[1]);
        case FunctionOp::divide:
            return b.binary(Op::divide, a[0], a[1]);
        case FunctionOp::less:
            return b.binary(Op::less, a[0], a[1]);
        case FunctionOp::less_equal:
            return b.binary(Op::less_equal, a[0], a[1]);
        case FunctionOp::equal:
            return b.binary(Op::equal, a[0], a[1]);
        case FunctionOp::not_equal:
            return b.unary(Op::logical_not, b.binary(Op::equal, a[0], a[1]));
        case FunctionOp::greater_equal:
            return b.binary(Op::less_equal, a[1], a[0]);
        case FunctionOp::greater:
            return b.binary(Op::less, a[1], a[0]);
        case FunctionOp::logical_and:
            return b.binary(Op::logical_and, a[0], a[1]);
        case FunctionOp::logical_or:
            return b.binary(Op::logical_or, a[0], a[1]);
        default:
            return builtin(b, node, a);
    }
}

/// A column's component of a map, as one row of it: the row's dot product with the point.
Number transformed(const Affine3d& m, std::span<const Number> p, std::size_t row) {
    return m.x[row] * p[0] + m.y[row] * p[1] + m.z[row] * p[2] + m.t[row];
}

}  // namespace

void FunctionLowering::lower(Frame& frame, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
        const auto series = frame.series.find(i);
        // One that ends behind is being lowered.
        if (series != frame.series.end() && series->second < end) {
            i = series->second;
            lower_series(frame, i);
        } else {
            lower_node(frame, i);
        }
    }
}

void FunctionLowering::lower_node(Frame& frame, std::size_t i) {
    const FunctionExpression& f = frame.function;
    const FunctionNode& node = f.nodes[i];
    switch (node.op) {
        case FunctionOp::constant:
            frame.values[i] = builder_.constant(node.number);
            return;
        case FunctionOp::variable:
            frame.values[i] = frame.variables[node.index];
            return;
        default:
            break;
    }
    std::vector<Number> arguments;
    for (std::uint32_t k = 0; k < node.argument_count; ++k)
        arguments.push_back(frame.values[f.arguments[node.first_argument + k]]);
    frame.values[i] = node.op == FunctionOp::user ? call(*f.callees[node.index], arguments, node.component, node.where)
                                                  : operation(builder_, node, arguments);
}

void FunctionLowering::lower_series(Frame& frame, std::size_t i) {
    const FunctionExpression& f = frame.function;
    const FunctionNode& node = f.nodes[i];
    const Number from = frame.values[f.arguments[node.first_argument]];
    const std::size_t to_node = f.arguments[node.first_argument + 1], term = f.arguments[node.first_argument + 2];
    const Number to = frame.values[to_node];
    const bool is_sum = node.op == FunctionOp::sum;
    const auto first = builder_.value_of(from), last = builder_.value_of(to);
    const auto lower_term = [&] { lower(frame, to_node + 1, term + 1); };
    if (first && last) {
        const double terms = std::floor(*last - *first) + 1;
        if (terms > 0 && *last + 1 == *last) throw FunctionError(node.where, "a sum or product without end");
        if (!(terms > 0)) {
            frame.values[i] = builder_.constant(is_sum ? 0 : 1);
            return;
        }
        if (terms <= kMostUnrolledTerms && terms * static_cast<double>(term - to_node) <= kMostUnrolledNodes) {
            Number result = builder_.constant(is_sum ? 0 : 1);
            const auto count = static_cast<int>(terms);
            for (int k = 0; k < count; ++k) {
                frame.variables[node.index] = builder_.constant(*first + k);
                lower_term();
                result = is_sum ? result + frame.values[term] : result * frame.values[term];
            }
            frame.values[i] = result;
            return;
        }
    }
    const Number counter = builder_.begin_loop(from, to);
    frame.variables[node.index] = counter;
    lower_term();
    frame.values[i] = builder_.end_loop(counter, frame.values[term], !is_sum);
}

Number FunctionLowering::pigment_component(const std::shared_ptr<const scene::Pigment>& pigment,
                                           std::span<const Number> point, std::uint8_t component) {
    const auto part = [&](std::uint8_t i) { return builder_.pigment(pigment, point[0], point[1], point[2], i); };
    // POV-Ray's grey (reference, section 3.3.1.7 "Colors": a colour's .gray).
    if (component == kGrayComponent) return 0.297 * part(0) + 0.589 * part(1) + 0.114 * part(2);
    return part(component);
}

Number FunctionLowering::call(const FunctionExpression& function, std::span<const Number> arguments,
                              std::uint8_t component, Place where) {
    const std::size_t wanted = parameter_count(function);
    if (wanted != 0 && arguments.size() != wanted)
        throw FunctionError(where, "this function takes " + std::to_string(wanted) + " arguments, not " +
                                       std::to_string(arguments.size()));
    switch (function.kind) {
        case FunctionKind::expression: {
            Frame frame{function, std::vector<Number>(function.nodes.size()), {}, {}};
            for (std::size_t i = 0; i < function.nodes.size(); ++i) {
                const FunctionNode& node = function.nodes[i];
                if (node.op == FunctionOp::sum || node.op == FunctionOp::product)
                    frame.series[function.arguments[node.first_argument + 1] + std::size_t{1}] = i;
            }
            frame.variables.assign(arguments.begin(), arguments.end());
            frame.variables.resize(function.variable_count);
            lower(frame, 0, function.nodes.size());
            return frame.values.back();
        }
        case FunctionKind::internal: {
            const auto* internal = fields::internal_function(function.internal_number);
            if (internal == nullptr)
                throw FunctionError(function.where,
                                    "internal(" + std::to_string(function.internal_number) + ") isn't known");
            if (arguments.size() != internal->argument_count)
                throw FunctionError(where, std::string(internal->name) + " takes " +
                                               std::to_string(internal->argument_count) + " arguments, not " +
                                               std::to_string(arguments.size()));
            return fields::build_internal_function(function.internal_number, arguments);
        }
        case FunctionKind::spline: {
            auto& pieces = splines_[function.spline.get()];
            if (!pieces) pieces = pieces_of(*function.spline, function.spline->kind);
            return builder_.spline(pieces, arguments[0], std::min<std::uint8_t>(component, 4));
        }
        case FunctionKind::transform:
            return transformed(transform_of(*function.block), arguments, std::min<std::size_t>(component, 2));
        default:
            if (pigments_ == nullptr)
                throw FunctionError(where, "a function of a pigment or pattern can't be called here");
            if (function.kind == FunctionKind::pattern)
                return pigment_component(pigments_->pigment_of_pattern(function.block), arguments, 0);
            return pigment_component(pigments_->pigment_of(function.block), arguments, component);
    }
}

const FunctionExpression* unknown_internal_function(const FunctionExpression& function) {
    // Each once: functions may share what they call, many levels deep.
    std::vector<const FunctionExpression*> called{&function};
    std::set<const FunctionExpression*> seen{&function};
    while (!called.empty()) {
        const FunctionExpression& f = *called.back();
        called.pop_back();
        if (f.kind == FunctionKind::internal && fields::internal_function(f.internal_number) == nullptr) return &f;
        for (const auto& callee : f.callees)
            if (seen.insert(callee.get()).second) called.push_back(callee.get());
    }
    return nullptr;
}

std::shared_ptr<const scene::Function> lowered(const FunctionExpression& function,
                                               std::span<const std::uint8_t> components, FunctionPigments* pigments) {
    std::size_t count = parameter_count(function);
    if (function.kind == FunctionKind::internal) {
        const auto* internal = fields::internal_function(function.internal_number);
        if (internal != nullptr) count = internal->argument_count;
    }
    fields::FunctionBuilder builder(static_cast<std::uint32_t>(count));
    FunctionLowering lowering(builder, pigments);
    std::vector<Number> inputs, outputs;
    for (std::uint32_t i = 0; i < count; ++i) inputs.push_back(builder.input(i));
    try {
        for (const std::uint8_t component : components)
            outputs.push_back(lowering.call(function, inputs, component, function.where));
    } catch (const fields::FunctionTooLarge& error) {
        throw FunctionError(function.where, error.what());
    }
    return std::make_shared<const scene::Function>(builder.finish(outputs));
}

std::shared_ptr<const scene::Function> lowered_together(
    std::span<const std::shared_ptr<const FunctionExpression>> functions, std::uint32_t input_count,
    FunctionPigments* pigments) {
    fields::FunctionBuilder builder(input_count);
    FunctionLowering lowering(builder, pigments);
    std::vector<Number> inputs, outputs;
    for (std::uint32_t i = 0; i < input_count; ++i) inputs.push_back(builder.input(i));
    for (const auto& function : functions) {
        try {
            const std::size_t wanted = parameter_count(*function);
            const std::size_t count = wanted == 0 ? input_count : std::min<std::size_t>(wanted, input_count);
            outputs.push_back(
                lowering.call(*function, std::span(inputs).first(count), kGrayComponent, function->where));
        } catch (const fields::FunctionTooLarge& error) {
            throw FunctionError(function->where, error.what());
        }
    }
    return std::make_shared<const scene::Function>(builder.finish(outputs));
}

}  // namespace sundog::pov
