// SPDX-License-Identifier: Apache-2.0
// User functions (manual, 3.3.1.8): their text becomes a FunctionExpression, its constant parts worked out.
#include <algorithm>

#include "import/pov/interpreter_core.h"
#include "import/pov/math_functions.h"
#include "import/pov/word_use.h"

namespace sundog::pov {

/// Reads the body of one function.
class FunctionParser {
public:
    FunctionParser(Interpreter& interpreter, FunctionExpression& function, const std::vector<NameId>& parameters)
        : in_(interpreter), f_(function) {
        for (const NameId name : parameters) {
            f_.parameters.emplace_back(in_.names_.text(name));
            variables_.push_back(name);
        }
        f_.variable_count = static_cast<std::uint32_t>(variables_.size());
    }

    void run() {
        parse_or();
        if (f_.nodes.empty()) in_.fail(f_.where, "an empty function");
    }

private:
    using Spot = Interpreter::Spot;

    static constexpr std::size_t kMostVariables = 56;
    static constexpr std::size_t kMostNodes = 1'000'000;

    std::uint32_t add(FunctionNode node, std::span<const std::uint32_t> arguments) {
        in_.tick();
        if (f_.nodes.size() >= kMostNodes) in_.fail(node.where, "a function of more than a million operations");
        const auto is_constant = [&](std::uint32_t i) { return f_.nodes[i].op == FunctionOp::constant; };
        node.first_argument = static_cast<std::uint32_t>(f_.arguments.size());
        node.argument_count = static_cast<std::uint32_t>(arguments.size());
        const bool is_pure = node.op != FunctionOp::constant && node.op != FunctionOp::variable &&
                             node.op != FunctionOp::user && node.op != FunctionOp::sum &&
                             node.op != FunctionOp::product;
        if (is_pure && std::all_of(arguments.begin(), arguments.end(), is_constant)) {
            // Constant arguments are the last nodes, one each.
            std::vector<double> numbers;
            for (const std::uint32_t i : arguments) numbers.push_back(f_.nodes[i].number);
            node.number = value_of(node, numbers);
            node.op = FunctionOp::constant;
            node.argument_count = 0;
            f_.nodes.resize(f_.nodes.size() - arguments.size());
        } else {
            f_.arguments.insert(f_.arguments.end(), arguments.begin(), arguments.end());
        }
        f_.nodes.push_back(node);
        return static_cast<std::uint32_t>(f_.nodes.size() - 1);
    }
    FunctionNode node(FunctionOp op, Spot where) const {
        FunctionNode result;
        result.op = op;
        result.where = where;
        return result;
    }
    std::uint32_t constant(double number, Spot where) {
        FunctionNode result = node(FunctionOp::constant, where);
        result.number = number;
        return add(result, {});
    }
    std::uint32_t binary(FunctionOp op, std::uint32_t a, std::uint32_t b, Spot where) {
        return add(node(op, where), std::array{a, b});
    }

