// SPDX-License-Identifier: Apache-2.0
// The stream of tokens: files, includes and macros, one after the other and within each other.
#include <algorithm>
#include <cstdio>
#include <fstream>

#ifdef __linux__
#include <unistd.h>
#endif

#include "base/text_file.h"
#include "import/pov/interpreter_core.h"

namespace sundog::pov {
namespace {

/// What the process takes, and the machine's memory; 0 where the system doesn't tell.
std::uint64_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t pages = 0, resident = 0;
    return statm >> pages >> resident ? resident * 4096 : 0;
}

std::uint64_t machine_bytes() {
#ifdef __linux__
    return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE));
#else
    return 0;
#endif
}

}  // namespace

Interpreter::Level::Level(Interpreter& interpreter) : depth_(interpreter.depth_) {
    if (depth_ >= kNestingLimit)
        interpreter.fail(interpreter.here(),
                         "more than " + std::to_string(kNestingLimit) + " brackets within each other",
                         "the limit of nesting");
    ++depth_;
}

Interpreter::Interpreter(const PovOptions& options, std::filesystem::path scene_folder, SourceFiles& sources,
                         BlockSink& sink, GeometryQueries* queries, const WarningSink& warn)
    : options_(options),
      sources_(sources),
      sink_(sink),
      queries_(queries),
      function_calls_(queries),
      warn_(warn),
      finder_(scene_folder, options),
      scene_folder_(std::move(scene_folder)),
      steps_left_(options.limits.steps),
      memory_limit_(options.limits.memory_bytes != 0 ? options.limits.memory_bytes : machine_bytes() / 2),
      memory_at_start_(resident_bytes()),
      version_(options.version) {
    for (const PovDeclaration& declaration : options.declarations) {
        Entity& entity = identifiers_.declare(names_.intern(declaration.name));
        if (const auto* number = std::get_if<double>(&declaration.value)) entity = number_value(*number);
        else entity = std::get<std::string>(declaration.value);
    }
}

void Interpreter::run(const std::filesystem::path& path, const SourceText& source) {
    input_file_name_ = path.filename().string();
    const std::uint32_t file = sources_.add(path, source);
    token_files_.push_back(tokenise(file, path, source, names_));
    enter_file(*token_files_.back());
    if (!options_.include_header.empty()) enter_file(tokens_of(options_.include_header, {}));
    run_scene();
}

void Interpreter::enter_file(const TokenFile& file) {
    if (files_open_ > options_.limits.depth)
        fail(raw_place(), "more than " + std::to_string(options_.limits.depth) + " include files within each other",
             "the limit of depth");
    ++files_open_;
    // The main file's level is the global one.
    if (!frames_.empty()) identifiers_.enter_level();
    frames_.push_back({&file, 0, static_cast<std::uint32_t>(file.tokens.size() - 1), conditionals_.size(), nullptr});
}

bool Interpreter::leave_frame() {
    const Frame& frame = frames_.back();
    if (conditionals_.size() > frame.conditionals) {
        const Conditional& open = conditionals_.back();
        fail(frame.file->place(frame.file->tokens[open.slot].offset),
             "this #" + std::string(spelling(open.kind)) + " has no #end");
    }
    if (frames_.size() == 1) return false;
    if (!frame.macro) --files_open_;
    identifiers_.leave_level();
    frames_.pop_back();
    return true;
}

void Interpreter::out_of_steps() {
    fail(raw_place(), "the scene takes more than " + std::to_string(options_.limits.steps) + " steps to read",
         "a loop may never end; the limit of steps can be raised");
}

void Interpreter::check_memory() {
    const std::uint64_t now = resident_bytes();
    if (memory_limit_ == 0 || now < memory_at_start_ || now - memory_at_start_ <= memory_limit_) return;
    fail(raw_place(), "the scene takes more than " + std::to_string(memory_limit_ >> 20U) + " MiB of memory to read",
         "the limit of memory can be raised");
}

