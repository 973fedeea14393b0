// SPDX-License-Identifier: Apache-2.0
#include "import/pov/tokens.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/scan.h"
#include "import/pov/literal_list.h"

namespace sundog::pov {
namespace {

constexpr std::array kDirectives{
    Keyword::break_,  Keyword::case_,   Keyword::debug,  Keyword::declare,    Keyword::default_, Keyword::else_,
    Keyword::elseif,  Keyword::end,     Keyword::error,  Keyword::fclose,     Keyword::fopen,    Keyword::for_,
    Keyword::if_,     Keyword::ifdef,   Keyword::ifndef, Keyword::include,    Keyword::local,    Keyword::macro,
    Keyword::range,   Keyword::read,    Keyword::render, Keyword::statistics, Keyword::switch_,  Keyword::undef,
    Keyword::version, Keyword::warning, Keyword::while_, Keyword::write};

constexpr std::array kPackedLists{Keyword::vertex_vectors, Keyword::normal_vectors, Keyword::uv_vectors,
                                  Keyword::face_indices,   Keyword::normal_indices, Keyword::uv_indices};

bool starts_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool continues_word(char c) { return starts_word(c) || is_digit(c); }

void append_utf8(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0U | code >> 6U), put(0x80U | (code & 0x3fU));
    } else {
        put(0xe0U | code >> 12U), put(0x80U | (code >> 6U & 0x3fU)), put(0x80U | (code & 0x3fU));
    }
}

