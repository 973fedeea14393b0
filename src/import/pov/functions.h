// SPDX-License-Identifier: Apache-2.0
// User-defined functions of POV-Ray's language: `function (a, b) { … }`.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "import/pov/entity.h"
#include "import/pov/spline.h"
#include "scene/function.h"
#include "scene/scene.h"

namespace sundog::pov {

/// What a FunctionNode computes.
enum class FunctionOp : std::uint8_t {
    constant,     ///< `number`
    variable,     ///< Local variable `index`: the parameters first, then those of sums and products.
    negate,       ///< -a
    logical_not,  ///< !a
    add,
    subtract,
    multiply,
    divide,
    less,
    less_equal,
    equal,
    not_equal,
    greater_equal,
    greater,
    logical_and,
    logical_or,
    builtin,  ///< The function that `keyword` names (sin, max, select, …) of its arguments.
    user,     ///< Component `component` of callees[index] of its arguments.
    sum,      ///< Arguments: from, to, term; the counter is variable `index`.
    product,
};

/// One operation. Its arguments are earlier nodes.
struct FunctionNode {
    FunctionOp op = FunctionOp::constant;
    std::uint8_t component = 0;  ///< 0 to 4 of a vector or colour; kGrayComponent for a colour's grey.
    Keyword keyword{};
    std::uint32_t index = 0;
    std::uint32_t first_argument = 0;  ///< Into FunctionExpression::arguments.
    std::uint32_t argument_count = 0;
    double number = 0;
    Place where;
};

inline constexpr std::uint8_t kGrayComponent = 5;

/// What a function is made of.
enum class FunctionKind : std::uint8_t {
    expression,  ///< nodes
    internal,    ///< internal(number): one of POV-Ray's own, declared in its functions.inc
    pigment,     ///< block: pigment { … }; the value is a colour, the arguments a point
    pattern,     ///< block: pattern { … }; the value is a float, the arguments a point
    transform,   ///< block: transform { … }; the value is a point, the arguments a point
    spline,      ///< spline; the value is a vector, the argument a float
};

/// A function, worked out as far as its arguments aren't needed: identifiers and constant parts are numbers.
struct FunctionExpression {
    Place where;
    FunctionKind kind = FunctionKind::expression;
    std::uint32_t depth = 1;              ///< 1 + the deepest of callees.
    std::vector<std::string> parameters;  ///< Of an expression. `u` is an x, `v` a y, where those are parameters.
    std::vector<FunctionNode> nodes;      ///< The last one is the value.
    std::vector<std::uint32_t> arguments;
    std::uint32_t variable_count = 0;  ///< parameters and the counters of sums and products
    std::vector<std::shared_ptr<const FunctionExpression>> callees;
    std::uint32_t internal_number = 0;
    std::shared_ptr<const Block> block;
    std::shared_ptr<const Spline> spline;
};

/// Reads the pigments that functions are made of: the builder's part. All may throw InputError.
class FunctionPigments {
public:
    virtual ~FunctionPigments() = default;
    /// Of `pigment { … }`; one pigment for one block.
    virtual std::shared_ptr<const scene::Pigment> pigment_of(const std::shared_ptr<const Block>& pigment) = 0;
    /// One whose red is the value of `pattern { gradient x … }`.
    virtual std::shared_ptr<const scene::Pigment> pigment_of_pattern(const std::shared_ptr<const Block>& pattern) = 0;
    /// What the pigments' images are taken from.
    [[nodiscard]] virtual std::span<const scene::Texture> textures() const = 0;
};

/// The most nested calls of user functions.
inline constexpr std::uint32_t kFunctionDepthLimit = 256;

/// Raised where a function has no value: division by zero, wrong number of arguments, no FunctionPigments.
class FunctionError : public std::runtime_error {
public:
    FunctionError(Place where, const std::string& message) : std::runtime_error(message), where(where) {}
    Place where;
};

/// Calls functions with numbers. Functions are made ready at their first call and kept for the next.
class FunctionCalls {
public:
    /// `pigments` may be null where no function of a pigment or pattern is called.
    explicit FunctionCalls(FunctionPigments* pigments);
    FunctionCalls(const FunctionCalls&) = delete;
    FunctionCalls& operator=(const FunctionCalls&) = delete;
    ~FunctionCalls();

    /// The function's value: one component of an expression, internal function or pattern, else as many as the kind
    /// gives. Errors: FunctionError, and InputError of `pigments`. `budget` counts operations down (sums may be long)
    /// and makes an error at zero.
    Value call(const std::shared_ptr<const FunctionExpression>& function, std::span<const double> arguments,
               std::uint64_t& budget);

private:
    struct Ready;
    Ready& ready(const std::shared_ptr<const FunctionExpression>& function);

    FunctionPigments* pigments_;
    std::map<const FunctionExpression*, std::unique_ptr<Ready>> ready_;
};

/// What an operation gives for its arguments; of all but variables, calls, sums and products.
double value_of(const FunctionNode& node, std::span<const double> arguments);

/// How many arguments a call of it has; 0 for an internal function, which takes what it needs.
std::size_t parameter_count(const FunctionExpression& function);

}  // namespace sundog::pov
