// SPDX-License-Identifier: Apache-2.0
#include "import/pov/functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec3d.h"
#include "import/pov/internal_functions.h"
#include "import/pov/math_functions.h"
#include "import/pov/transform_block.h"
#include "import/pov/values.h"

namespace sundog::pov {
namespace {

/// Numbers on the stack where there are few of them.
class Numbers {
public:
    explicit Numbers(std::size_t count) {
        if (count > few_.size()) many_.resize(count);
        data_ = count > few_.size() ? many_.data() : few_.data();
    }
    double& operator[](std::size_t i) { return data_[i]; }
    [[nodiscard]] std::span<const double> first(std::size_t count) const { return {data_, count}; }

private:
    std::array<double, 24> few_{};
    std::vector<double> many_;
    double* data_;
};

/// One call of a function's nodes. They are worked out in their order, which has arguments before what takes them; the
/// term of a sum lies right before the sum and is gone over again for each step.
class Call {
public:
    Call(const FunctionExpression& function, std::span<const double> arguments, PatternQueries* queries,
         std::uint64_t& budget)
        : f_(function),
          queries_(queries),
          budget_(budget),
          values_(function.nodes.size()),
          variables_(function.variable_count) {
        for (std::size_t i = 0; i < arguments.size(); ++i) variables_[i] = arguments[i];
    }

    double run() {
        run_nodes(0, f_.nodes.size());
        return values_[f_.nodes.size() - 1];
    }

private:
    void spend(std::uint64_t steps, const FunctionNode& node) {
        if (budget_ < steps) {
            budget_ = 0;
            throw FunctionError(node.where, "the limit of steps was hit in a function");
        }
        budget_ -= steps;
    }
    [[nodiscard]] std::uint32_t argument(const FunctionNode& node, std::uint32_t i) const {
        return f_.arguments[node.first_argument + i];
    }
    void run_nodes(std::size_t begin, std::size_t end) {
        if (begin >= end) return;
        spend(end - begin, f_.nodes[begin]);
        for (std::size_t i = begin; i < end; ++i) {
            const FunctionNode& node = f_.nodes[i];
            switch (node.op) {
                case FunctionOp::constant:
                    values_[i] = node.number;
                    break;
                case FunctionOp::variable:
                    values_[i] = variables_[node.index];
                    break;
                case FunctionOp::user:
                    values_[i] = call(node);
                    break;
                case FunctionOp::sum:
                case FunctionOp::product:
                    values_[i] = series(node);
                    break;
                default: {
                    Numbers arguments(node.argument_count);
                    for (std::uint32_t k = 0; k < node.argument_count; ++k) arguments[k] = values_[argument(node, k)];
                    values_[i] = value_of(node, arguments.first(node.argument_count));
                }
            }
        }
    }
    double call(const FunctionNode& node) {
        Numbers arguments(node.argument_count);
        for (std::uint32_t k = 0; k < node.argument_count; ++k) arguments[k] = values_[argument(node, k)];
        return component(evaluate(*f_.callees[node.index], arguments.first(node.argument_count), queries_, budget_),
                         node.component);
    }
    double series(const FunctionNode& node) {
        const double from = values_[argument(node, 0)], to = values_[argument(node, 1)];
        const std::uint32_t term = argument(node, 2);
        double result = node.op == FunctionOp::sum ? 0 : 1;
        for (double counter = from; counter <= to; counter += 1) {
            if (counter + 1 == counter) throw FunctionError(node.where, "a sum or product without end");
            variables_[node.index] = counter;
            // Its nodes begin behind the last node of the range's end.
            run_nodes(argument(node, 1) + 1, term + 1);
            result = node.op == FunctionOp::sum ? result + values_[term] : result * values_[term];
        }
        return result;
    }

    const FunctionExpression& f_;
    PatternQueries* queries_;
    std::uint64_t& budget_;
    Numbers values_, variables_;
};

std::array<double, 3> point_of(std::span<const double> arguments) {
    std::array<double, 3> point{};
    std::copy_n(arguments.begin(), std::min<std::size_t>(arguments.size(), 3), point.begin());
    return point;
}

}  // namespace

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

Value evaluate(const FunctionExpression& function, std::span<const double> arguments, PatternQueries* queries,
               std::uint64_t& budget) {
    const std::size_t wanted = parameter_count(function);
    if (wanted != 0 && arguments.size() != wanted)
        throw FunctionError(function.where, "this function takes " + std::to_string(wanted) + " arguments, not " +
                                                std::to_string(arguments.size()));
    Value value;
    switch (function.kind) {
        case FunctionKind::expression:
            return number_value(Call(function, arguments, queries, budget).run());
        case FunctionKind::internal: {
            const InternalFunction* internal = internal_function(function.internal_number);
            if (internal == nullptr)
                throw FunctionError(function.where,
                                    "internal(" + std::to_string(function.internal_number) + ") isn't known");
            if (arguments.size() != internal->argument_count)
                throw FunctionError(function.where, std::string(internal->name) + " takes " +
                                                        std::to_string(internal->argument_count) + " arguments, not " +
                                                        std::to_string(arguments.size()));
            return number_value(internal->value(arguments.data()));
        }
        case FunctionKind::spline:
            return evaluate(*function.spline, arguments[0], function.spline->kind);
        case FunctionKind::transform: {
            const Vec3d p = transform_point(transform_of(*function.block), {arguments[0], arguments[1], arguments[2]});
            return vector_value(p.x, p.y, p.z);
        }
        default:
            if (queries == nullptr)
                throw FunctionError(function.where, "a function of a pigment or pattern can't be called here");
            if (function.kind == FunctionKind::pattern)
                return number_value(queries->pattern_at(function.block, point_of(arguments)));
            value.v = queries->pigment_at(function.block, point_of(arguments));
            value.count = kColorComponents;
            value.is_color = true;
            return value;
    }
}

}  // namespace sundog::pov