constexpr bool is_one_of(Keyword keyword, const auto& keywords) {
    return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

class Lexer {
public:
    Lexer(TokenFile& out, const SourceText& source, Names& names)
        : out_(out), names_(names), begin_(source.text.data()), end_(begin_ + source.text.size()), at_(begin_) {}

    void run() {
        find_lines();
        out_.tokens.reserve(static_cast<std::size_t>(end_ - begin_) / 6 + 16);
        while (skip_blanks(at_, end_) && at_ < end_) {
            if (starts_word(*at_)) word();
            else if (is_digit(*at_) || (*at_ == '.' && is_digit(at_[1]))) number();
            else if (*at_ == '"') string();
            else if (*at_ == '#') directive();
            else punctuation();
        }
        if (at_ < end_) bad("this comment has no end", at_, end_);
        put(TokenKind::end, 0, end_);
    }

private:
    void find_lines() {
        out_.line_starts.push_back(0);
        for (const char* p = begin_; p < end_; ++p)
            if (*p == '\n') out_.line_starts.push_back(static_cast<std::uint32_t>(p + 1 - begin_));
    }
    void put(TokenKind kind, std::size_t payload, const char* where) {
        if (payload > kLargestPayload) return bad("more than 16 million strings or names in one file", where, end_);
        out_.tokens.emplace_back(kind, static_cast<std::uint32_t>(payload), static_cast<std::uint32_t>(where - begin_));
    }
    void bad(std::string message, const char* where, const char* go_on) {
        const std::size_t payload = std::min<std::size_t>(out_.errors.size(), kLargestPayload);
        if (payload == out_.errors.size()) out_.errors.push_back(std::move(message));
        put(TokenKind::bad, payload, where);
        at_ = go_on;
    }
    std::string_view take_word() {
        const char* const start = at_;
        while (at_ < end_ && continues_word(*at_)) ++at_;
        return {start, static_cast<std::size_t>(at_ - start)};
    }
    void word() {
        const char* const start = at_;
        const NameId id = names_.intern(take_word());
        const bool reserved = id < kKeywordCount;
        put(reserved ? TokenKind::keyword : TokenKind::name, id, start);
        if (reserved && is_one_of(static_cast<Keyword>(id), kPackedLists)) packed_list();
    }
    void packed_list() {
        if (!skip_blanks(at_, end_) || at_ >= end_ || *at_ != '{') return;
        put(TokenKind::left_brace, 0, at_);
        const char* after = ++at_;
        std::optional<ValueList> list = scan_literal_list(after, end_);
        if (!list || list->counts.empty()) return;
        put(TokenKind::list, out_.lists.size(), at_);
        out_.lists.push_back(std::make_shared<const ValueList>(*std::move(list)));
        at_ = after;
    }
    void number() {
        put(TokenKind::number, 0, at_);
        out_.tokens.push_back(std::bit_cast<Token>(scan_number(at_)));
    }
    void string() {
        const char* const start = at_++;
        std::string text;
        while (at_ < end_ && *at_ != '"') {
            if (*at_ == '\\' && at_ + 1 < end_) escape(text);
            else text += *at_++;
        }
        if (at_ >= end_) return bad("this string has no closing quote", start, end_);
        ++at_;
        put(TokenKind::string, out_.strings.size(), start);
        out_.strings.push_back(std::move(text));
    }
    /// An escape sequence (manual, 3.3.2.7.2); one that isn't known stands for itself, as in paths of Windows.
    void escape(std::string& text) {
        constexpr std::string_view kLetters = "abfnrtv0\\'\"";
        constexpr std::string_view kMeanings{"\a\b\f\n\r\t\v\0\\'\"", 11};
        const char letter = at_[1];
        if (letter == 'u') {
            std::uint32_t code = 0;
            const char* p = at_ + 2;
            for (; p < at_ + 6 && p < end_; ++p) {
                const int digit = is_digit(*p)             ? *p - '0'
                                  : *p >= 'a' && *p <= 'f' ? *p - 'a' + 10
                                  : *p >= 'A' && *p <= 'F' ? *p - 'A' + 10
                                                           : -1;
                if (digit < 0) break;
                code = code * 16 + static_cast<std::uint32_t>(digit);
            }
            if (p == at_ + 6) {
                append_utf8(text, code);
                at_ = p;
                return;
            }
        }
        if (const std::size_t i = kLetters.find(letter); i != std::string_view::npos) text += kMeanings[i];
        else (text += '\\') += letter;
        at_ += 2;
    }
    void directive() {
        const char* const start = at_++;
        while (at_ < end_ && (is_blank(*at_))) ++at_;
        const std::string_view word = take_word();
        // POV-Ray passes over a lone '#'.
        if (word.empty()) return;
        const auto keyword = find_keyword(word);
        // Before POV-Ray 3 these two were directives; their use as such still works there.
        if (keyword == Keyword::max_trace_level || keyword == Keyword::max_intersections)
            return put(TokenKind::keyword, static_cast<std::size_t>(*keyword), start);
        if (!keyword || !is_one_of(*keyword, kDirectives)) {
            std::array<std::string_view, kDirectives.size()> valid;
            std::transform(kDirectives.begin(), kDirectives.end(), valid.begin(), spelling);
            return bad("unknown directive '#" + std::string(word.substr(0, 40)) + "'; " + suggest(word, valid), start,
                       at_);
        }
        link(*keyword, static_cast<std::uint32_t>(out_.tokens.size()));
        put(TokenKind::directive, static_cast<std::size_t>(*keyword), start);
        out_.tokens.emplace_back();
    }
    /// Ties the parts of a conditional together. Called before the directive's own token is there.
    void link(Keyword keyword, std::uint32_t slot) {
        constexpr std::array kOpening{Keyword::if_,  Keyword::ifdef,   Keyword::ifndef, Keyword::while_,
                                      Keyword::for_, Keyword::switch_, Keyword::macro};
        constexpr std::array kMiddle{Keyword::else_, Keyword::elseif, Keyword::case_, Keyword::range};
        if (is_one_of(keyword, kOpening)) return open_.push_back(slot);
        if (open_.empty() || (keyword != Keyword::end && !is_one_of(keyword, kMiddle))) return;
        out_.tokens[open_.back() + 1].offset = slot;
        if (keyword == Keyword::end) open_.pop_back();
        else open_.back() = slot;
    }
    void punctuation();

    TokenFile& out_;
    Names& names_;
    const char *begin_, *end_, *at_;
    std::vector<std::uint32_t> open_;  ///< Slots of the latest part of each conditional that has no #end yet.
};

void Lexer::punctuation() {
    using enum TokenKind;
    const char* const start = at_++;
    const bool then_equals = at_ < end_ && *at_ == '=';
    switch (*start) {
        case '{':
            return put(left_brace, 0, start);
        case '}':
            return put(right_brace, 0, start);
        case '(':
            return put(left_paren, 0, start);
        case ')':
            return put(right_paren, 0, start);
        case '[':
            return put(left_bracket, 0, start);
        case ']':
            return put(right_bracket, 0, start);
        case ',':
            return put(comma, 0, start);
        case ';':
            return put(semicolon, 0, start);
        case '+':
            return put(plus, 0, start);
        case '-':
            return put(minus, 0, start);
        case '*':
            return put(star, 0, start);
        case '/':
            return put(slash, 0, start);
        case '=':
            return put(equals, 0, start);
        case '&':
            return put(ampersand, 0, start);
        case '|':
            return put(bar, 0, start);
        case '?':
            return put(question, 0, start);
        case ':':
            return put(colon, 0, start);
        case '.':
            return put(dot, 0, start);
        case '<':
            at_ += then_equals ? 1 : 0;
            return put(then_equals ? less_equal : left_angle, 0, start);
        case '>':
            at_ += then_equals ? 1 : 0;
            return put(then_equals ? greater_equal : right_angle, 0, start);
        case '!':
            at_ += then_equals ? 1 : 0;
            return put(then_equals ? not_equal : exclamation, 0, start);
        default:
            this->bad("unexpected character " + in_quotes({start, 1}), start, at_);
    }
}

}  // namespace

Place TokenFile::place(std::uint32_t offset) const {
    if (last_line_ >= line_starts.size() || line_starts[last_line_] > offset ||
        (last_line_ + 8 < line_starts.size() && line_starts[last_line_ + 8] <= offset))
        last_line_ = static_cast<std::uint32_t>(std::upper_bound(line_starts.begin(), line_starts.end(), offset) -
                                                line_starts.begin() - 1);
    while (last_line_ + 1 < line_starts.size() && line_starts[last_line_ + 1] <= offset) ++last_line_;
    return {file, last_line_ + 1, offset - line_starts[last_line_] + 1};
}

std::shared_ptr<const TokenFile> tokenise(std::uint32_t file, std::filesystem::path path, const SourceText& source,
                                          Names& names) {
    auto out = std::make_shared<TokenFile>();
    out->file = file;
    out->path = std::move(path);
    Lexer(*out, source, names).run();
    return out;
}

}  // namespace sundog::pov
