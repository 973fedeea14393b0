// SPDX-License-Identifier: Apache-2.0
// Functions of a point in single precision, for shaders: the CPU asks the host (fields/function_evaluator.h). Words are
// written by fields/function_words.cpp.
#ifndef SUNDOG_KERNEL_PATTERNS_SHADER_FUNCTION_H
#define SUNDOG_KERNEL_PATTERNS_SHADER_FUNCTION_H

#include "kernel/math.h"
#include "kernel/patterns/code.h"
#include "kernel/patterns/noise.h"

KERNEL_BEGIN

/// Values that a function may have at hand at a time, its point's x, y and z (registers 0 to 2) among them.
const uint FUNCTION_REGISTERS = 32u;
/// Operands from here on are constants.
const uint FUNCTION_CONSTANT = 128u;

const uint FUNCTION_NEGATE = 0u;
const uint FUNCTION_ABSOLUTE = 1u;
const uint FUNCTION_SQUARE_ROOT = 2u;
const uint FUNCTION_FLOOR = 3u;
const uint FUNCTION_CEILING = 4u;
const uint FUNCTION_TRUNCATE = 5u;
const uint FUNCTION_NOT = 6u;
const uint FUNCTION_ADD = 7u;
const uint FUNCTION_SUBTRACT = 8u;
const uint FUNCTION_MULTIPLY = 9u;
const uint FUNCTION_DIVIDE = 10u;
const uint FUNCTION_MINIMUM = 11u;
const uint FUNCTION_MAXIMUM = 12u;
const uint FUNCTION_MODULO = 13u;
const uint FUNCTION_QUOTIENT = 14u;  ///< Towards 0.
const uint FUNCTION_LESS = 15u;
const uint FUNCTION_LESS_EQUAL = 16u;
const uint FUNCTION_EQUAL = 17u;
const uint FUNCTION_AND = 18u;
const uint FUNCTION_OR = 19u;
const uint FUNCTION_SELECT_NEGATIVE = 20u;
const uint FUNCTION_SELECT_ZERO = 21u;
// With FIELD_FUNCTION_NOISE.
const uint FUNCTION_NOISE = 22u;  ///< Of generator 1; 23 and 24: 2 and 3.
// With FIELD_FUNCTION_ANGLES, from here on.
const uint FUNCTION_EXPONENTIAL = 25u;
const uint FUNCTION_LOGARITHM = 26u;
const uint FUNCTION_SINE = 27u;
const uint FUNCTION_COSINE = 28u;
const uint FUNCTION_TANGENT = 29u;
const uint FUNCTION_ARC_SINE = 30u;
const uint FUNCTION_ARC_COSINE = 31u;
const uint FUNCTION_ARC_TANGENT = 32u;
const uint FUNCTION_HYPERBOLIC_SINE = 33u;
const uint FUNCTION_HYPERBOLIC_COSINE = 34u;
const uint FUNCTION_HYPERBOLIC_TANGENT = 35u;
const uint FUNCTION_POWER = 36u;
const uint FUNCTION_ARC_TANGENT2 = 37u;

FN real truth(bool b) { return b ? 1.0f : 0.0f; }
FN bool is_true(real a) { return abs(a) > 1.0e-10f; }
FN real towards_zero(real a) { return a < 0.0f ? -floor(-a) : floor(a); }

/// base to any power; where there is no such number (a negative base, a power that isn't whole), none.
FN real any_power(real base, real exponent) {
    if (exponent == 0.0f) return 1.0f;
    if (base == 0.0f) return exponent > 0.0f ? 0.0f : 1.0f / base;
    real size = power(abs(base), exponent);
    if (base > 0.0f) return size;
    real half_way = exponent * 0.5f;
    if (floor(exponent) != exponent) return sqrt(base);
    return floor(half_way) == half_way ? size : -size;
}

FN real natural_exponential(real a) { return exp2_clamped(a * 1.44269504f); }

/// Operations of circles and hyperbolas.
FN real function_angle(uint op, real a, real b) {
    if (op == FUNCTION_SINE) return sine(a);
    if (op == FUNCTION_COSINE) return cosine(a);
    if (op == FUNCTION_TANGENT) return sine(a) / cosine(a);
    if (op == FUNCTION_POWER) return any_power(a, b);
    if (op == FUNCTION_ARC_TANGENT2) return angle_of(a, b);
    if (op == FUNCTION_ARC_TANGENT) return angle_of(a, 1.0f);
    if (op == FUNCTION_LOGARITHM) return a > 0.0f ? log2_positive(a) * 0.693147181f : sqrt(-1.0f - a * a);
    if (op == FUNCTION_ARC_SINE || op == FUNCTION_ARC_COSINE) {
        real s = clamp(a, real(-1.0f), real(1.0f));
        real c = sqrt(max((1.0f - s) * (1.0f + s), 0.0f));
        return op == FUNCTION_ARC_SINE ? angle_of(s, c) : angle_of(c, s);
    }
    real up = natural_exponential(a);
    if (op == FUNCTION_EXPONENTIAL) return up;
    real down = natural_exponential(-a);
    if (op == FUNCTION_HYPERBOLIC_COSINE) return (up + down) * 0.5f;
    // Near 0 the difference would be of few digits: a series.
    real small = a * (1.0f + a * a * (0.166666667f + a * a * 8.33333333e-3f));
    real difference = abs(a) < 0.5f ? small : (up - down) * 0.5f;
    if (op == FUNCTION_HYPERBOLIC_SINE) return difference;
    return abs(a) > 20.0f ? (a < 0.0f ? -1.0f : 1.0f) : difference / ((up + down) * 0.5f);
}

