// SPDX-License-Identifier: Apache-2.0
// #declare and #local (manual, 3.3.2.2), arrays (3.3.1.10) and splines (3.3.1.11).
#include <algorithm>

#include "import/pov/interpreter_core.h"
#include "import/pov/word_use.h"

namespace sundog::pov {

NameId Interpreter::raw_name(std::string_view what) {
    if (ahead_is_full_) {
        const Lookahead& ahead = peek();
        if (ahead.kind != TokenKind::name) fail_expected(what);
        take();
        return ahead_.payload;
    }
    const Token token = raw();
    const Spot where = raw_place();
    const bool is_word = token.kind() == TokenKind::keyword;
    if (is_word && !is_soft_keyword(static_cast<Keyword>(token.payload())))
        fail(where, in_quotes(names_.text(token.payload())) + " is a reserved word and can't be " + std::string(what),
             "names with a capital letter are never reserved");
    if (!is_word && token.kind() != TokenKind::name) fail_expected(what);
    skip_raw();
    return token.payload();
}

void Interpreter::run_declare(bool local) {
    std::string deprecated;
    bool once = false;
    if (raw().kind() == TokenKind::keyword && static_cast<Keyword>(raw().payload()) == Keyword::deprecated) {
        skip_raw();
        if (raw().kind() == TokenKind::keyword && static_cast<Keyword>(raw().payload()) == Keyword::once) {
            once = true;
            skip_raw();
        }
        if (raw().kind() == TokenKind::string) deprecated = parse_string();
        else deprecated = "\n";  // stands for the usual message, which needs the name
    }
    const Spot where = raw_place();
    const NameId name = raw_name("an identifier to declare");
    std::vector<std::size_t> path;
    if (peek_raw_kind() == TokenKind::left_bracket) path = parse_subscripts(name, where);
    expect(TokenKind::equals, "after the identifier");
    const std::uint32_t level = identifiers_.level();
    Entity value;
    {
        const GuardScope guard(guard_, {true, frames_.size(), conditionals_.size()});
        value = parse_rvalue();
        // Reads what is left of macros that gave the value, so that a #local is of this level and not of theirs.
        const TokenKind after = peek_operator().kind;
        if (after == TokenKind::semicolon || after == TokenKind::held) take();
        if (std::holds_alternative<Value>(value) && after != TokenKind::semicolon)
            warn_once(where, "semicolon", "this #declare of a number has no ';' at its end");
    }
    Entity& entity = !path.empty() ? element_at(name, path, where)
                     : local       ? identifiers_.declare_local(name, level)
                                   : identifiers_.declare(name);
    if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&value); inner != nullptr && !path.empty()) {
        Array& outer = *std::get<std::shared_ptr<Array>>(*identifiers_.find(name));
        outer.depth = std::max(outer.depth, (*inner)->depth + 1);
        check_depth(outer.depth, where);
    }
    entity = std::move(value);
    if (!deprecated.empty() && path.empty()) {
        if (deprecated == "\n")
            deprecated = "identifier " + std::string(names_.text(name)) + " was declared deprecated";
        has_deprecated_ = true;
        identifiers_.cell(name)->deprecated = std::move(deprecated);
        identifiers_.cell(name)->warn_once = once;
    }
}

Entity Interpreter::parse_rvalue() {
    const Level level(*this);
    if (starts_string()) return parse_string();
    const Spot where = here();
    if (ahead_.kind == TokenKind::name) {
        const NameId name = ahead_.payload;
        const Entity* found = identifiers_.find(name);
        if (found == nullptr) fail_undeclared(where, name);
        if (has_deprecated_) note_use(name, where);
        if (std::holds_alternative<Value>(*found)) return parse_value();
        Entity entity = *found;
        take();
        if (const auto* array = std::get_if<std::shared_ptr<Array>>(&entity);
            array != nullptr && peek_operator().kind == TokenKind::left_bracket)
            entity = element(std::shared_ptr<Array>(*array), name, where);
        const bool is_call = (std::holds_alternative<std::shared_ptr<const FunctionExpression>>(entity) ||
                              std::holds_alternative<std::shared_ptr<const Spline>>(entity)) &&
                             peek_operator().kind == TokenKind::left_paren;
        if (!is_call && !std::holds_alternative<Value>(entity)) return entity;
        pending_ = value_of_entity(entity, name, where);
        return parse_value();
    }
    if (ahead_.is(Keyword::array)) return parse_array();
    if (ahead_.is(Keyword::function)) return parse_function();
    if (ahead_.is(Keyword::spline)) return parse_spline();
    if (starts_expression()) return parse_value();
    if (ahead_.kind != TokenKind::keyword) fail_expected("a value to declare");
    BlockGroup group;
    const auto keyword = static_cast<Keyword>(ahead_.payload);
    do {
        take();
        group.push_back(parse_block(keyword, where));
        tick();
        // Textures one after the other are layers of one.
    } while (keyword == Keyword::texture && peek_operator().is(Keyword::texture));
    return group;
}

