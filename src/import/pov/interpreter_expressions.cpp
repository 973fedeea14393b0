// SPDX-License-Identifier: Apache-2.0
// Expressions (manual, 3.3.1.5 to 3.3.1.7). Comparisons, & and | and ?: are read in parentheses only, since `<` begins
// a vector elsewhere.
#include <cmath>

#include "import/pov/interpreter_core.h"
#include "import/pov/word_use.h"

namespace sundog::pov {

bool Interpreter::starts_string() {
    const Lookahead& ahead = peek();
    if (ahead.kind == TokenKind::string) return true;
    if (ahead.kind == TokenKind::keyword) return word_use(static_cast<Keyword>(ahead.payload)) == WordUse::string;
    if (ahead.kind != TokenKind::name) return false;
    const Entity* entity = identifiers_.find(ahead.payload);
    if (entity == nullptr) return false;
    if (std::holds_alternative<std::string>(*entity)) return true;
    // Arrays are of one kind, so any element that has a value tells.
    const auto* array = std::get_if<std::shared_ptr<Array>>(entity);
    if (array == nullptr || raw().kind() != TokenKind::left_bracket) return false;
    for (const Entity& element : (*array)->elements)
        if (element.index() != 0) return std::holds_alternative<std::string>(element);
    return false;
}

bool Interpreter::starts_expression() {
    if (pending_) return true;
    const Lookahead& ahead = peek();
    switch (ahead.kind) {
        case TokenKind::number:
        case TokenKind::left_paren:
        case TokenKind::left_angle:
        case TokenKind::plus:
        case TokenKind::minus:
        case TokenKind::exclamation:
            return true;
        case TokenKind::keyword: {
            const WordUse use = word_use(static_cast<Keyword>(ahead.payload));
            return use != WordUse::statement && use != WordUse::string;
        }
        case TokenKind::name: {
            const Entity* entity = identifiers_.find(ahead.payload);
            return entity != nullptr && (std::holds_alternative<Value>(*entity) ||
                                         std::holds_alternative<std::shared_ptr<const FunctionExpression>>(*entity) ||
                                         std::holds_alternative<std::shared_ptr<const Spline>>(*entity) ||
                                         (std::holds_alternative<std::shared_ptr<Array>>(*entity) && !starts_string()));
        }
        default:
            return false;
    }
}

double Interpreter::parse_number() {
    const Spot where = here();
    const Value value = parse_expression();
    if (value.count != 1 && !value.is_color) {
        fail(where, "expected a float, found a vector of " + std::to_string(value.count) + " components");
    }
    return value.v[0];
}

Value Interpreter::parse_value() {
    Value value = parse_expression();
    // `[0.2 green 0.3]` of a map: a number, and a colour by itself.
    const bool plain_number = value.count == 1 && !value.is_color;
    if (!plain_number && at_color_word()) {
        if (!value.is_color) {
            // `<0.2, 0.4, 0.6> transmit 0.5`: a colour without its keyword.
            value = promoted(value, kColorComponents);
            value.is_color = true;
        }
        parse_color_words(value);
    }
    return value;
}

bool Interpreter::at_color_word() {
    const Lookahead& ahead = peek_operator();
    return ahead.kind == TokenKind::keyword && word_use(static_cast<Keyword>(ahead.payload)) == WordUse::color_word;
}

void Interpreter::parse_color_words(Value& color) {
    while (at_color_word()) {
        const auto word = static_cast<Keyword>(ahead_.payload);
        take();
        const double amount = parse_expression().v[0];
        // `alpha` is what filter was called before version 2.
        color.v[word == Keyword::alpha ? 3 : *component_of(word)] = amount;
    }
}

Value Interpreter::parse_expression() {
    Value left = parse_term();
    for (;;) {
        const TokenKind kind = peek_operator().kind;
        if (kind == TokenKind::plus) {
            take();
            left = combined(left, parse_term(), [](double a, double b) { return a + b; });
        } else if (kind == TokenKind::minus) {
            take();
            left = combined(left, parse_term(), [](double a, double b) { return a - b; });
        } else {
            return left;
        }
    }
}

Value Interpreter::parse_term() {
    Value left = parse_factor();
    for (;;) {
        const TokenKind kind = peek_operator().kind;
        if (kind == TokenKind::star) {
            take();
            left = combined(left, parse_factor(), [](double a, double b) { return a * b; });
        } else if (kind == TokenKind::slash) {
            const Spot where = here();
            take();
            const Value right = parse_factor();
            for (std::uint8_t i = 0; i < right.count; ++i)
                if (right.v[i] == 0 && (i < left.count || left.count == 1)) {
                    warn_once(where, "division", "division by zero");
                    break;
                }
            left = combined(left, right, [](double a, double b) { return b == 0 ? HUGE_VAL : a / b; });
        } else {
            return left;
        }
    }
}

Value Interpreter::parse_factor() {
    if (pending_) {
        const Value value = *pending_;
        pending_.reset();
        return parse_components(value);
    }
    switch (const Lookahead& ahead = peek(); ahead.kind) {
        case TokenKind::number: {
            const double number = ahead.number;
            take();
            return number_value(number);
        }
        case TokenKind::left_angle:
            return parse_components(parse_vector());
        case TokenKind::name:
            return parse_name_factor();
        case TokenKind::keyword:
            return parse_keyword_factor();
        case TokenKind::minus: {
            const Level level(*this);
            take();
            return each_component(parse_factor(), [](double a) { return -a; });
        }
        case TokenKind::plus: {
            const Level level(*this);
            take();
            return parse_factor();
        }
        case TokenKind::exclamation: {
            const Level level(*this);
            take();
            return each_component(parse_factor(), [](double a) { return is_true(a) ? 0.0 : 1.0; });
        }
        case TokenKind::left_paren: {
            const Level level(*this);
            take();
            const Value value = parse_full();
            expect(TokenKind::right_paren, "to close the parenthesis");
            return parse_components(value);
        }
        default:
            fail_expected("a number, a vector or a colour");
    }
}

Value Interpreter::parse_full() {
    Value left = parse_relation();
    for (;;) {
        const TokenKind kind = peek_operator().kind;
        if (kind != TokenKind::ampersand && kind != TokenKind::bar) break;
        take();
        const Value right = parse_relation();
        if (kind == TokenKind::ampersand)
            left = combined(left, right, [](double a, double b) { return is_true(a) && is_true(b) ? 1.0 : 0.0; });
        else left = combined(left, right, [](double a, double b) { return is_true(a) || is_true(b) ? 1.0 : 0.0; });
    }
    if (peek_operator().kind != TokenKind::question) return left;
    const Level level(*this);
    take();
    const Value if_true = parse_full();
    expect(TokenKind::colon, "between the two values of ?:");
    const Value if_false = parse_full();
    return is_true(left.v[0]) ? if_true : if_false;
}

namespace {

/// Compares as the operator says: < and > exactly, the others with `epsilon`, which is 0 for the outcome of strcmp.
double compared(TokenKind kind, double a, double b, double epsilon) {
    switch (kind) {
        case TokenKind::left_angle:
            return a < b ? 1 : 0;
        case TokenKind::less_equal:
            return a <= b + epsilon ? 1 : 0;
        case TokenKind::equals:
            return std::fabs(a - b) <= epsilon || a == b ? 1 : 0;
        case TokenKind::not_equal:
            return std::fabs(a - b) > epsilon ? 1 : 0;
        case TokenKind::greater_equal:
            return a >= b - epsilon ? 1 : 0;
        default:
            return a > b ? 1 : 0;
    }
}

bool is_relation(TokenKind kind) {
    return kind == TokenKind::left_angle || kind == TokenKind::less_equal || kind == TokenKind::equals ||
           kind == TokenKind::not_equal || kind == TokenKind::greater_equal || kind == TokenKind::right_angle;
}

}  // namespace

Value Interpreter::parse_relation() {
    if (!pending_ && starts_string()) return parse_string_relation();
    Value left = parse_expression();
    for (;;) {
        const TokenKind kind = peek_operator().kind;
        if (!is_relation(kind)) return left;
        take();
        left =
            combined(left, parse_expression(), [kind](double a, double b) { return compared(kind, a, b, kEpsilon); });
    }
}

Value Interpreter::parse_string_relation() {
    const std::string left = parse_string();
    const TokenKind kind = peek_operator().kind;
    if (!is_relation(kind)) fail_expected("a comparison of the string");
    take();
    const std::string right = parse_string();
    return number_value(compared(kind, left.compare(right), 0, 0));
}

/// The common case: `<1, -2.5, 3>` without anything to work out, straight from the tokens behind the `<`.
bool Interpreter::parse_literal_vector(Value& value) {
    Frame& frame = frames_.back();
    const TokenFile& file = *frame.file;
    std::uint32_t slot = frame.position;
    for (std::uint8_t count = 0; count < 5; ++count) {
        bool negative = false;
        if (file.tokens[slot].kind() == TokenKind::minus) negative = true, ++slot;
        if (file.tokens[slot].kind() != TokenKind::number) return false;
        const double number = file.number(slot);
        value.v[count] = negative ? -number : number;
        slot += 2;
        const TokenKind after = file.tokens[slot++].kind();
        if (after == TokenKind::right_angle && count > 0) {
            value.count = static_cast<std::uint8_t>(count + 1);
            frame.position = slot;
            tick(count);
            return true;
        }
        if (after != TokenKind::comma) return false;
    }
    return false;
}

Value Interpreter::parse_vector() {
    Value value;
    const Spot where = here();
    take();
    if (parse_literal_vector(value)) return value;
    const Level level(*this);
    const GuardScope no_guard(guard_, {});
    value = Value{};
    value.count = 0;
    while (peek().kind != TokenKind::right_angle) {
        if (value.count == 5) fail(where, "a vector has at most 5 components");
        value.v[value.count++] = parse_number();
        accept(TokenKind::comma);
    }
    take();
    if (value.count == 0) fail(where, "a vector needs components");
    return value;
}

Value Interpreter::parse_components(Value value) {
    while (peek_operator().kind == TokenKind::dot) {
        take();
        const Lookahead& ahead = peek();
        const auto index =
            ahead.kind == TokenKind::keyword ? component_of(static_cast<Keyword>(ahead.payload)) : std::nullopt;
        if (!index) fail_expected("a component (x, y, z, t, u, v, red, green, blue, filter, transmit or gray)");
        // Beyond a vector's own components are zeros; a float stands for all of them.
        take();
        value = number_value(component(promoted(value, kColorComponents), *index));
    }
    return value;
}

Value Interpreter::parse_name_factor() {
    const NameId name = ahead_.payload;
    const Entity* entity = identifiers_.find(name);
    if (entity == nullptr) fail_undeclared(here(), name);
    if (has_deprecated_) note_use(name, here());
    if (const auto* value = std::get_if<Value>(entity)) {
        const Value copy = *value;
        take();
        return parse_components(copy);
    }
    const Spot where = here();
    take();
    return parse_components(value_of_entity(Entity(*entity), name, where));
}

Value Interpreter::value_of_entity(const Entity& entity, NameId name, Spot where) {
    if (const auto* value = std::get_if<Value>(&entity)) return *value;
    if (const auto* array = std::get_if<std::shared_ptr<Array>>(&entity))
        if (peek_operator().kind == TokenKind::left_bracket)
            return value_of_entity(element(*array, name, where), name, where);
    if (const auto* function = std::get_if<std::shared_ptr<const FunctionExpression>>(&entity))
        if (peek_operator().kind == TokenKind::left_paren) return call_function(*function, where);
    if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(&entity))
        if (peek_operator().kind == TokenKind::left_paren) return call_spline(**spline, where);
    fail(where, "expected a number, a vector or a colour, found " + in_quotes(names_.text(name)) + ", which is " +
                    describe(entity));
}

