// SPDX-License-Identifier: Apache-2.0
// Makes flat functions: constants are folded, equal parts are computed once, what isn't used is left out.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "scene/function.h"

namespace sundog::fields {

class FunctionBuilder;

/// A number within a function under way. Arithmetic on it adds instructions.
struct Number {
    FunctionBuilder* builder = nullptr;
    std::uint32_t node = 0;
};

/// Raised where a function would become too large (calls are written out in place).
class FunctionTooLarge : public std::runtime_error {
public:
    FunctionTooLarge() : std::runtime_error("this function becomes too large: more than 200000 operations") {}
};

class FunctionBuilder {
public:
    using Op = scene::FunctionOp;
    static constexpr std::size_t kMostNodes = 200'000;

    explicit FunctionBuilder(std::uint32_t input_count);
    FunctionBuilder(const FunctionBuilder&) = delete;
    FunctionBuilder& operator=(const FunctionBuilder&) = delete;
    ~FunctionBuilder() = default;

    Number constant(double value);
    Number input(std::uint32_t i) { return {this, i}; }
    Number unary(Op op, Number a);
    Number binary(Op op, Number a, Number b);
    Number select_negative(Number a, Number if_negative, Number otherwise);
    Number select_zero(Number a, Number if_zero, Number otherwise);
    /// `generator` is 1 to 3.
    Number noise(Number x, Number y, Number z, std::uint32_t generator);
    Number spline(const std::shared_ptr<const scene::FunctionSpline>& spline, Number at, std::uint8_t component);
    /// Component 0 to 4 (red, green, blue, filter, transmit) of a pigment at a point.
    Number pigment(const std::shared_ptr<const scene::Pigment>& pigment, Number x, Number y, Number z,
                   std::uint8_t component);
    /// A sum or product of a term over whole steps: begin_loop() gives the counter, end_loop() the result. What is made
    /// between them and isn't the result must not be used after it.
    Number begin_loop(Number from, Number to);
    Number end_loop(Number counter, Number term, bool is_product);

    [[nodiscard]] std::optional<double> value_of(Number n) const;
    /// The function. The builder can go on.
    [[nodiscard]] scene::Function finish(std::span<const Number> outputs) const;

private:
    enum class Kind : std::uint8_t { input, constant, instruction };
    struct Node {
        Kind kind = Kind::input;
        double value = 0;
        scene::FunctionInstruction code;  ///< Operands are nodes here.
    };
    using Key = std::tuple<std::uint8_t, std::uint8_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

    std::uint32_t append(const Node& node);
    Number emit(Op op, Number a, Number b, Number c, std::uint32_t index = 0, std::uint8_t component = 0);
    std::optional<Number> simplified(Op op, Number a, Number b);

    std::vector<Node> nodes_;
    std::map<std::uint64_t, std::uint32_t> constants_;
    std::map<Key, std::uint32_t> known_;
    std::vector<std::vector<Key>> loops_;  ///< What each open loop made known.
    std::vector<std::shared_ptr<const scene::FunctionSpline>> splines_;
    std::vector<std::shared_ptr<const scene::Pigment>> pigments_;
    std::uint32_t input_count_;
};

Number operator+(Number a, Number b);
Number operator-(Number a, Number b);
Number operator*(Number a, Number b);
Number operator/(Number a, Number b);
Number operator-(Number a);
Number operator+(Number a, double b);
Number operator+(double a, Number b);
Number operator-(Number a, double b);
Number operator-(double a, Number b);
Number operator*(double a, Number b);
Number operator*(Number a, double b);
Number operator/(Number a, double b);
Number operator/(double a, Number b);
Number sqr(Number a);
Number sqrt(Number a);
Number abs(Number a);
Number exp(Number a);
Number sin(Number a);
Number cos(Number a);
Number floor(Number a);
Number atan2(Number y, Number x);
Number pow(Number a, Number b);
Number min(Number a, Number b);
Number max(Number a, Number b);

}  // namespace sundog::fields
