// SPDX-License-Identifier: Apache-2.0
// Runs flat functions over any kind of number: doubles, doubles with derivatives, ranges. A kind is a class `Math` with
// a type Value and a function for each operation.
#pragma once

#include <cstdint>

#include "scene/function.h"

namespace sundog::fields {

/// The value of one instruction that is neither a loop nor a pigment.
template <class Math>
[[gnu::always_inline]] inline typename Math::Value compute(const Math& m, const scene::Function& f,
                                                           const scene::FunctionInstruction& i,
                                                           const typename Math::Value* r) {
    using Op = scene::FunctionOp;
    switch (i.op) {
        case Op::negate:
            return m.negate(r[i.a]);
        case Op::absolute:
            return m.absolute(r[i.a]);
        case Op::square:
            return m.square(r[i.a]);
        case Op::square_root:
            return m.square_root(r[i.a]);
        case Op::exponential:
            return m.exponential(r[i.a]);
        case Op::logarithm:
            return m.logarithm(r[i.a]);
        case Op::sine:
            return m.sine(r[i.a]);
        case Op::cosine:
            return m.cosine(r[i.a]);
        case Op::tangent:
            return m.tangent(r[i.a]);
        case Op::arc_sine:
            return m.arc_sine(r[i.a]);
        case Op::arc_cosine:
            return m.arc_cosine(r[i.a]);
        case Op::arc_tangent:
            return m.arc_tangent(r[i.a]);
        case Op::hyperbolic_sine:
            return m.hyperbolic_sine(r[i.a]);
        case Op::hyperbolic_cosine:
            return m.hyperbolic_cosine(r[i.a]);
        case Op::hyperbolic_tangent:
            return m.hyperbolic_tangent(r[i.a]);
        case Op::inverse_hyperbolic_sine:
            return m.inverse_hyperbolic_sine(r[i.a]);
        case Op::inverse_hyperbolic_cosine:
            return m.inverse_hyperbolic_cosine(r[i.a]);
        case Op::inverse_hyperbolic_tangent:
            return m.inverse_hyperbolic_tangent(r[i.a]);
        case Op::floor:
            return m.floor(r[i.a]);
        case Op::ceiling:
            return m.negate(m.floor(m.negate(r[i.a])));
        case Op::truncate:
            return m.truncate(r[i.a]);
        case Op::logical_not:
            return m.logical_not(r[i.a]);
        case Op::spline:
            return m.spline(*f.splines[i.index], r[i.a], i.component);
        case Op::add:
            return m.add(r[i.a], r[i.b]);
        case Op::subtract:
            return m.subtract(r[i.a], r[i.b]);
        case Op::multiply:
            return m.multiply(r[i.a], r[i.b]);
        case Op::divide:
            return m.divide(r[i.a], r[i.b]);
        case Op::minimum:
            return m.minimum(r[i.a], r[i.b]);
        case Op::maximum:
            return m.maximum(r[i.a], r[i.b]);
        case Op::power:
            return m.power(r[i.a], r[i.b]);
        case Op::arc_tangent2:
            return m.arc_tangent2(r[i.a], r[i.b]);
        case Op::modulo:
            return m.modulo(r[i.a], r[i.b]);
        case Op::truncated_quotient:
            return m.truncate(m.divide(r[i.a], r[i.b]));
        case Op::less:
            return m.less(r[i.a], r[i.b]);
        case Op::less_equal:
            return m.less_equal(r[i.a], r[i.b]);
        case Op::equal:
            return m.equal(r[i.a], r[i.b]);
        case Op::logical_and:
            return m.logical_and(r[i.a], r[i.b]);
        case Op::logical_or:
            return m.logical_or(r[i.a], r[i.b]);
        case Op::bitwise_and:
        case Op::bitwise_or:
        case Op::bitwise_xor:
            return m.bitwise(i.op, r[i.a], r[i.b]);
        case Op::select_negative:
            return m.select_negative(r[i.a], r[i.b], r[i.c]);
        case Op::select_zero:
            return m.select_zero(r[i.a], r[i.b], r[i.c]);
        case Op::noise:
            return m.noise(i.index, r[i.a], r[i.b], r[i.c]);
        default:
            return r[i.a];
    }
}

/// Fills the registers of a function's results; those of constants and inputs must be there. `budget` counts
/// instructions down; at 0 the results are unknown: the caller must look at it. Math::unknown() stands for the sum of a
/// loop whose bounds aren't plain numbers.
template <class Math>
void run(const Math& m, const scene::Function& f, typename Math::Value* r, std::uint64_t& budget) {
    using Op = scene::FunctionOp;
    const scene::FunctionInstruction* code = f.code.data();
    typename Math::Value* results = r + f.first_result();
    const std::size_t count = f.code.size();
    if (budget < count) {
        budget = 0;
        return;
    }
    budget -= count;
    for (std::size_t pc = 0; pc < count; ++pc) {
        const scene::FunctionInstruction& i = code[pc];
        if (i.op < Op::pigment) {
            results[pc] = compute(m, f, i, r);
        } else if (i.op == Op::pigment) {
            m.pigment(i.index, r[i.a], r[i.b], r[i.c], results + pc);
            pc += 4;
        } else if (i.op == Op::loop) {
            const std::size_t end = i.c - f.first_result();
            const auto from = m.plain(r[i.a]);
            const auto to = m.plain(r[i.b]);
            r[i.c] = m.constant(code[end].op == Op::loop_sum ? 0 : 1);
            // Counters that can't step, and bounds that aren't known, have no sum.
            if (!from || !to || *from + 1 == *from || *to + 1 == *to) {
                if (!from || !to || *from <= *to) r[i.c] = m.unknown();
                pc = end;
            } else if (*from > *to) {
                pc = end;
            } else {
                results[pc] = m.constant(*from);
            }
        } else if (i.op == Op::loop_sum || i.op == Op::loop_product) {
            results[pc] = i.op == Op::loop_sum ? m.add(results[pc], r[i.a]) : m.multiply(results[pc], r[i.a]);
            const std::size_t begin = i.b - f.first_result();
            const double next = *m.plain(r[i.b]) + 1;
            if (next > *m.plain(r[code[begin].b])) continue;
            if (budget < pc - begin) {
                budget = 0;
                return;
            }
            budget -= pc - begin;
            r[i.b] = m.constant(next);
            pc = begin;
        }
    }
}

}  // namespace sundog::fields