Value Interpreter::parse_keyword_factor() {
    const auto keyword = static_cast<Keyword>(ahead_.payload);
    switch (word_use(keyword)) {
        case WordUse::constant: {
            take();
            return parse_components(constant_of(keyword));
        }
        case WordUse::color:
            return parse_color_form(keyword);
        case WordUse::color_word: {
            Value color;
            color.count = kColorComponents;
            color.is_color = true;
            parse_color_words(color);
            return color;
        }
        case WordUse::number_function:
        case WordUse::aggregate:
        case WordUse::of_names:
        case WordUse::of_strings:
        case WordUse::geometry: {
            const Spot where = here();
            const Level level(*this);
            take();
            const WordUse use = word_use(keyword);
            return parse_components(use == WordUse::number_function ? call_builtin(keyword, where)
                                    : use == WordUse::aggregate     ? call_aggregate(keyword, where)
                                    : use == WordUse::of_names      ? call_of_names(keyword, where)
                                    : use == WordUse::of_strings    ? call_of_strings(keyword, where)
                                                                    : call_geometry(keyword, where));
        }
        default:
            fail_expected("a number, a vector or a colour");
    }
}

Value Interpreter::parse_color_form(Keyword form) {
    const Spot where = here();
    const Level level(*this);
    take();
    Value value = parse_expression();
    if (form == Keyword::color) {
        value = promoted(value, kColorComponents);
        value.is_color = true;
        parse_color_words(value);
        return value;
    }
    const auto is_transparent =
        form == Keyword::rgbf || form == Keyword::rgbt || form == Keyword::srgbf || form == Keyword::srgbt;
    if (value.count > (is_transparent ? 4 : 3) && !value.is_color && form != Keyword::rgbft && form != Keyword::srgbft)
        warn_once(where, "long color",
                  std::string(spelling(form)) + " with a vector of " + std::to_string(value.count) + " components");
    return color_of(form, value, assumed_gamma_);
}