/// Operations of arithmetic and logic.
FN real function_plain(uint op, real a, real b, real c) {
    if (op == FUNCTION_ADD) return a + b;
    if (op == FUNCTION_SUBTRACT) return a - b;
    if (op == FUNCTION_MULTIPLY) return a * b;
    if (op == FUNCTION_DIVIDE) return a / b;
    if (op == FUNCTION_NEGATE) return -a;
    if (op == FUNCTION_ABSOLUTE) return abs(a);
    if (op == FUNCTION_SQUARE_ROOT) return sqrt(a);
    if (op == FUNCTION_FLOOR) return floor(a);
    if (op == FUNCTION_CEILING) return -floor(-a);
    if (op == FUNCTION_TRUNCATE) return towards_zero(a);
    if (op == FUNCTION_NOT) return truth(!is_true(a));
    if (op == FUNCTION_MINIMUM) return min(a, b);
    if (op == FUNCTION_MAXIMUM) return max(a, b);
    if (op == FUNCTION_MODULO) return a - b * towards_zero(a / b);
    if (op == FUNCTION_QUOTIENT) return towards_zero(a / b);
    if (op == FUNCTION_LESS) return truth(a < b);
    if (op == FUNCTION_LESS_EQUAL) return truth(a <= b);
    if (op == FUNCTION_EQUAL) return truth(!is_true(a - b));
    if (op == FUNCTION_AND) return truth(is_true(a) && is_true(b));
    if (op == FUNCTION_OR) return truth(is_true(a) || is_true(b));
    if (op == FUNCTION_SELECT_NEGATIVE) return a < 0.0f ? b : c;
    return a == 0.0f ? b : c;
}

/// The function's value at p as a pattern takes it: above 1 without its whole part, 0 where there is none. Words: the
/// numbers of instructions and of constants, the operand that is the result, the constants, and two words an
/// instruction: operation, the register that it fills; its operands a, b and c: a register each, or a constant.
FN real function_field(SCENE uint at, real3 p) {
    float registers[FUNCTION_REGISTERS];
    registers[0] = p.x;
    registers[1] = p.y;
    registers[2] = p.z;
    uint count = AT(code, at);
    uint constants = at + 3u;
    uint first = constants + AT(code, at + 1u);
    // One round more, for the result.
    real value = 0.0f;
    for (uint i = 0u; i <= count; i = i + 1u) {
        bool is_end = i == count;
        uint instruction = 0u;
        uint operands = AT(code, at + 2u);
        if (!is_end) {
            instruction = AT(code, first + i * 2u);
            operands = AT(code, first + i * 2u + 1u);
        }
        uint operand_a = operands & 255u;
        uint operand_b = (operands >> 8u) & 255u;
        uint operand_c = (operands >> 16u) & 255u;
        real a = 0.0f;
        real b = 0.0f;
        real c = 0.0f;
        if (operand_a < FUNCTION_CONSTANT) a = registers[operand_a];
        else a = code_float(SCENE_ constants + operand_a - FUNCTION_CONSTANT);
        if (operand_b < FUNCTION_CONSTANT) b = registers[operand_b];
        else b = code_float(SCENE_ constants + operand_b - FUNCTION_CONSTANT);
        if (operand_c < FUNCTION_CONSTANT) c = registers[operand_c];
        else c = code_float(SCENE_ constants + operand_c - FUNCTION_CONSTANT);
        if (is_end) {
            value = a;
            break;
        }
        uint op = instruction & 255u;
        real result;
        if (op < FUNCTION_NOISE) {
            result = function_plain(op, a, b, c);
        } else if (FIELDS_HAVE(FIELD_FUNCTION_NOISE) && op < FUNCTION_EXPONENTIAL) {
            result = noise_value(real3(a, b, c), op - FUNCTION_NOISE + 1u);
        } else if (FIELDS_HAVE(FIELD_FUNCTION_ANGLES)) {
            result = function_angle(op, a, b);
        } else {
            result = 0.0f;
        }
        registers[(instruction >> 8u) & 255u] = result;
    }
    if (!(abs(value) < 3.0e38f)) return 0.0f;
    return value > 1.0f ? fraction(value) : value;
}

KERNEL_END

#endif