Entity Interpreter::parse_array() {
    const Spot where = here();
    take();
    auto array = std::make_shared<Array>();
    double count = 1;
    while (peek_operator().kind == TokenKind::left_bracket) {
        take();
        const double size = std::floor(parse_number() + kEpsilon);
        expect(TokenKind::right_bracket, "after the array's size");
        if (!(size >= 1)) fail(where, "an array needs at least one element in each dimension");
        count *= size;
        if (count * sizeof(Entity) > static_cast<double>(memory_limit_) || count > 4e9)
            fail(where, "an array of more elements than the limit of memory allows");
        array->sizes.push_back(static_cast<std::uint32_t>(size));
    }
    if (array->sizes.empty()) fail(where, "an array needs at least one dimension");
    tick(static_cast<std::uint64_t>(count / 16));
    array->elements.resize(static_cast<std::size_t>(count));
    if (peek_operator().kind == TokenKind::left_brace) {
        std::size_t next = 0;
        fill_array(*array, 0, next);
    }
    return array;
}

void Interpreter::fill_array(Array& array, std::size_t dimension, std::size_t& next) {
    const GuardScope no_guard(guard_, {});
    const Level level(*this);
    const Spot where = here();
    expect(TokenKind::left_brace, "around the array's elements");
    std::size_t below = 1;
    for (std::size_t i = dimension + 1; i < array.sizes.size(); ++i) below *= array.sizes[i];
    const std::size_t end = next + below * array.sizes[dimension];
    while (!accept(TokenKind::right_brace)) {
        if (next >= end)
            fail(where, "more elements than the array's size of " + std::to_string(array.sizes[dimension]));
        if (dimension + 1 < array.sizes.size()) {
            fill_array(array, dimension + 1, next);
        } else {
            Entity value = parse_rvalue();
            if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&value)) {
                array.depth = std::max(array.depth, (*inner)->depth + 1);
                check_depth(array.depth, where);
            }
            array.elements[next++] = std::move(value);
        }
        accept(TokenKind::comma);
    }
    next = end;
}

std::size_t Interpreter::element_index(const Array& array, NameId name, Spot where) {
    const GuardScope no_guard(guard_, {});
    std::size_t index = 0;
    for (const std::uint32_t size : array.sizes) {
        expect(TokenKind::left_bracket, "for each dimension of the array ", names_.text(name));
        const double subscript = std::trunc(parse_number() + kEpsilon);
        if (!(subscript >= 0) || subscript >= size)
            fail(where, "element " + std::to_string(static_cast<long long>(std::clamp(subscript, -1e15, 1e15))) +
                            " of the array " + std::string(names_.text(name)) + ", which has elements 0 to " +
                            std::to_string(size - 1));
        index = index * size + static_cast<std::size_t>(subscript);
        expect(TokenKind::right_bracket, "after the subscript");
    }
    return index;
}

std::vector<std::size_t> Interpreter::parse_subscripts(NameId name, Spot where) {
    const Entity* found = identifiers_.find(name);
    if (found == nullptr) fail_undeclared(where, name);
    Entity entity = *found;
    std::vector<std::size_t> path;
    do {
        const auto* array = std::get_if<std::shared_ptr<Array>>(&entity);
        if (array == nullptr)
            fail(where, std::string(names_.text(name)) + " is " + describe(entity) + ", not an array");
        const std::shared_ptr<Array> kept = *array;
        path.push_back(element_index(*kept, name, where));
        entity = kept->elements[path.back()];
    } while (peek_raw_kind() == TokenKind::left_bracket);
    return path;
}