    std::uint32_t parse_or() {
        std::uint32_t left = parse_and();
        while (in_.peek().kind == TokenKind::bar) {
            const Spot where = in_.here();
            in_.take();
            left = binary(FunctionOp::logical_or, left, parse_and(), where);
        }
        return left;
    }
    std::uint32_t parse_and() {
        std::uint32_t left = parse_relation();
        while (in_.peek().kind == TokenKind::ampersand) {
            const Spot where = in_.here();
            in_.take();
            left = binary(FunctionOp::logical_and, left, parse_relation(), where);
        }
        return left;
    }
    std::uint32_t parse_relation() {
        std::uint32_t left = parse_sum();
        for (;;) {
            FunctionOp op = FunctionOp::less;
            switch (in_.peek().kind) {
                case TokenKind::left_angle:
                    break;
                case TokenKind::less_equal:
                    op = FunctionOp::less_equal;
                    break;
                case TokenKind::equals:
                    op = FunctionOp::equal;
                    break;
                case TokenKind::not_equal:
                    op = FunctionOp::not_equal;
                    break;
                case TokenKind::greater_equal:
                    op = FunctionOp::greater_equal;
                    break;
                case TokenKind::right_angle:
                    op = FunctionOp::greater;
                    break;
                default:
                    return left;
            }
            const Spot where = in_.here();
            in_.take();
            left = binary(op, left, parse_sum(), where);
        }
    }
    std::uint32_t parse_sum() {
        std::uint32_t left = parse_product();
        for (;;) {
            const TokenKind kind = in_.peek().kind;
            if (kind != TokenKind::plus && kind != TokenKind::minus) return left;
            const Spot where = in_.here();
            in_.take();
            left =
                binary(kind == TokenKind::plus ? FunctionOp::add : FunctionOp::subtract, left, parse_product(), where);
        }
    }
    std::uint32_t parse_product() {
        std::uint32_t left = parse_unary();
        for (;;) {
            const TokenKind kind = in_.peek().kind;
            if (kind != TokenKind::star && kind != TokenKind::slash) return left;
            const Spot where = in_.here();
            in_.take();
            left =
                binary(kind == TokenKind::star ? FunctionOp::multiply : FunctionOp::divide, left, parse_unary(), where);
        }
    }
    std::uint32_t parse_unary() {
        const Interpreter::Level level(in_);
        const Spot where = in_.here();
        switch (in_.peek().kind) {
            case TokenKind::plus:
                in_.take();
                return parse_unary();
            case TokenKind::minus: {
                in_.take();
                return add(node(FunctionOp::negate, where), std::array{parse_unary()});
            }
            case TokenKind::exclamation: {
                in_.take();
                return add(node(FunctionOp::logical_not, where), std::array{parse_unary()});
            }
            case TokenKind::number: {
                const double number = in_.peek().number;
                in_.take();
                return constant(number, where);
            }
            case TokenKind::left_paren: {
                in_.take();
                const std::uint32_t inside = parse_or();
                in_.expect(TokenKind::right_paren, "to close the parenthesis");
                return inside;
            }
            case TokenKind::left_angle:
                return constant(single(in_.parse_components(in_.parse_vector()), where), where);
            case TokenKind::keyword:
            case TokenKind::name:
                return parse_word(where);
            default:
                in_.fail_expected("a number, a variable or a function");
        }
    }
    double single(const Value& value, Spot where) const {
        if (value.count != 1) in_.fail(where, "functions are of floats: a component such as .x is needed here");
        return value.v[0];
    }
    std::optional<std::uint32_t> variable(NameId name) const {
        for (std::size_t i = variables_.size(); i-- > 0;)
            if (variables_[i] == name) return static_cast<std::uint32_t>(i);
        return std::nullopt;
    }
    std::uint32_t parse_word(Spot where) {
        const bool is_keyword = in_.peek().kind == TokenKind::keyword;
        const NameId name = in_.peek().payload;
        const auto keyword = static_cast<Keyword>(is_keyword ? name : 0);
        auto index = variable(name);
        if (!index && is_keyword) {
            // The manual takes u for x and v for y.
            const auto other = keyword == Keyword::u   ? std::optional(Keyword::x)
                               : keyword == Keyword::v ? std::optional(Keyword::y)
                               : keyword == Keyword::x ? std::optional(Keyword::u)
                               : keyword == Keyword::y ? std::optional(Keyword::v)
                                                       : std::nullopt;
            if (other) index = variable(static_cast<NameId>(*other));
        }
        if (index) {
            in_.take();
            FunctionNode result = node(FunctionOp::variable, where);
            result.index = *index;
            return add(result, {});
        }
        return is_keyword ? parse_keyword(keyword, where) : parse_name(name, where);
    }
    std::uint32_t parse_keyword(Keyword keyword, Spot where) {
        if (keyword == Keyword::sum || keyword == Keyword::prod) return parse_series(keyword, where);
        if (keyword == Keyword::function) {
            in_.take();
            return call(in_.parse_function(where), where);
        }
        const WordUse use = word_use(keyword);
        const unsigned arity = float_arity(keyword);
        if (arity > 0 || use == WordUse::aggregate) {
            in_.take();
            const std::vector<std::uint32_t> arguments = parse_arguments();
            const bool is_select = keyword == Keyword::select;
            const bool fits = arity > 0   ? arguments.size() == arity
                              : is_select ? arguments.size() == 3 || arguments.size() == 4
                                          : !arguments.empty();
            if (!fits) in_.fail(where, "wrong number of arguments of " + std::string(spelling(keyword)));
            FunctionNode result = node(FunctionOp::builtin, where);
            result.keyword = keyword;
            return add(result, arguments);
        }
        const bool is_axis = keyword == Keyword::x || keyword == Keyword::y || keyword == Keyword::z ||
                             keyword == Keyword::u || keyword == Keyword::v || keyword == Keyword::t;
        if (is_axis && in_.raw().kind() != TokenKind::dot)
            in_.fail(where, "'" + std::string(spelling(keyword)) + "' is no parameter of this function");
        if (use == WordUse::statement || use == WordUse::string || keyword == Keyword::rand || keyword == Keyword::seed)
            in_.fail_expected("a number, a variable or a function of floats");
        return constant(single(in_.parse_keyword_factor(), where), where);
    }
    std::uint32_t parse_name(NameId name, Spot where) {
        const Entity* found = in_.identifiers_.find(name);
        if (found == nullptr) in_.fail_undeclared(where, name);
        Entity entity = *found;
        in_.take();
        if (const auto* array = std::get_if<std::shared_ptr<Array>>(&entity))
            entity = in_.element(std::shared_ptr<Array>(*array), name, where);
        if (const auto* function = std::get_if<std::shared_ptr<const FunctionExpression>>(&entity))
            return call(*function, where);
        if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(&entity)) {
            auto function = std::make_shared<FunctionExpression>();
            function->where = where;
            function->kind = FunctionKind::spline;
            function->spline = *spline;
            return call(std::move(function), where);
        }
        return constant(single(in_.parse_components(in_.value_of_entity(entity, name, where)), where), where);
    }
    std::vector<std::uint32_t> parse_arguments() {
        in_.expect(TokenKind::left_paren, "around the function's arguments");
        std::vector<std::uint32_t> arguments;
        while (!in_.accept(TokenKind::right_paren)) {
            arguments.push_back(parse_or());
            if (!in_.accept(TokenKind::comma) && in_.peek().kind != TokenKind::right_paren)
                in_.fail_expected("',' or ')' in the function's arguments");
        }
        return arguments;
    }
    std::uint32_t call(std::shared_ptr<const FunctionExpression> function, Spot where) {
        const std::vector<std::uint32_t> arguments = parse_arguments();
        const std::size_t wanted = parameter_count(*function);
        if (wanted != 0 && arguments.size() != wanted)
            in_.fail(where, "this function takes " + std::to_string(wanted) + " arguments, not " +
                                std::to_string(arguments.size()));
        FunctionNode result = node(FunctionOp::user, where);
        const bool is_vector = function->kind == FunctionKind::pigment || function->kind == FunctionKind::transform ||
                               function->kind == FunctionKind::spline;
        if (in_.peek().kind == TokenKind::dot && is_vector) {
            in_.take();
            const auto component = in_.peek().kind == TokenKind::keyword
                                       ? component_of(static_cast<Keyword>(in_.peek().payload))
                                       : std::nullopt;
            if (!component) in_.fail_expected("a component (x, y, z, red, green, …)");
            in_.take();
            result.component = *component;
        } else if (is_vector) {
            in_.fail(where, "this function gives a vector or colour: a component such as .x or .red is needed here");
        }
        f_.depth = std::max(f_.depth, function->depth + 1);
        if (f_.depth > kFunctionDepthLimit)
            in_.fail(where,
                     "functions call each other more than " + std::to_string(kFunctionDepthLimit) + " levels deep");
        const auto known = std::find(f_.callees.begin(), f_.callees.end(), function);
        result.index = static_cast<std::uint32_t>(known - f_.callees.begin());
        if (known == f_.callees.end()) f_.callees.push_back(std::move(function));
        return add(result, arguments);
    }
    /// sum(i, from, to, term) and prod.
    std::uint32_t parse_series(Keyword keyword, Spot where) {
        in_.take();
        in_.expect(TokenKind::left_paren, "after ", spelling(keyword));
        // As it stands: the counter need not be declared.
        const NameId counter = in_.peek().payload;
        if (in_.peek().kind != TokenKind::name && in_.peek().kind != TokenKind::keyword)
            in_.fail_expected("the counter's name");
        in_.take();
        in_.expect(TokenKind::comma, "after the counter");
        const std::uint32_t from = parse_or();
        in_.expect(TokenKind::comma, "after the first value of the counter");
        const std::uint32_t to = parse_or();
        in_.expect(TokenKind::comma, "after the last value of the counter");
        if (variables_.size() >= kMostVariables) in_.fail(where, "a function can't have more than 56 variables");
        variables_.push_back(counter);
        f_.variable_count = std::max(f_.variable_count, static_cast<std::uint32_t>(variables_.size()));
        FunctionNode result = node(keyword == Keyword::sum ? FunctionOp::sum : FunctionOp::product, where);
        result.index = static_cast<std::uint32_t>(variables_.size() - 1);
        const std::uint32_t term = parse_or();
        variables_.pop_back();
        in_.expect(TokenKind::right_paren, "after the term");
        return add(result, std::array{from, to, term});
    }

