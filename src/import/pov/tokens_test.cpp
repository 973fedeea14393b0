// SPDX-License-Identifier: Apache-2.0
#include "import/pov/tokens.h"

#include <gtest/gtest.h>

namespace sundog::pov {
namespace {

struct Tokens {
    Names names;
    SourceText source;
    std::shared_ptr<const TokenFile> file;
    explicit Tokens(std::string_view text)
        : source(text_in_memory("t.pov", text)), file(tokenise(0, "t.pov", source, names)) {}
    [[nodiscard]] std::vector<TokenKind> kinds() const {
        std::vector<TokenKind> kinds;
        for (std::uint32_t i = 0; i < file->tokens.size(); i += slots_of(file->tokens[i].kind()))
            kinds.push_back(file->tokens[i].kind());
        return kinds;
    }
};

using enum TokenKind;

// Comments within comments that end too early; a number's dot taken for a component's; two-character operators split.
TEST(PovTokens, KindsOfTokens) {
    EXPECT_EQ(Tokens("/* a /* b */ c */ sphere // x\n{ A.x <= .5e1 }").kinds(),
              (std::vector{keyword, left_brace, name, dot, keyword, less_equal, number, right_brace, end}));
    EXPECT_EQ(Tokens("a != b >= !c").kinds(),
              (std::vector{name, not_equal, name, greater_equal, exclamation, name, end}));
}

// Digits lost or rounded twice.
TEST(PovTokens, NumbersAreTheNearestDoubles) {
    for (const char* text : {"0", "3.25", ".5", "5.", "1e-5", "6.02214076e23", "0.1", "123456789012345678901234567890",
                             "0.3333333333333333333333333", "1e-400", "2.2250738585072014e-308"}) {
        const Tokens tokens(text);
        EXPECT_EQ(tokens.file->number(0), std::strtod(text, nullptr)) << text;
    }
}

// Escapes that stay as they are; a string that swallows the rest without a word.
TEST(PovTokens, Strings) {
    EXPECT_EQ(Tokens(R"("a\"b\\c\n\u00e9\q")").file->strings.at(0), "a\"b\\c\n\xc3\xa9\\q");
    const Tokens open("sphere \"no end");
    EXPECT_EQ(open.kinds(), (std::vector{keyword, bad, end}));
    EXPECT_NE(open.file->errors.at(0).find("closing quote"), std::string::npos);
}

// Links that lead into nested conditionals, or past the #end.
TEST(PovTokens, LinksSkipNestedConditionals) {
    const Tokens tokens("#if (1) #while (0) #end #else #if(2) #else #end #end x");
    const std::uint32_t if_slot = 0;
    const std::uint32_t else_slot = tokens.file->link(if_slot);
    EXPECT_EQ(tokens.file->tokens[else_slot].payload(), static_cast<std::uint32_t>(Keyword::else_));
    const std::uint32_t end_slot = tokens.file->link(else_slot);
    EXPECT_EQ(tokens.file->tokens[end_slot].payload(), static_cast<std::uint32_t>(Keyword::end));
    EXPECT_EQ(tokens.file->tokens[end_slot + 2].kind(), keyword);
}

// Columns and lines that are off by one.
TEST(PovTokens, Places) {
    const Tokens tokens("a\n  b\n\nc");
    const Place b = tokens.file->place(tokens.file->tokens[1].offset);
    EXPECT_EQ(b.line, 2U);
    EXPECT_EQ(b.column, 3U);
    EXPECT_EQ(tokens.file->place(tokens.file->tokens[2].offset).line, 4U);
    EXPECT_EQ(tokens.file->place(0).line, 1U);
}

// A literal list read with another meaning than its expressions have: a sign after a value subtracts.
TEST(PovTokens, ListsOfNumbersArePacked) {
    const Tokens packed("vertex_vectors { 2, <0,1,-2.5>, // c\n <1e1,2,3>, } 1");
    ASSERT_EQ(packed.kinds(), (std::vector{keyword, left_brace, list, right_brace, number, end}));
    EXPECT_EQ(packed.file->lists.at(0)->numbers, (std::vector<double>{2, 0, 1, -2.5, 10, 2, 3}));
    EXPECT_EQ(packed.file->lists.at(0)->counts, (std::vector<std::uint8_t>{1, 3, 3}));
    EXPECT_EQ(Tokens("face_indices { 2, <0,1,2> - 1 }").kinds()[2], number);
    EXPECT_EQ(Tokens("face_indices { N, <0,1,2> }").kinds()[2], name);
    EXPECT_EQ(Tokens("vertex_vectors { 1, <0,1,2>*3 }").kinds()[2], number);
}

}  // namespace
}  // namespace sundog::pov
