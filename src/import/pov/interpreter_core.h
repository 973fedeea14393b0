// SPDX-License-Identifier: Apache-2.0
// The machine that runs POV-Ray's language; interpreter.h is its public face. Its parts, one file each: the stream of
// tokens that directives and macros make (interpreter_stream.cpp), directives, declarations, expressions, functions,
// blocks.
#pragma once

#include <set>
#include <unordered_map>

#include "import/pov/identifiers.h"
#include "import/pov/interpreter.h"
#include "import/pov/tokens.h"
#include "import/pov/values.h"

namespace sundog::pov {

class Interpreter {
public:
    Interpreter(const PovOptions& options, std::filesystem::path scene_folder, SourceFiles& sources, BlockSink& sink,
                GeometryQueries* queries, const WarningSink& warn);
    void run(const std::filesystem::path& path, const SourceText& source);

private:
    /// A token's place, worked out where it is needed only: finding a line takes longer than most tokens.
    struct Spot {
        const TokenFile* file = nullptr;
        std::uint32_t offset = 0;
        operator Place() const {
            return file == nullptr ? Place{} : file->place(offset);
        }  // NOLINT(google-explicit-constructor)
    };

    // The stream of tokens. peek() runs directives and macros that stand before the next token.

    struct Lookahead {
        TokenKind kind = TokenKind::end;
        std::uint32_t payload = 0;
        double number = 0;
        const TokenFile* file = nullptr;
        std::uint32_t slot = 0;
        std::uint32_t offset = 0;
        [[nodiscard]] bool is(Keyword keyword) const {
            return kind == TokenKind::keyword && payload == static_cast<std::uint32_t>(keyword);
        }
    };
    /// A file or a macro's body being read.
    struct Frame {
        const TokenFile* file = nullptr;
        std::uint32_t position = 0, end = 0;
        std::size_t conditionals = 0;        ///< How many were open where it began.
        std::shared_ptr<const Macro> macro;  ///< Null for a file.
    };
    /// A conditional or a loop whose #end is still to come.
    struct Conditional {
        Keyword kind{};
        std::uint32_t slot = 0;  ///< Of its directive.
        std::size_t frame = 0;
        bool matched = false;  ///< Of a #switch: a clause has been chosen.
        double value = 0;      ///< Of a #switch.
        NameId counter = 0;    ///< Of a #for, with the three below.
        double last = 0, step = 0;
        std::uint32_t body = 0;  ///< Slot of the first token of its body.
    };
    /// How far a declaration's expression may look ahead: not past directives of the level where it began.
    struct Guard {
        bool active = false;
        std::size_t frames = 0, conditionals = 0;
    };
    /// Sets the guard for a scope.
    class GuardScope {
    public:
        GuardScope(Guard& guard, Guard value) : guard_(guard), saved_(guard) { guard = value; }
        GuardScope(const GuardScope&) = delete;
        GuardScope& operator=(const GuardScope&) = delete;
        ~GuardScope() { guard_ = saved_; }

    private:
        Guard& guard_;
        Guard saved_;
    };
    /// Counts a level of nesting for a scope. Errors: the limit.
    class Level {
    public:
        explicit Level(Interpreter& interpreter);
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
        ~Level() { --depth_; }

    private:
        std::uint32_t& depth_;
    };

