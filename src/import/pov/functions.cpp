// SPDX-License-Identifier: Apache-2.0
#include "import/pov/functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/function_evaluator.h"
#include "fields/internal_functions.h"
#include "import/pov/function_lowering.h"
#include "import/pov/math_functions.h"
#include "import/pov/values.h"

namespace sundog::pov {
double value_of(const FunctionNode& node, std::span<const double> a) {
    const auto truth = [](bool holds) { return holds ? 1.0 : 0.0; };
    switch (node.op) {
        case FunctionOp::negate:
            return -a[0];
        case FunctionOp::logical_not:
            return truth(!is_true(a[0]));
        case FunctionOp::add:
            return a[0] + a[1];
        case FunctionOp::subtract:
            return a[0] - a[1];
        case FunctionOp::multiply:
            return a[0] * a[1];
        case FunctionOp::divide:
            return a[0] / a[1];
        case FunctionOp::less:
            return truth(a[0] < a[1]);
        case FunctionOp::less_equal:
            return truth(a[0] <= a[1]);
        case FunctionOp::equal:
            return truth(std::fabs(a[0] - a[1]) <= kEpsilon);
        case FunctionOp::not_equal:
            return truth(std::fabs(a[0] - a[1]) > kEpsilon);
        case FunctionOp::greater_equal:
            return truth(a[0] >= a[1]);
        case FunctionOp::greater:
            return truth(a[0] > a[1]);
        case FunctionOp::logical_and:
            return truth(is_true(a[0]) && is_true(a[1]));
        case FunctionOp::logical_or:
            return truth(is_true(a[0]) || is_true(a[1]));
        case FunctionOp::builtin:
            return float_arity(node.keyword) > 0 ? float_function(node.keyword, a)
                                                 : aggregate_function(node.keyword, a);
        default:
            return node.number;
    }
}

std::size_t parameter_count(const FunctionExpression& function) {
    switch (function.kind) {
        case FunctionKind::expression:
            return function.parameters.size();
        case FunctionKind::internal:
            return 0;
        case FunctionKind::spline:
            return 1;
        default:
            return 3;
    }
}

/// A function with its registers.
struct FunctionCalls::Ready {
    Ready(std::shared_ptr<const FunctionExpression> expression, std::shared_ptr<const scene::Function> function,
          std::span<const scene::Texture> textures)
        : expression(std::move(expression)), evaluator(std::move(function), textures), evaluation(evaluator, cells) {}
    std::shared_ptr<const FunctionExpression> expression;  // keeps its address from being used again
    fields::FunctionEvaluator evaluator;
    fields::NoiseCells cells;
    fields::PointEvaluation evaluation;
};

FunctionCalls::FunctionCalls(FunctionPigments* pigments) : pigments_(pigments) {}
FunctionCalls::~FunctionCalls() = default;

FunctionCalls::Ready& FunctionCalls::ready(const std::shared_ptr<const FunctionExpression>& function) {
    constexpr std::size_t kMostKept = 500;
    const auto known = ready_.find(function.get());
    if (known != ready_.end()) return *known->second;
    std::vector<std::uint8_t> components{0};
    if (function->kind == FunctionKind::transform) components = {0, 1, 2};
    if (function->kind == FunctionKind::pigment) components = {0, 1, 2, 3, 4};
    auto made =
        std::make_unique<Ready>(function, lowered(*function, components, pigments_),
                                pigments_ == nullptr ? std::span<const scene::Texture>{} : pigments_->textures());
    // Scenes may define functions in loops.
    if (ready_.size() >= kMostKept) ready_.clear();
    return *ready_.emplace(function.get(), std::move(made)).first->second;
}

Value FunctionCalls::call(const std::shared_ptr<const FunctionExpression>& function, std::span<const double> arguments,
                          std::uint64_t& budget) {
    if (function->kind == FunctionKind::spline) {
        if (arguments.size() != 1) throw FunctionError(function->where, "a spline takes 1 argument");
        return evaluate(*function->spline, arguments[0], function->spline->kind);
    }
    Ready& f = ready(function);
    const std::size_t wanted = f.evaluator.function().input_count;
    if (arguments.size() != wanted) {
        const auto* internal =
            function->kind == FunctionKind::internal ? fields::internal_function(function->internal_number) : nullptr;
        throw FunctionError(function->where, (internal ? std::string(internal->name) : "this function") + " takes " +
                                                 std::to_string(wanted) + " arguments, not " +
                                                 std::to_string(arguments.size()));
    }
    if (!f.evaluation.run(arguments, budget))
        throw FunctionError(function->where, "the limit of steps was hit in a function");
    Value value;
    value.count = static_cast<std::uint8_t>(f.evaluator.function().outputs.size());
    value.is_color = function->kind == FunctionKind::pigment;
    for (std::size_t i = 0; i < value.count; ++i) value.v[i] = f.evaluation.output(i);
    return value;
}

}  // namespace sundog::pov