    Interpreter& in_;
    FunctionExpression& f_;
    std::vector<NameId> variables_;
};

std::shared_ptr<const FunctionExpression> Interpreter::parse_function() {
    const Spot where = here();
    take();
    return parse_function(where);
}

std::shared_ptr<const FunctionExpression> Interpreter::parse_function(Spot where) {
    const GuardScope no_guard(guard_, {});
    const Level level(*this);
    auto function = std::make_shared<FunctionExpression>();
    function->where = where;
    std::vector<NameId> parameters;
    if (accept(TokenKind::left_paren)) {
        while (!accept(TokenKind::right_paren)) {
            const Lookahead& ahead = peek();
            if (ahead.kind != TokenKind::name && ahead.kind != TokenKind::keyword) fail_expected("a parameter's name");
            parameters.push_back(ahead.payload);
            take();
            accept(TokenKind::comma);
        }
        if (parameters.empty() || parameters.size() > 56) fail(where, "a function takes 1 to 56 parameters");
    } else {
        parameters = {static_cast<NameId>(Keyword::x), static_cast<NameId>(Keyword::y),
                      static_cast<NameId>(Keyword::z)};
    }
    expect(TokenKind::left_brace, "before the function's body");
    const Lookahead& ahead = peek();
    const bool has_block = raw().kind() == TokenKind::left_brace;
    if (ahead.is(Keyword::internal)) {
        take();
        expect(TokenKind::left_paren, "after internal");
        function->kind = FunctionKind::internal;
        function->internal_number = static_cast<std::uint32_t>(std::clamp(parse_number(), 0.0, 1e6));
        expect(TokenKind::right_paren, "after the number of the internal function");
    } else if (ahead.is(Keyword::spline) && has_block) {
        function->kind = FunctionKind::spline;
        function->spline = parse_spline();
        if (function->spline->points.empty()) fail(where, "this spline has no points");
    } else if ((ahead.is(Keyword::pigment) || ahead.is(Keyword::pattern) || ahead.is(Keyword::transform)) &&
               has_block) {
        const auto keyword = static_cast<Keyword>(ahead.payload);
        function->kind = keyword == Keyword::pigment   ? FunctionKind::pigment
                         : keyword == Keyword::pattern ? FunctionKind::pattern
                                                       : FunctionKind::transform;
        const Spot block_place = here();
        take();
        function->block = parse_block(keyword, block_place);
    } else {
        FunctionParser(*this, *function, parameters).run();
    }
    expect(TokenKind::right_brace, "after the function's body");
    return function;
}

}  // namespace sundog::pov