    const Lookahead& peek() {
        if (!ahead_is_full_) fetch(false);
        return ahead_;
    }
    /// As peek(), where an operator may follow a complete operand: respects the guard.
    const Lookahead& peek_operator() {
        if (!ahead_is_full_) fetch(guard_.active);
        return ahead_;
    }
    void take() { ahead_is_full_ = false; }
    bool accept(TokenKind kind) {
        if (peek().kind != kind) return false;
        take();
        return true;
    }
    /// Takes a token of that kind. Errors: its absence, told with `context` and `word` behind it.
    void expect(TokenKind kind, std::string_view context, std::string_view word = {}) {
        if (peek_operator().kind != kind) fail_missing(kind, context, word);
        take();
    }
    [[noreturn]] void fail_missing(TokenKind kind, std::string_view context, std::string_view word);
    /// The next token as it stands in the file behind what was looked at, without running anything; TokenKind::end at
    /// the frame's end.
    [[nodiscard]] Token raw() const;
    /// The kind of the next token as it stands in the file, or of the one that was looked at already.
    [[nodiscard]] TokenKind peek_raw_kind() const { return ahead_is_full_ ? ahead_.kind : raw().kind(); }
    void skip_raw();
    bool accept_raw(TokenKind kind);
    void fetch(bool respect_guard);
    bool holds_back(const Frame& frame, const Token& token) const;
    bool leave_frame();
    void tick(std::uint64_t steps = 1) {
        if (steps_left_ < steps) out_of_steps();
        steps_left_ -= steps;
        if ((steps_left_ ^ (steps_left_ + steps)) >> 18U != 0) check_memory();
    }
    [[noreturn]] void out_of_steps();
    void check_memory();
    void enter_file(const TokenFile& file);
    void invoke(const std::shared_ptr<const Macro>& macro, Spot where);
    std::uint32_t parse_parameter();
    std::optional<std::uint32_t> parse_reference();

    // Messages.

    /// Of the next token.
    Spot here() {
        const Lookahead& ahead = peek_operator();
        return ahead.kind == TokenKind::held ? raw_place() : Spot{ahead.file, ahead.offset};
    }
    [[nodiscard]] Spot raw_place() const {
        if (frames_.empty()) return {};
        const Frame& frame = frames_.back();
        return {frame.file, frame.file->tokens[frame.position].offset};
    }
    [[noreturn]] void fail(Place where, std::string message, std::string hint = {}) const;
    /// "expected …, found …" about the next token.
    [[noreturn]] void fail_expected(std::string_view expected);
    [[noreturn]] void fail_undeclared(Place where, NameId name) const;
    std::string describe_ahead();
    void warn(Place where, std::string message, std::string hint = {});
    /// Warns the first time that `kind` is met.
    void warn_once(Place where, const std::string& kind, std::string message, std::string hint = {});
    void note_use(NameId name, Place where);

    // Directives.

    void run_directive();
    void run_if(std::uint32_t slot);
    void run_while(std::uint32_t slot);
    void run_for(std::uint32_t slot);
    void run_switch(std::uint32_t slot);
    void run_clause(std::uint32_t slot);
    void run_else(std::uint32_t slot);
    void run_end();
    void run_break(Spot where);
    void run_macro(std::uint32_t slot);
    void run_include();
    void run_version();
    void run_default(Spot where);
    void run_message(Keyword kind);
    void run_undef();
    void jump(std::uint32_t slot) { frames_.back().position = slot; }
    [[nodiscard]] std::uint32_t next_part(std::uint32_t slot) const;
    [[nodiscard]] std::uint32_t end_of(std::uint32_t slot) const;
    Conditional& innermost(std::string_view directive);
    void open_conditional(Keyword kind, std::uint32_t slot);
    bool condition();
    double parenthesised_number();

    // Files that scenes read and write.

    void run_fopen();
    void run_fclose();
    void run_read();
    void run_write();
    bool read_datum(OpenFile& file, Entity& into, Spot where);
    /// A form in which #write puts whole numbers.
    struct BinaryWord {
        std::uint32_t bytes = 1;
        bool is_signed = false;
        bool big_endian = false;
        [[nodiscard]] std::string bytes_of(double number) const;
    };
    static std::optional<BinaryWord> binary_word(Keyword keyword);
    std::filesystem::path find_file(const std::string& name, Spot where);
    const TokenFile& tokens_of(const std::filesystem::path& path, Spot where);

    // Declarations and what may stand on their right side.

    void run_declare(bool local);
    NameId raw_name(std::string_view what);
    Entity parse_rvalue();
    Entity parse_array();
    void fill_array(Array& array, std::size_t dimension, std::size_t& next);
    std::shared_ptr<const Spline> parse_spline();
    /// The element that subscripts name, read from `[` on, which has a value.
    Entity element(const std::shared_ptr<Array>& array, NameId name, Spot where);
    std::size_t element_index(const Array& array, NameId name, Spot where);
    /// The elements that subscripts lead to, through arrays of arrays.
    std::vector<std::size_t> parse_subscripts(NameId name, Spot where);
    Entity& element_at(NameId name, const std::vector<std::size_t>& path, Spot where);
    bool raw_is_defined();