Value Interpreter::constant_of(Keyword keyword) {
    const auto axis = [](std::size_t index, std::uint8_t count) {
        Value value;
        value.v[index] = 1;
        value.count = count;
        return value;
    };
    const PovClock& clock = options_.clock;
    switch (keyword) {
        case Keyword::x:
            return axis(0, 3);
        case Keyword::y:
            return axis(1, 3);
        case Keyword::z:
            return axis(2, 3);
        case Keyword::u:
            return axis(0, 2);
        case Keyword::v:
            return axis(1, 2);
        case Keyword::t:
            return axis(3, 4);
        case Keyword::pi:
            return number_value(M_PI);
        case Keyword::tau:
            return number_value(2 * M_PI);
        case Keyword::on:
        case Keyword::yes:
        case Keyword::true_:
            return number_value(1);
        case Keyword::clock:
            return number_value(clock.clock);
        case Keyword::clock_delta:
            return number_value(clock.clock_delta);
        case Keyword::clock_on:
            return number_value(clock.clock_on ? 1 : 0);
        case Keyword::frame_number:
            return number_value(clock.frame_number);
        case Keyword::initial_frame:
            return number_value(clock.initial_frame);
        case Keyword::final_frame:
            return number_value(clock.final_frame);
        case Keyword::initial_clock:
            return number_value(clock.initial_clock);
        case Keyword::final_clock:
            return number_value(clock.final_clock);
        case Keyword::image_width:
            return number_value(options_.width);
        case Keyword::image_height:
            return number_value(options_.height);
        case Keyword::version:
            return number_value(version_ / 100.0);
        case Keyword::now:
            return number_value(days_since_2000());
        default:
            return number_value(0);
    }
}

}  // namespace sundog::pov
