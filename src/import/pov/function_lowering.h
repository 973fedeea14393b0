// SPDX-License-Identifier: Apache-2.0
// Functions as parsed, written out as flat ones: calls in place, short sums unrolled.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "fields/function_builder.h"
#include "import/pov/functions.h"

namespace sundog::pov {

/// Writes functions into one FunctionBuilder. Errors: FunctionError for unknown internal functions, wrong numbers of
/// arguments and functions that become too large; what `pigments` throws.
class FunctionLowering {
public:
    /// `pigments` may be null where no function of a pigment or pattern is called.
    FunctionLowering(fields::FunctionBuilder& builder, FunctionPigments* pigments)
        : builder_(builder), pigments_(pigments) {}

    /// A call. `component` is that of a vector or colour, kGrayComponent for a colour's grey; 0 for floats.
    fields::Number call(const FunctionExpression& function, std::span<const fields::Number> arguments,
                        std::uint8_t component, Place where);

private:
    /// The call of an expression under way.
    struct Frame {
        const FunctionExpression& function;
        std::vector<fields::Number> values;         ///< Of nodes.
        std::vector<fields::Number> variables;      ///< Parameters and counters.
        std::map<std::size_t, std::size_t> series;  ///< Sums and products by the first node of their term.
    };
    void lower(Frame& frame, std::size_t begin, std::size_t end);
    void lower_node(Frame& frame, std::size_t i);
    /// A sum or product, node number i; its term's nodes lie before it.
    void lower_series(Frame& frame, std::size_t i);
    fields::Number pigment_component(const std::shared_ptr<const scene::Pigment>& pigment,
                                     std::span<const fields::Number> point, std::uint8_t component);

    fields::FunctionBuilder& builder_;
    FunctionPigments* pigments_;
    std::map<const Spline*, std::shared_ptr<const scene::FunctionSpline>> splines_;
};

/// The first internal function without a known value among those that a function calls, itself or by way of others;
/// null where there is none.
const FunctionExpression* unknown_internal_function(const FunctionExpression& function);

/// A function of as many inputs as it has parameters (an internal function: as it needs), with one output for each of
/// `components`.
std::shared_ptr<const scene::Function> lowered(const FunctionExpression& function,
                                               std::span<const std::uint8_t> components, FunctionPigments* pigments);

/// Several functions of the same inputs as one, with an output each. Those with fewer parameters take the first inputs.
std::shared_ptr<const scene::Function> lowered_together(
    std::span<const std::shared_ptr<const FunctionExpression>> functions, std::uint32_t input_count,
    FunctionPigments* pigments);

}  // namespace sundog::pov