Token Interpreter::raw() const {
    const Frame& frame = frames_.back();
    return frame.position < frame.end ? frame.file->tokens[frame.position] : Token{};
}

void Interpreter::skip_raw() {
    if (Frame& frame = frames_.back(); frame.position < frame.end)
        frame.position += slots_of(frame.file->tokens[frame.position].kind());
}

bool Interpreter::accept_raw(TokenKind kind) {
    if (frames_.back().position >= frames_.back().end || raw().kind() != kind) return false;
    skip_raw();
    return true;
}

bool Interpreter::holds_back(const Frame& frame, const Token& token) const {
    if (frames_.size() > guard_.frames || frame.macro != frames_[guard_.frames - 1].macro) return false;
    switch (static_cast<Keyword>(token.payload())) {
        // The parts of a conditional within the declaration's value belong to it.
        case Keyword::else_:
        case Keyword::elseif:
        case Keyword::case_:
        case Keyword::range:
        case Keyword::break_:
        case Keyword::end:
            return conditionals_.size() <= guard_.conditionals;
        default:
            return true;
    }
}

void Interpreter::fetch(bool respect_guard) {
    const auto hold_back = [&] {
        ahead_.kind = TokenKind::held;
        ahead_is_full_ = true;
    };
    while (!ahead_is_full_) {
        tick();
        Frame& frame = frames_.back();
        ahead_.file = frame.file;
        ahead_.slot = frame.position;
        if (frame.position >= frame.end) {
            if (respect_guard && frames_.size() <= guard_.frames) return hold_back();
            ahead_.offset = frame.file->tokens[frame.position].offset;
            if (leave_frame()) continue;
            ahead_.kind = TokenKind::end;
            ahead_is_full_ = true;
            return;
        }
        const Token token = frame.file->tokens[frame.position];
        ahead_.offset = token.offset;
        ahead_.payload = token.payload();
        ahead_.kind = token.kind();
        switch (ahead_.kind) {
            case TokenKind::number:
                ahead_.number = frame.file->number(frame.position);
                frame.position += 2;
                break;
            case TokenKind::directive:
                if (respect_guard && holds_back(frame, token)) return hold_back();
                run_directive();
                continue;
            case TokenKind::bad:
                fail(frame.file->place(token.offset), frame.file->errors[token.payload()]);
            case TokenKind::keyword:
                ++frame.position;
                if (is_soft_keyword(static_cast<Keyword>(ahead_.payload)) &&
                    identifiers_.find(ahead_.payload) != nullptr)
                    ahead_.kind = TokenKind::name;
                break;
            case TokenKind::name: {
                const Entity* entity = identifiers_.find(ahead_.payload);
                const auto* macro = entity == nullptr ? nullptr : std::get_if<std::shared_ptr<const Macro>>(entity);
                if (macro != nullptr) {
                    if (respect_guard && frames_.size() == guard_.frames) return hold_back();
                    ++frame.position;
                    const std::shared_ptr<const Macro> kept = *macro;
                    invoke(kept, {frame.file, token.offset});
                    continue;
                }
                ++frame.position;
                break;
            }
            default:
                ++frame.position;
                break;
        }
        ahead_is_full_ = true;
    }
}

void Interpreter::fail_missing(TokenKind kind, std::string_view context, std::string_view word) {
    const char symbol = kind == TokenKind::left_brace      ? '{'
                        : kind == TokenKind::right_brace   ? '}'
                        : kind == TokenKind::left_paren    ? '('
                        : kind == TokenKind::right_paren   ? ')'
                        : kind == TokenKind::left_bracket  ? '['
                        : kind == TokenKind::right_bracket ? ']'
                        : kind == TokenKind::right_angle   ? '>'
                        : kind == TokenKind::equals        ? '='
                        : kind == TokenKind::colon         ? ':'
                        : kind == TokenKind::comma         ? ','
                                                           : '?';
    fail_expected("'" + std::string(1, symbol) + "' " + std::string(context) + std::string(word));
}

