// SPDX-License-Identifier: Apache-2.0
#include "fields/function_words.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include "kernel/patterns/shader_function.h"

namespace sundog::fields {
namespace {

using Op = scene::FunctionOp;

struct ShaderOp {
    std::uint32_t number;
    int operands;
};

std::optional<ShaderOp> shader_op(const scene::FunctionInstruction& i) {
    switch (i.op) {
        case Op::negate:
            return {{kernel::FUNCTION_NEGATE, 1}};
        case Op::absolute:
            return {{kernel::FUNCTION_ABSOLUTE, 1}};
        case Op::square:
            return {{kernel::FUNCTION_MULTIPLY, 1}};
        case Op::square_root:
            return {{kernel::FUNCTION_SQUARE_ROOT, 1}};
        case Op::exponential:
            return {{kernel::FUNCTION_EXPONENTIAL, 1}};
        case Op::logarithm:
            return {{kernel::FUNCTION_LOGARITHM, 1}};
        case Op::sine:
            return {{kernel::FUNCTION_SINE, 1}};
        case Op::cosine:
            return {{kernel::FUNCTION_COSINE, 1}};
        case Op::tangent:
            return {{kernel::FUNCTION_TANGENT, 1}};
        case Op::arc_sine:
            return {{kernel::FUNCTION_ARC_SINE, 1}};
        case Op::arc_cosine:
            return {{kernel::FUNCTION_ARC_COSINE, 1}};
        case Op::arc_tangent:
            return {{kernel::FUNCTION_ARC_TANGENT, 1}};
        case Op::hyperbolic_sine:
            return {{kernel::FUNCTION_HYPERBOLIC_SINE, 1}};
        case Op::hyperbolic_cosine:
            return {{kernel::FUNCTION_HYPERBOLIC_COSINE, 1}};
        case Op::hyperbolic_tangent:
            return {{kernel::FUNCTION_HYPERBOLIC_TANGENT, 1}};
        case Op::floor:
            return {{kernel::FUNCTION_FLOOR, 1}};
        case Op::ceiling:
            return {{kernel::FUNCTION_CEILING, 1}};
        case Op::truncate:
            return {{kernel::FUNCTION_TRUNCATE, 1}};
        case Op::logical_not:
            return {{kernel::FUNCTION_NOT, 1}};
        case Op::add:
            return {{kernel::FUNCTION_ADD, 2}};
        case Op::subtract:
            return {{kernel::FUNCTION_SUBTRACT, 2}};
        case Op::multiply:
            return {{kernel::FUNCTION_MULTIPLY, 2}};
        case Op::divide:
            return {{kernel::FUNCTION_DIVIDE, 2}};
        case Op::minimum:
            return {{kernel::FUNCTION_MINIMUM, 2}};
        case Op::maximum:
            return {{kernel::FUNCTION_MAXIMUM, 2}};
        case Op::power:
            return {{kernel::FUNCTION_POWER, 2}};
        case Op::arc_tangent2:
            return {{kernel::FUNCTION_ARC_TANGENT2, 2}};
        case Op::modulo:
            return {{kernel::FUNCTION_MODULO, 2}};
        case Op::truncated_quotient:
            return {{kernel::FUNCTION_QUOTIENT, 2}};
        case Op::less:
            return {{kernel::FUNCTION_LESS, 2}};
        case Op::less_equal:
            return {{kernel::FUNCTION_LESS_EQUAL, 2}};
        case Op::equal:
            return {{kernel::FUNCTION_EQUAL, 2}};
        case Op::logical_and:
            return {{kernel::FUNCTION_AND, 2}};
        case Op::logical_or:
            return {{kernel::FUNCTION_OR, 2}};
        case Op::select_negative:
            return {{kernel::FUNCTION_SELECT_NEGATIVE, 3}};
        case Op::select_zero:
            return {{kernel::FUNCTION_SELECT_ZERO, 3}};
        case Op::noise:
            return {{kernel::FUNCTION_NOISE + i.index - 1, 3}};
        default:
            return std::nullopt;
    }
}

/// Gives values registers, which are used again where a value is taken for the last time.
class Registers {
public:
    explicit Registers(const scene::Function& f)
        : last_use_(f.register_count(), 0), place_(f.register_count(), kernel::FUNCTION_REGISTERS) {
        for (std::size_t pc = 0; pc < f.code.size(); ++pc)
            for (const std::uint32_t value : {f.code[pc].a, f.code[pc].b, f.code[pc].c}) last_use_[value] = pc;
        last_use_[f.outputs[0]] = f.code.size();
        for (std::uint32_t i = 0; i < kernel::FUNCTION_REGISTERS; ++i)
            if (i >= f.input_count) free_.push_back(i);
        for (std::uint32_t i = 0; i < f.input_count; ++i) place_[f.first_input() + i] = i;
    }
    [[nodiscard]] std::uint32_t place(std::uint32_t value) const { return place_[value]; }
    /// Whether there was one for the value that instruction `pc` computes.
    bool take(std::uint32_t value) {
        if (free_.empty()) return false;
        const auto lowest = std::min_element(free_.begin(), free_.end());
        place_[value] = *lowest;
        free_.erase(lowest);
        return true;
    }
    void release(std::uint32_t value, std::size_t pc) {
        if (last_use_[value] == pc && place_[value] < kernel::FUNCTION_REGISTERS) {
            free_.push_back(place_[value]);
            place_[value] = kernel::FUNCTION_REGISTERS;
        }
    }

private:
    std::vector<std::size_t> last_use_;  ///< By value: the instruction that takes it last.
    std::vector<std::uint32_t> place_;   ///< FUNCTION_REGISTERS: none.
    std::vector<std::uint32_t> free_;
};

}  // namespace

std::optional<FunctionWords> function_words(const scene::Function& f) {
    constexpr std::size_t kMostInputs = 3;
    if (f.input_count > kMostInputs || f.outputs.size() != 1 || f.constants.size() > kernel::FUNCTION_CONSTANT)
        return std::nullopt;
    Registers registers(f);
    FunctionWords out;
    const auto operand = [&](std::uint32_t value) {
        return value < f.constants.size() ? kernel::FUNCTION_CONSTANT + value : registers.place(value);
    };
    out.words = {static_cast<std::uint32_t>(f.code.size()), static_cast<std::uint32_t>(f.constants.size()), 0};
    for (const double c : f.constants) out.words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(c)));
    for (std::size_t pc = 0; pc < f.code.size(); ++pc) {
        const scene::FunctionInstruction& i = f.code[pc];
        const std::optional<ShaderOp> op = shader_op(i);
        if (!op) return std::nullopt;
        if (op->number >= kernel::FUNCTION_EXPONENTIAL) out.fields |= 1U << kernel::FIELD_FUNCTION_ANGLES;
        else if (op->number >= kernel::FUNCTION_NOISE) out.fields |= 1U << kernel::FIELD_FUNCTION_NOISE;
        std::array<std::uint32_t, 3> values{i.a, i.b, i.c};
        if (i.op == Op::square) values[1] = i.a;
        const std::size_t count = i.op == Op::square ? 2 : static_cast<std::size_t>(op->operands);
        std::uint32_t operands = 0;
        for (std::size_t k = 0; k < count; ++k) operands |= operand(values[k]) << 8U * k;
        for (std::size_t k = 0; k < count; ++k) registers.release(values[k], pc);
        const auto result = static_cast<std::uint32_t>(f.first_result() + pc);
        if (!registers.take(result)) return std::nullopt;
        out.words.push_back(op->number | registers.place(result) << 8U);
        out.words.push_back(operands);
    }
    out.words[2] = operand(f.outputs[0]);
    return out;
}

}  // namespace sundog::fields
