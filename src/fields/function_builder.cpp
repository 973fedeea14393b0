// SPDX-License-Identifier: Apache-2.0
#include "fields/function_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fields/double_math.h"

namespace sundog::fields {

namespace {
bool is_commutative(scene::FunctionOp op) {
    using Op = scene::FunctionOp;
    return op == Op::add || op == Op::multiply || op == Op::minimum || op == Op::maximum || op == Op::equal ||
           op == Op::logical_and || op == Op::logical_or;
}
}  // namespace

FunctionBuilder::FunctionBuilder(std::uint32_t input_count) : input_count_(input_count) { nodes_.resize(input_count); }

std::uint32_t FunctionBuilder::append(const Node& node) {
    if (nodes_.size() >= kMostNodes) throw FunctionTooLarge();
    nodes_.push_back(node);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

Number FunctionBuilder::constant(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto known = constants_.find(bits);
    if (known != constants_.end()) return {this, known->second};
    Node node;
    node.kind = Kind::constant;
    node.value = value;
    const std::uint32_t index = append(node);
    constants_.emplace(bits, index);
    return {this, index};
}

std::optional<double> FunctionBuilder::value_of(Number n) const {
    const Node& node = nodes_[n.node];
    return node.kind == Kind::constant ? std::optional(node.value) : std::nullopt;
}

Number FunctionBuilder::emit(Op op, Number a, Number b, Number c, std::uint32_t index, std::uint8_t component) {
    if (is_commutative(op)) {
        if (b.node < a.node) std::swap(a, b);
        c = a;
    }
    const Key key{static_cast<std::uint8_t>(op), component, index, a.node, b.node, c.node};
    const bool can_be_shared = op != Op::loop && op != Op::loop_sum && op != Op::loop_product;
    if (can_be_shared)
        if (const auto known = known_.find(key); known != known_.end()) return {this, known->second};
    Node node;
    node.kind = Kind::instruction;
    node.code = {op, component, index, a.node, b.node, c.node};
    const std::uint32_t made = append(node);
    if (can_be_shared) {
        known_.emplace(key, made);
        if (!loops_.empty()) loops_.back().push_back(key);
    }
    return {this, made};
}

Number FunctionBuilder::unary(Op op, Number a) {
    if (const auto value = value_of(a)) return constant(DoubleMath::unary(op, *value));
    const Node& node = nodes_[a.node];
    if (node.kind == Kind::instruction) {
        if (op == Op::negate && node.code.op == Op::negate) return {this, node.code.a};
        const bool even = op == Op::absolute || op == Op::square || op == Op::cosine;
        if (even && (node.code.op == Op::negate || node.code.op == Op::absolute)) return unary(op, {this, node.code.a});
        if (op == Op::absolute && (node.code.op == Op::square || node.code.op == Op::square_root)) return a;
    }
    return emit(op, a, a, a);
}

/// Operations with a known operand that need no instruction, or a cheaper one.
std::optional<Number> FunctionBuilder::simplified(Op op, Number a, Number b) {
    const auto x = value_of(a);
    const auto y = value_of(b);
    switch (op) {
        case Op::add:
            if (x == 0.0) return b;
            if (y == 0.0) return a;
            if (nodes_[b.node].kind == Kind::instruction && nodes_[b.node].code.op == Op::negate)
                return binary(Op::subtract, a, {this, nodes_[b.node].code.a});
            break;
        case Op::subtract:
            if (y == 0.0) return a;
            if (x == 0.0) return unary(Op::negate, b);
            if (a.node == b.node) return constant(0);
            if (nodes_[b.node].kind == Kind::instruction && nodes_[b.node].code.op == Op::negate)
                return binary(Op::add, a, {this, nodes_[b.node].code.a});
            break;
        case Op::multiply:
            if (x == 0.0 || y == 0.0) return constant(0);
            if (x == 1.0) return b;
            if (y == 1.0) return a;
            if (x == -1.0) return unary(Op::negate, b);
            if (y == -1.0) return unary(Op::negate, a);
            if (a.node == b.node) return unary(Op::square, a);
            break;
        case Op::divide:
            if (y == 1.0) return a;
            if (y == -1.0) return unary(Op::negate, a);
            // Exact: powers of two.
            if (y && std::isnormal(*y) && std::abs(std::frexp(*y, std::array<int, 1>{}.data())) == 0.5)
                return binary(Op::multiply, a, constant(1 / *y));
            break;
        case Op::minimum:
        case Op::maximum:
            if (a.node == b.node) return a;
            break;
        case Op::power: {
            if (y == 0.0) return constant(1);
            if (y == 1.0) return a;
            if (y == 0.5) return unary(Op::square_root, a);
            // Small whole powers by squaring: within rounding of pow().
            if (y && *y == std::trunc(*y) && std::abs(*y) <= 32) {
                const int whole = static_cast<int>(std::abs(*y));
                std::optional<Number> result;
                Number factor = a;
                for (int rest = whole; rest > 0; rest >>= 1) {
                    if ((rest & 1) != 0) result = result ? binary(Op::multiply, *result, factor) : factor;
                    if (rest > 1) factor = unary(Op::square, factor);
                }
                return *y > 0 ? *result : binary(Op::divide, constant(1), *result);
            }
            break;
        }
        default:
            break;
    }
    return std::nullopt;
}

Number FunctionBuilder::binary(Op op, Number a, Number b) {
    const auto x = value_of(a);
    const auto y = value_of(b);
    if (x && y) return constant(DoubleMath::binary(op, *x, *y));
    if (const auto simple = simplified(op, a, b)) return *simple;
    return emit(op, a, b, a);
}

Number FunctionBuilder::select_negative(Number a, Number if_negative, Number otherwise) {
    if (const auto value = value_of(a)) return *value < 0 ? if_negative : otherwise;
    if (if_negative.node == otherwise.node) return otherwise;
    return emit(Op::select_negative, a, if_negative, otherwise);
}

Number FunctionBuilder::select_zero(Number a, Number if_zero, Number otherwise) {
    if (const auto value = value_of(a)) return *value == 0 ? if_zero : otherwise;
    if (if_zero.node == otherwise.node) return otherwise;
    return emit(Op::select_zero, a, if_zero, otherwise);
}

Number FunctionBuilder::noise(Number x, Number y, Number z, std::uint32_t generator) {
    return emit(Op::noise, x, y, z, std::clamp(generator, 1U, 3U));
}

Number FunctionBuilder::spline(const std::shared_ptr<const scene::FunctionSpline>& spline, Number at,
                               std::uint8_t component) {
    const auto known = std::find(splines_.begin(), splines_.end(), spline);
    const auto index = static_cast<std::uint32_t>(known - splines_.begin());
    if (known == splines_.end()) splines_.push_back(spline);
    if (const auto value = value_of(at)) return constant(DoubleMath::spline(*spline, *value, component));
    return emit(Op::spline, at, at, at, index, component);
}

Number FunctionBuilder::pigment(const std::shared_ptr<const scene::Pigment>& pigment, Number x, Number y, Number z,
                                std::uint8_t component) {
    const auto known = std::find(pigments_.begin(), pigments_.end(), pigment);
    const auto index = static_cast<std::uint32_t>(known - pigments_.begin());
    if (known == pigments_.end()) pigments_.push_back(pigment);
    const std::size_t before = nodes_.size();
    const Number red = emit(Op::pigment, x, y, z, index);
    if (nodes_.size() > before) {
        for (std::uint8_t i = 1; i < 5; ++i) {
            Node part;
            part.kind = Kind::instruction;
            part.code = {Op::pigment_part, i, index, red.node, red.node, red.node};
            append(part);
        }
    }
    return {this, red.node + component};
}

Number FunctionBuilder::begin_loop(Number from, Number to) {
    loops_.emplace_back();
    return emit(Op::loop, from, to, from);
}

Number FunctionBuilder::end_loop(Number counter, Number term, bool is_product) {
    // What was computed within isn't there where the loop runs no time at all.
    for (const Key& key : loops_.back()) known_.erase(key);
    loops_.pop_back();
    const Number result = emit(is_product ? Op::loop_product : Op::loop_sum, term, counter, term);
    nodes_[counter.node].code.c = result.node;
    return result;
}

scene::Function FunctionBuilder::finish(std::span<const Number> outputs) const {
    std::vector<bool> used(nodes_.size(), false);
    for (const Number output : outputs) used[output.node] = true;
    for (std::size_t i = nodes_.size(); i-- > input_count_;) {
        const Node& node = nodes_[i];
        if (!used[i] || node.kind != Kind::instruction) continue;
        used[node.code.a] = used[node.code.b] = true;
        if (node.code.op != Op::loop) used[node.code.c] = true;
        // A pigment's parts stay together.
        if (node.code.op == Op::pigment)
            for (std::size_t k = 1; k < 5; ++k) used[i + k] = true;
    }
    scene::Function out;
    out.input_count = input_count_;
    std::vector<std::uint32_t> place(nodes_.size(), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (!used[i] || nodes_[i].kind != Kind::constant) continue;
        place[i] = static_cast<std::uint32_t>(out.constants.size());
        out.constants.push_back(nodes_[i].value);
    }
    auto next = static_cast<std::uint32_t>(out.constants.size());
    for (std::uint32_t i = 0; i < input_count_; ++i) place[i] = next++;
    for (std::size_t i = input_count_; i < nodes_.size(); ++i)
        if (used[i] && nodes_[i].kind == Kind::instruction) place[i] = next++;
    for (std::size_t i = input_count_; i < nodes_.size(); ++i) {
        if (!used[i] || nodes_[i].kind != Kind::instruction) continue;
        scene::FunctionInstruction code = nodes_[i].code;
        code.a = place[code.a], code.b = place[code.b], code.c = place[code.c];
        out.code.push_back(code);
    }
    for (const Number output : outputs) out.outputs.push_back(place[output.node]);
    out.splines = splines_;
    out.pigments = pigments_;
    return out;
}

namespace {
using Op = scene::FunctionOp;
Number operation(Op op, Number a, Number b) { return a.builder->binary(op, a, b); }
}  // namespace

Number operator+(Number a, Number b) { return operation(Op::add, a, b); }
Number operator-(Number a, Number b) { return operation(Op::subtract, a, b); }
Number operator*(Number a, Number b) { return operation(Op::multiply, a, b); }
Number operator/(Number a, Number b) { return operation(Op::divide, a, b); }
Number operator-(Number a) { return a.builder->unary(Op::negate, a); }
Number operator+(Number a, double b) { return a + a.builder->constant(b); }
Number operator+(double a, Number b) { return b.builder->constant(a) + b; }
Number operator-(Number a, double b) { return a - a.builder->constant(b); }
Number operator-(double a, Number b) { return b.builder->constant(a) - b; }
Number operator*(double a, Number b) { return b.builder->constant(a) * b; }
Number operator*(Number a, double b) { return a * a.builder->constant(b); }
Number operator/(Number a, double b) { return a / a.builder->constant(b); }
Number operator/(double a, Number b) { return b.builder->constant(a) / b; }
Number sqr(Number a) { return a.builder->unary(Op::square, a); }
Number sqrt(Number a) { return a.builder->unary(Op::square_root, a); }
Number abs(Number a) { return a.builder->unary(Op::absolute, a); }
Number exp(Number a) { return a.builder->unary(Op::exponential, a); }
Number sin(Number a) { return a.builder->unary(Op::sine, a); }
Number cos(Number a) { return a.builder->unary(Op::cosine, a); }
Number floor(Number a) { return a.builder->unary(Op::floor, a); }
Number atan2(Number y, Number x) { return operation(Op::arc_tangent2, y, x); }
Number pow(Number a, Number b) { return operation(Op::power, a, b); }
Number min(Number a, Number b) { return operation(Op::minimum, a, b); }
Number max(Number a, Number b) { return operation(Op::maximum, a, b); }

}  // namespace sundog::fields
