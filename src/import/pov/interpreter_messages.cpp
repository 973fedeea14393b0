// SPDX-License-Identifier: Apache-2.0
// What the interpreter says about the place where it is.
#include "import/pov/interpreter_core.h"

namespace sundog::pov {

void Interpreter::fail(Place where, std::string message, std::string hint) const {
    sources_.fail(where, std::move(message), std::move(hint));
}

std::string Interpreter::describe_ahead() {
    const Lookahead& ahead = peek_operator();
    switch (ahead.kind) {
        case TokenKind::end:
            return "the end of the file";
        case TokenKind::string:
            return "a string";
        case TokenKind::held:
            return "a directive";
        case TokenKind::list:
            return "a list of numbers";
        default:
            break;
    }
    // The token's own text, as far as it is one word or sign.
    const std::string_view text = sources_.text(ahead.file->file).text.substr(ahead.offset);
    const auto is_word = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
    };
    std::size_t length = 0;
    while (length < text.size() && is_word(text[length])) ++length;
    std::string quoted = in_quotes(text.substr(0, std::max<std::size_t>(length, 1)));
    if (ahead.kind != TokenKind::name) return quoted;
    const Entity* entity = identifiers_.find(ahead.payload);
    return entity == nullptr ? "the undeclared identifier " + quoted : quoted + ", which is " + describe(*entity);
}

void Interpreter::fail_expected(std::string_view expected) {
    if (const Lookahead& ahead = peek_operator();
        ahead.kind == TokenKind::name && identifiers_.find(ahead.payload) == nullptr)
        fail_undeclared(here(), ahead.payload);
    const Spot where = here();
    fail(where, "expected " + std::string(expected) + ", found " + describe_ahead());
}

void Interpreter::fail_undeclared(Place where, NameId name) const {
    std::vector<std::string_view> valid;
    for (const NameId declared : identifiers_.declared()) valid.push_back(names_.text(declared));
    for (const std::string_view word : keyword_spellings()) valid.push_back(word);
    const std::vector<std::string> near = nearest_names(names_.text(name), valid);
    fail(where, "undeclared identifier " + in_quotes(names_.text(name)),
         near.empty() ? "is an #include missing?" : suggest(names_.text(name), valid));
}

void Interpreter::warn(Place where, std::string message, std::string hint) {
    if (warn_) warn_(sources_.diagnose(Severity::warning, where, std::move(message), std::move(hint)));
}

void Interpreter::warn_once(Place where, const std::string& kind, std::string message, std::string hint) {
    if (warned_.insert(kind).second) warn(where, std::move(message), std::move(hint));
}

void Interpreter::note_use(NameId name, Place where) {
    Identifiers::Cell* cell = identifiers_.cell(name);
    if (cell == nullptr || cell->deprecated.empty()) return;
    if (cell->warn_once) warn_once(where, "deprecated " + std::string(names_.text(name)), cell->deprecated);
    else warn(where, cell->deprecated);
}

}  // namespace sundog::pov
