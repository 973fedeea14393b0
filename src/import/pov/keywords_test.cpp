// SPDX-License-Identifier: Apache-2.0
#include "import/pov/keywords.h"

#include <gtest/gtest.h>

namespace sundog::pov {
namespace {

// A word that the search misses, or finds as another.
TEST(PovKeywords, EveryWordIsFoundByItsSpelling) {
    for (const std::string_view word : keyword_spellings()) {
        const auto keyword = find_keyword(word);
        ASSERT_TRUE(keyword.has_value()) << word;
        EXPECT_EQ(spelling(*keyword), word);
    }
}

// British spellings taken for identifiers; identifiers taken for keywords because of their first letters or their case.
TEST(PovKeywords, SpellingsAndNearMisses) {
    EXPECT_EQ(find_keyword("colour"), Keyword::color);
    EXPECT_EQ(find_keyword("fade_colour"), Keyword::fade_color);
    EXPECT_EQ(find_keyword("union"), Keyword::union_);
    EXPECT_FALSE(find_keyword("Sphere").has_value());
    EXPECT_FALSE(find_keyword("spher").has_value());
    EXPECT_FALSE(find_keyword("").has_value());
    EXPECT_TRUE(is_soft_keyword(Keyword::lemon));
    EXPECT_FALSE(is_soft_keyword(Keyword::sphere));
}

}  // namespace
}  // namespace sundog::pov