void Interpreter::invoke(const std::shared_ptr<const Macro>& macro, Spot where) {
    if (frames_.size() - files_open_ >= options_.limits.depth)
        fail(where, "more than " + std::to_string(options_.limits.depth) + " macros within each other",
             "a macro may call itself without end; the limit of depth can be raised");
    const GuardScope no_guard(guard_, {});
    const std::string_view name = names_.text(macro->name);
    expect(TokenKind::left_paren, "after the macro ", name);
    const std::size_t first = parameters_.size();
    const std::size_t wanted = macro->parameters.size();
    const auto given = [&] { return parameters_.size() - first; };
    const Level level(*this);
    while (given() < wanted && peek_raw_kind() != TokenKind::right_paren) {
        const std::uint32_t cell = parse_parameter();
        parameters_.push_back(cell);
        if (peek().kind == TokenKind::right_paren) break;
        if (!accept(TokenKind::comma) && given() < wanted)
            warn_once(here(), "macro comma", "a comma is missing between the parameters of a macro");
    }
    if (given() < wanted)
        fail(where,
             std::string(name) + " takes " + std::to_string(wanted) + " parameters, not " + std::to_string(given()));
    if (peek().kind != TokenKind::right_paren)
        fail_expected("')' after the " + std::to_string(wanted) + " parameters of " + std::string(name));
    take();
    identifiers_.enter_level();
    for (std::size_t i = 0; i < wanted; ++i) identifiers_.bind(macro->parameters[i], parameters_[first + i]);
    parameters_.resize(first);
    frames_.push_back({macro->file, macro->begin, macro->end, conditionals_.size(), macro});
}

std::uint32_t Interpreter::parse_parameter() {
    if (const auto cell = parse_reference()) return *cell;
    return identifiers_.hold(parse_rvalue());
}

/// A parameter that is nothing but an identifier or an array's element is passed by reference.
std::optional<std::uint32_t> Interpreter::parse_reference() {
    Token token = raw();
    if (ahead_is_full_ || token.kind() != TokenKind::name) return std::nullopt;
    const NameId name = token.payload();
    const Entity* entity = identifiers_.find(name);
    if (entity != nullptr && std::holds_alternative<std::shared_ptr<const Macro>>(*entity)) return std::nullopt;
    // Looks ahead in the frame's own tokens, past subscripts, for what ends a parameter.
    const Frame& frame = frames_.back();
    std::uint32_t slot = frame.position + 1;
    for (std::uint32_t open = 0; slot < frame.end; slot += slots_of(token.kind())) {
        token = frame.file->tokens[slot];
        if (token.kind() == TokenKind::left_bracket) ++open;
        else if (token.kind() == TokenKind::right_bracket && open > 0) --open;
        else if (open == 0) break;
    }
    const bool is_lone =
        slot < frame.end && (token.kind() == TokenKind::comma || token.kind() == TokenKind::right_paren);
    const bool has_subscript = slot > frame.position + 1;
    if (!is_lone || (has_subscript && entity == nullptr)) return std::nullopt;
    const Spot where = raw_place();
    skip_raw();
    if (!has_subscript) return identifiers_.reference(name);
    const auto* array = std::get_if<std::shared_ptr<Array>>(entity);
    if (array == nullptr) fail(where, std::string(names_.text(name)) + " is " + describe(*entity) + ", not an array");
    const std::vector<std::size_t> path = parse_subscripts(name, where);
    // An element of an array within an array is in no identifier's cell; its value has to do.
    if (path.size() > 1) return identifiers_.hold(Entity(element_at(name, path, where)));
    return identifiers_.reference_element(name, static_cast<std::uint32_t>(path.front()));
}

}  // namespace sundog::pov
