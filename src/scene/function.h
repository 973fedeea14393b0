// SPDX-License-Identifier: Apache-2.0
// Functions of numbers as scenes define them, flattened: a list of instructions over registers, without calls.
// fields/ makes, evaluates and bounds them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/diagnostics.h"

namespace sundog::scene {

struct Pigment;

/// What an instruction computes of its operands a, b, c.
enum class FunctionOp : std::uint8_t {
    // Of a
    negate,
    absolute,
    square,
    square_root,
    exponential,
    logarithm,
    sine,
    cosine,
    tangent,
    arc_sine,  ///< Of a kept within -1..1; so arc_cosine.
    arc_cosine,
    arc_tangent,
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    inverse_hyperbolic_sine,
    inverse_hyperbolic_cosine,
    inverse_hyperbolic_tangent,
    floor,
    ceiling,
    truncate,     ///< Towards 0.
    logical_not,  ///< Numbers nearer to 0 than kFunctionEpsilon are false.
    spline,       ///< Component `component` of splines[index] at a.
    // Of a and b
    add,
    subtract,
    multiply,
    divide,
    minimum,
    maximum,
    power,
    arc_tangent2,        ///< The angle of (x: b, y: a).
    modulo,              ///< a less a multiple of b, with a's sign.
    truncated_quotient,  ///< a/b without its fraction.
    less,                ///< a < b: 1 or 0, as all that follow here.
    less_equal,
    equal,  ///< Nearer to each other than kFunctionEpsilon.
    logical_and,
    logical_or,
    bitwise_and,  ///< Of the whole parts.
    bitwise_or,
    bitwise_xor,
    // Of a, b and c
    select_negative,  ///< a < 0 ? b : c
    select_zero,      ///< a == 0 ? b : c
    noise,            ///< The noise of generator `index` (1 to 3) at the point (a, b, c).
    // Of several registers
    pigment,       ///< The red of pigments[index] at the point (a, b, c). Four pigment_parts follow.
    pigment_part,  ///< Green, blue, filter, transmit of the pigment before. Computed with it.
    // A loop: begin, then the term's instructions, then an end. The register of begin is the counter, from a to b by 1;
    // c is its end's register. The end has the sum or product of its a over all counts; b is its begin's register.
    loop,
    loop_sum,
    loop_product,
};

/// What counts as 0 in comparisons, as in POV-Ray's language.
inline constexpr double kFunctionEpsilon = 1e-10;

struct FunctionInstruction {
    FunctionOp op = FunctionOp::add;
    std::uint8_t component = 0;
    std::uint32_t index = 0;
    std::uint32_t a = 0, b = 0, c = 0;  ///< Registers.
};

/// Cubic pieces: between knot i and i+1, and beyond both ends on the first and last piece's end, a component is
/// ((c[3]*s + c[2])*s + c[1])*s + c[0] with s the distance from knot i.
struct FunctionSpline {
    struct Piece {
        double start = 0;
        std::array<std::array<double, 4>, 5> coefficients{};  ///< Of each component.
    };
    std::vector<Piece> pieces;   ///< Ascending; none is empty.
    double first = 0, last = 0;  ///< The parameter is kept within them.
};

/// A function of `input_count` numbers. Registers: constants, then inputs, then one for each instruction.
struct Function {
    SourceLocation where;
    std::uint32_t input_count = 0;
    std::vector<double> constants;
    std::vector<FunctionInstruction> code;  ///< Operands lie before what takes them.
    std::vector<std::uint32_t> outputs;     ///< Registers.
    std::vector<std::shared_ptr<const FunctionSpline>> splines;
    std::vector<std::shared_ptr<const Pigment>> pigments;

    [[nodiscard]] std::size_t first_input() const { return constants.size(); }
    [[nodiscard]] std::size_t first_result() const { return constants.size() + input_count; }
    [[nodiscard]] std::size_t register_count() const { return first_result() + code.size(); }
};

}  // namespace sundog::scene