    // Expressions.

    Value parse_expression();
    Value parse_term();
    Value parse_factor();
    Value parse_full();
    Value parse_relation();
    Value parse_vector();
    bool parse_literal_vector(Value& value);
    Value parse_components(Value value);
    Value parse_keyword_factor();
    Value parse_string_relation();
    Value parse_name_factor();
    Value parse_color_form(Keyword form);
    void parse_color_words(Value& color);
    bool at_color_word();
    double parse_number();
    Value value_of_entity(const Entity& entity, NameId name, Spot where);
    Value call_function(std::shared_ptr<const FunctionExpression> function, Spot where);
    Value call_spline(const Spline& spline, Spot where);
    Value call_builtin(Keyword keyword, Spot where);
    Value call_aggregate(Keyword keyword, Spot where);
    Value call_of_names(Keyword keyword, Spot where);
    Value call_of_strings(Keyword keyword, Spot where);
    Value argument(bool first);
    double next_random(double stream, Spot where);
    static double days_since_2000();
    Value call_geometry(Keyword keyword, Spot where);
    std::shared_ptr<const Block> object_argument();
    Value constant_of(Keyword keyword);
    bool starts_expression();
    bool starts_string();
    /// A value with colour words that follow it: `Red transmit 0.5`.
    Value parse_value();

    // Strings.

    std::string parse_string();
    std::string call_string_builtin(Keyword keyword, Spot where);
    std::string checked(std::string text, Spot where);
    std::string date_text(double days_since_2000, const std::string& format, Spot where);

    // Blocks.

    std::shared_ptr<const Block> parse_block(Keyword keyword, Place where);
    void parse_block_into(Block& block);
    void parse_items(std::vector<Item>& items, TokenKind closing, Keyword context, std::uint32_t& depth);
    void parse_keyword_item(std::vector<Item>& items, Keyword context, std::uint32_t& depth);
    void parse_name_item(std::vector<Item>& items, Keyword context, std::uint32_t& depth);
    void parse_function_item(std::vector<Item>& items, std::uint32_t& depth);
    void append_value(std::vector<Item>& items, Place where, const Value& value, Keyword context);
    void append_list(std::vector<Item>& items, std::shared_ptr<const ValueList> list, Place where);
    void append_long_vector(std::vector<Item>& items);
    void check_depth(std::uint32_t depth, Place where) const;
    void run_scene();
    void note_globals(const Block& block);

    // User functions.

    std::shared_ptr<const FunctionExpression> parse_function();
    std::shared_ptr<const FunctionExpression> parse_function(Spot where);
    friend class FunctionParser;

    const PovOptions& options_;
    SourceFiles& sources_;
    BlockSink& sink_;
    GeometryQueries* queries_;
    FunctionCalls function_calls_;
    const WarningSink& warn_;
    FileFinder finder_;
    std::filesystem::path scene_folder_;
    std::string input_file_name_;

    Names names_;
    Identifiers identifiers_;
    std::vector<std::shared_ptr<const TokenFile>> token_files_;
    std::unordered_map<std::string, const TokenFile*> tokens_by_path_;
    std::vector<Frame> frames_;
    std::vector<Conditional> conditionals_;
    Lookahead ahead_;
    bool ahead_is_full_ = false;
    Guard guard_;
    /// A value that the next factor is to start with: an array's element whose kind had to be known first.
    std::optional<Value> pending_;
    std::shared_ptr<ValueList> growing_list_;  ///< The ValueList that append_value() made last.
    std::vector<std::uint32_t> parameters_;    ///< Cells of the parameters of macros about to be run.
    std::uint32_t depth_ = 0;
    std::uint32_t files_open_ = 0;
    std::uint64_t steps_left_;
    std::uint64_t memory_limit_ = 0;
    std::uint64_t memory_at_start_ = 0;

    std::uint16_t version_;
    double assumed_gamma_ = 1;
    std::shared_ptr<const Block> defaults_;
    std::vector<std::uint32_t> random_streams_;
    bool has_deprecated_ = false;
    std::set<std::string> warned_;
};

}  // namespace sundog::pov