Entity& Interpreter::element_at(NameId name, const std::vector<std::size_t>& path, Spot where) {
    Entity* entity = identifiers_.find(name);
    for (const std::size_t index : path) {
        auto* array = entity == nullptr ? nullptr : std::get_if<std::shared_ptr<Array>>(entity);
        if (array == nullptr || index >= (*array)->elements.size())
            fail(where, "the array " + std::string(names_.text(name)) + " changed while its element was worked out");
        entity = &own_array(*array).elements[index];
    }
    return *entity;
}

Entity Interpreter::element(const std::shared_ptr<Array>& array, NameId name, Spot where) {
    Entity value = array->elements[element_index(*array, name, where)];
    while (std::holds_alternative<std::shared_ptr<Array>>(value) && peek_raw_kind() == TokenKind::left_bracket) {
        const std::shared_ptr<Array> inner = std::get<std::shared_ptr<Array>>(value);
        value = inner->elements[element_index(*inner, name, where)];
    }
    if (value.index() == 0)
        fail(where, "this element of the array " + std::string(names_.text(name)) + " has no value yet");
    return value;
}

bool Interpreter::raw_is_defined() {
    // Keywords are allowed, and not defined as identifiers are.
    if (!ahead_is_full_ && raw().kind() == TokenKind::keyword &&
        !is_soft_keyword(static_cast<Keyword>(raw().payload()))) {
        skip_raw();
        return true;
    }
    const Spot where = raw_place();
    const NameId name = raw_name("an identifier");
    const Entity* entity = identifiers_.find(name);
    if (peek_raw_kind() != TokenKind::left_bracket) return entity != nullptr;
    if (entity == nullptr) {
        // Subscripts of nothing are skipped unread.
        int open = 0;
        do {
            if (raw().kind() == TokenKind::left_bracket) ++open;
            if (raw().kind() == TokenKind::right_bracket) --open;
            if (raw().kind() == TokenKind::end || raw().kind() == TokenKind::directive) fail(where, "expected ']'");
            skip_raw();
        } while (open > 0 || raw().kind() == TokenKind::left_bracket);
        return false;
    }
    const std::vector<std::size_t> path = parse_subscripts(name, where);
    return element_at(name, path, where).index() != 0;
}

std::shared_ptr<const Spline> Interpreter::parse_spline() {
    take();
    const GuardScope no_guard(guard_, {});
    expect(TokenKind::left_brace, "after spline");
    Spline spline;
    while (!accept(TokenKind::right_brace)) {
        if (accept(TokenKind::comma)) continue;
        const Lookahead& ahead = peek();
        if (const auto kind =
                ahead.kind == TokenKind::keyword ? spline_kind(static_cast<Keyword>(ahead.payload)) : std::nullopt) {
            spline.kind = *kind;
            take();
            continue;
        }
        if (ahead.kind == TokenKind::name) {
            const Entity* entity = identifiers_.find(ahead.payload);
            if (const auto* other = entity == nullptr ? nullptr : std::get_if<std::shared_ptr<const Spline>>(entity)) {
                const std::shared_ptr<const Spline> kept = *other;
                take();
                if (peek().kind != TokenKind::left_paren) {
                    spline = *kept;
                    continue;
                }
                pending_ = call_spline(*kept, here());
            }
        }
        const double parameter = parse_number();
        accept(TokenKind::comma);
        insert_point(spline, parameter, parse_expression());
        tick(spline.points.size() / 64);
    }
    natural_second_derivatives(spline);
    return std::make_shared<const Spline>(std::move(spline));
}

void Interpreter::check_depth(std::uint32_t depth, Place where) const {
    if (depth > kNestingLimit)
        fail(where, "more than " + std::to_string(kNestingLimit) + " levels of things made of things",
             "the limit of nesting");
}

}  // namespace sundog::pov
