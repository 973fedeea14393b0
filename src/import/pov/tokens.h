// SPDX-License-Identifier: Apache-2.0
// A file of POV-Ray's language as tokens, read once however often loops and macros pass over it.
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "import/pov/entity.h"
#include "import/pov/names.h"
#include "import/pov/source_files.h"

namespace sundog::pov {

enum class TokenKind : std::uint8_t {
    end,        ///< Of the file.
    number,     ///< Its value is in the next slot.
    string,     ///< Payload: into TokenFile::strings.
    keyword,    ///< Payload: the Keyword.
    name,       ///< Payload: the NameId.
    directive,  ///< `#word`; payload: the Keyword. The next slot is a link, see TokenFile::link().
    list,       ///< The inside of a mesh2's list; payload: into TokenFile::lists.
    bad,        ///< Payload: into TokenFile::errors. An error only if it is reached, since it may be skipped.
    left_brace,
    right_brace,
    left_paren,
    right_paren,
    left_bracket,
    right_bracket,
    left_angle,
    right_angle,
    less_equal,
    greater_equal,
    not_equal,
    comma,
    semicolon,
    plus,
    minus,
    star,
    slash,
    equals,
    exclamation,
    ampersand,
    bar,
    question,
    colon,
    dot,
    held,  ///< Not of a file: what a declaration's expression may not look past.
};

inline constexpr std::uint32_t kLargestPayload = (1U << 24U) - 1;

/// 8 bytes a token; numbers and directives take two.
struct Token {
    std::uint32_t kind_and_payload = 0;
    std::uint32_t offset = 0;  ///< Into the text.

    Token() = default;
    Token(TokenKind kind, std::uint32_t payload, std::uint32_t at)
        : kind_and_payload(static_cast<std::uint32_t>(kind) | payload << 8U), offset(at) {}
    [[nodiscard]] TokenKind kind() const { return static_cast<TokenKind>(kind_and_payload & 0xffU); }
    [[nodiscard]] std::uint32_t payload() const { return kind_and_payload >> 8U; }
};
static_assert(sizeof(Token) == sizeof(double));

/// How many slots a token takes.
constexpr std::uint32_t slots_of(TokenKind kind) {
    return kind == TokenKind::number || kind == TokenKind::directive ? 2 : 1;
}

/// A file as tokens.
struct TokenFile {
    std::uint32_t file = 0;  ///< In SourceFiles.
    std::filesystem::path path;
    std::vector<Token> tokens;  ///< Ends with TokenKind::end.
    std::vector<std::string> strings;
    std::vector<std::shared_ptr<const ValueList>> lists;
    std::vector<std::string> errors;
    std::vector<std::uint32_t> line_starts;

    [[nodiscard]] double number(std::uint32_t slot) const { return std::bit_cast<double>(tokens[slot + 1]); }
    /// From a #if, #ifdef, #ifndef, #else, #elseif, #switch, #case or #range to the next part of the same conditional;
    /// from the last part, #while, #for or #macro to their #end. 0 where the file has no such.
    [[nodiscard]] std::uint32_t link(std::uint32_t slot) const { return tokens[slot + 1].offset; }
    /// The place of a byte. Remembers the last line found, since places are mostly asked for in order.
    [[nodiscard]] Place place(std::uint32_t offset) const;

private:
    mutable std::uint32_t last_line_ = 0;
};

/// Splits a file into tokens. Never fails: what is wrong becomes TokenKind::bad.
std::shared_ptr<const TokenFile> tokenise(std::uint32_t file, std::filesystem::path path, const SourceText& source,
                                          Names& names);

}  // namespace sundog::pov
