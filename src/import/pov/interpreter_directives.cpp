// SPDX-License-Identifier: Apache-2.0
// Directives (manual, 3.3.2), but for #declare and those for files.
#include <algorithm>

#include "import/pov/interpreter_core.h"

namespace sundog::pov {

void Interpreter::run_directive() {
    const GuardScope no_guard(guard_, {});
    Frame& frame = frames_.back();
    const std::uint32_t slot = frame.position;
    const auto directive = static_cast<Keyword>(frame.file->tokens[slot].payload());
    const Spot where{frame.file, frame.file->tokens[slot].offset};
    frame.position += 2;
    switch (directive) {
        case Keyword::declare:
            return run_declare(false);
        case Keyword::local:
            return run_declare(true);
        case Keyword::undef:
            return run_undef();
        case Keyword::if_:
        case Keyword::ifdef:
        case Keyword::ifndef:
            return run_if(slot);
        case Keyword::else_:
        case Keyword::elseif:
            return run_else(slot);
        case Keyword::while_:
            return run_while(slot);
        case Keyword::for_:
            return run_for(slot);
        case Keyword::switch_:
            return run_switch(slot);
        case Keyword::case_:
        case Keyword::range:
            return run_clause(slot);
        case Keyword::end:
            return run_end();
        case Keyword::break_:
            return run_break(where);
        case Keyword::macro:
            return run_macro(slot);
        case Keyword::include:
            return run_include();
        case Keyword::version:
            return run_version();
        case Keyword::default_:
            return run_default(where);
        case Keyword::debug:
        case Keyword::warning:
        case Keyword::error:
        case Keyword::render:
        case Keyword::statistics:
            return run_message(directive);
        case Keyword::fopen:
            return run_fopen();
        case Keyword::fclose:
            return run_fclose();
        case Keyword::read:
            return run_read();
        case Keyword::write:
            return run_write();
        default:
            fail(where, "'#" + std::string(spelling(directive)) + "' is no directive");
    }
}

std::uint32_t Interpreter::next_part(std::uint32_t slot) const {
    const TokenFile& file = *frames_.back().file;
    const std::uint32_t next = file.link(slot);
    if (next == 0)
        fail(file.place(file.tokens[slot].offset),
             "this #" + std::string(spelling(static_cast<Keyword>(file.tokens[slot].payload()))) + " has no #end");
    return next;
}

std::uint32_t Interpreter::end_of(std::uint32_t slot) const {
    const TokenFile& file = *frames_.back().file;
    while (static_cast<Keyword>(file.tokens[slot].payload()) != Keyword::end) slot = next_part(slot);
    return slot;
}

void Interpreter::open_conditional(Keyword kind, std::uint32_t slot) {
    if (conditionals_.size() >= 10000) fail(raw_place(), "more than 10000 conditionals within each other");
    Conditional conditional;
    conditional.kind = kind;
    conditional.slot = slot;
    conditional.frame = frames_.size();
    conditionals_.push_back(conditional);
}

Interpreter::Conditional& Interpreter::innermost(std::string_view directive) {
    if (conditionals_.empty() || conditionals_.back().frame != frames_.size())
        fail(raw_place(), std::string(directive) + " without a conditional or loop that it belongs to");
    return conditionals_.back();
}

double Interpreter::parenthesised_number() {
    expect(TokenKind::left_paren, "after the directive");
    const Value value = parse_full();
    expect(TokenKind::right_paren, "after the condition");
    return value.v[0];
}

bool Interpreter::condition() { return is_true(parenthesised_number()); }

void Interpreter::run_if(std::uint32_t slot) {
    const TokenFile& file = *frames_.back().file;
    for (auto part = static_cast<Keyword>(file.tokens[slot].payload());;) {
        bool holds = true;
        if (part == Keyword::ifdef || part == Keyword::ifndef) {
            expect(TokenKind::left_paren, "after the directive");
            holds = raw_is_defined() == (part == Keyword::ifdef);
            expect(TokenKind::right_paren, "after the identifier");
        } else if (part != Keyword::else_) {
            holds = condition();
        }
        if (holds) return open_conditional(Keyword::if_, slot);
        slot = next_part(slot);
        jump(slot + 2);
        part = static_cast<Keyword>(file.tokens[slot].payload());
        if (part == Keyword::end) return;
    }
}

void Interpreter::run_else(std::uint32_t slot) {
    const Conditional& conditional = innermost("#else");
    if (conditional.kind == Keyword::switch_) {
        conditionals_.back().matched = true;
        return;
    }
    // The part before it was the one to read: skip the others.
    jump(end_of(slot) + 2);
    conditionals_.pop_back();
}

void Interpreter::run_while(std::uint32_t slot) {
    if (condition()) return open_conditional(Keyword::while_, slot);
    jump(end_of(slot) + 2);
}

void Interpreter::run_for(std::uint32_t slot) {
    expect(TokenKind::left_paren, "after #for");
    const Spot where = raw_place();
    const NameId counter = raw_name("the loop's counter");
    expect(TokenKind::comma, "after the loop's counter");
    const double first = parse_number();
    expect(TokenKind::comma, "between start and end of the loop");
    const double last = parse_number();
    double step = 1;
    if (accept(TokenKind::comma)) step = parse_number();
    expect(TokenKind::right_paren, "after the loop's range");
    if (step == 0) fail(where, "a loop with a step of 0 never ends");
    identifiers_.declare_local(counter, identifiers_.level()) = number_value(first);
    if (step > 0 ? first > last + kEpsilon : first < last - kEpsilon) return jump(end_of(slot) + 2);
    open_conditional(Keyword::for_, slot);
    Conditional& loop = conditionals_.back();
    loop.counter = counter;
    loop.last = last;
    loop.step = step;
    loop.body = frames_.back().position;
}

void Interpreter::run_end() {
    Conditional& conditional = innermost("#end");
    if (conditional.kind == Keyword::while_) {
        jump(conditional.slot);
        conditionals_.pop_back();
        return;
    }
    if (conditional.kind != Keyword::for_) return conditionals_.pop_back();
    Entity* counter = identifiers_.find(conditional.counter);
    auto* value = counter == nullptr ? nullptr : std::get_if<Value>(counter);
    if (value == nullptr) fail(raw_place(), "the counter of this #for is no longer a float");
    value->v[0] += conditional.step;
    const double now = value->v[0];
    const bool goes_on = conditional.step > 0 ? now <= conditional.last + kEpsilon : now >= conditional.last - kEpsilon;
    if (goes_on) jump(conditional.body);
    else conditionals_.pop_back();
}

void Interpreter::run_switch(std::uint32_t slot) {
    const double value = parenthesised_number();
    open_conditional(Keyword::switch_, slot);
    conditionals_.back().value = value;
}

void Interpreter::run_clause(std::uint32_t slot) {
    const TokenFile& file = *frames_.back().file;
    if (innermost("#case").kind != Keyword::switch_) fail(raw_place(), "#case and #range belong into a #switch");
    for (;;) {
        const auto part = static_cast<Keyword>(file.tokens[slot].payload());
        jump(slot + 2);
        const std::size_t index = conditionals_.size() - 1;
        if (part == Keyword::end) return conditionals_.pop_back();
        bool holds = true;
        const double value = conditionals_[index].value;
        if (part == Keyword::range) {
            expect(TokenKind::left_paren, "after #range");
            const double low = parse_number();
            expect(TokenKind::comma, "between the numbers of #range");
            const double high = parse_number();
            expect(TokenKind::right_paren, "after the numbers of #range");
            holds = low - kEpsilon <= value && value <= high + kEpsilon;
        } else if (part == Keyword::case_) {
            holds = std::fabs(parenthesised_number() - value) < kEpsilon;
        }
        // Once a clause was read to its end without #break, the following ones are read whatever they say.
        if (holds || conditionals_[index].matched) {
            conditionals_[index].matched = true;
            return;
        }
        slot = next_part(slot);
    }
}

void Interpreter::run_break(Spot where) {
    while (!conditionals_.empty() && conditionals_.back().frame == frames_.size()) {
        const Conditional conditional = conditionals_.back();
        conditionals_.pop_back();
        if (conditional.kind == Keyword::if_) continue;
        return jump(end_of(conditional.slot) + 2);
    }
    if (!frames_.back().macro) fail(where, "#break outside of a loop, a #switch and a macro");
    frames_.back().position = frames_.back().end;
}

void Interpreter::run_macro(std::uint32_t slot) {
    auto macro = std::make_shared<Macro>();
    macro->file = frames_.back().file;
    const Spot where = raw_place();
    macro->name = raw_name("the macro's name");
    if (!accept_raw(TokenKind::left_paren)) fail(raw_place(), "expected '(' after the macro's name");
    while (!accept_raw(TokenKind::right_paren)) {
        macro->parameters.push_back(raw_name("a parameter's name or ')'"));
        accept_raw(TokenKind::comma);
    }
    macro->begin = frames_.back().position;
    macro->end = end_of(slot);
    if (macro->parameters.size() > 1000) fail(where, "a macro can't have more than 1000 parameters");
    jump(macro->end + 2);
    Entity& entity = identifiers_.declare(macro->name);
    entity = std::shared_ptr<const Macro>(std::move(macro));
}

void Interpreter::run_include() {
    const Spot where = raw_place();
    std::string name;
    if (const Lookahead& ahead = peek(); ahead.kind == TokenKind::string) {
        // A path of Windows has backslashes that begin no escape sequences: the name is taken as it stands.
        const std::string_view text = sources_.text(ahead.file->file).text.substr(ahead.offset + 1);
        name = text.substr(0, text.find('"'));
        take();
    } else {
        name = parse_string();
    }
    const std::filesystem::path path = find_file(name, where);
    enter_file(tokens_of(path, where));
}

void Interpreter::run_version() {
    // `#version unofficial MegaPov 1.1;` and the like speak of other programs' versions, which count as 3.7.
    bool unofficial = false;
    while (raw().kind() == TokenKind::name && names_.text(raw().payload()) != "version" &&
           identifiers_.find(raw().payload()) == nullptr) {
        unofficial = true;
        skip_raw();
    }
    const GuardScope guard(guard_, {true, frames_.size(), conditionals_.size()});
    const double version = parse_number();
    if (!unofficial) version_ = static_cast<std::uint16_t>(std::clamp(std::lround(version * 100), 100L, 999L));
    if (peek_operator().kind == TokenKind::semicolon || ahead_.kind == TokenKind::held) take();
}

void Interpreter::run_default(Spot where) {
    const std::shared_ptr<const Block> changes = parse_block(Keyword::default_, where);
    auto all =
        std::make_shared<Block>(defaults_ ? *defaults_ : Block{Keyword::default_, version_, where, 1, {}, nullptr});
    tick(all->items.size());
    all->items.insert(all->items.end(), changes->items.begin(), changes->items.end());
    all->depth = std::max(all->depth, changes->depth);
    defaults_ = std::move(all);
}

void Interpreter::run_message(Keyword kind) {
    const Spot where = raw_place();
    const std::string text = parse_string();
    if (kind == Keyword::error) fail(where, "the scene stops with #error: " + text);
    const PovStream stream = kind == Keyword::debug     ? PovStream::debug
                             : kind == Keyword::warning ? PovStream::warning
                             : kind == Keyword::render  ? PovStream::render
                                                        : PovStream::statistics;
    if (options_.print) options_.print(stream, text);
}

void Interpreter::run_undef() {
    const Spot where = raw_place();
    const NameId name = raw_name("the identifier to undefine");
    if (peek_raw_kind() == TokenKind::left_bracket) {
        const std::vector<std::size_t> path = parse_subscripts(name, where);
        element_at(name, path, where) = std::monostate{};
    } else if (!identifiers_.undefine(name)) {
        warn_once(where, "undef", "#undef of " + in_quotes(names_.text(name)) + ", which isn't declared");
    }
    accept_raw(TokenKind::semicolon);
}

}  // namespace sundog::pov
