// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostics.h"

#include <gtest/gtest.h>

#include <array>

namespace sundog {
namespace {

SourceLocation at(std::uint32_t line, std::uint32_t column) {
    return {std::make_shared<const std::string>("a.scene"), line, column};
}

// Catches a caret that points at another column than the one named.
TEST(Diagnostics, CaretStandsUnderTheColumn) {
    const Diagnostic d{Severity::error, at(3, 9), "bad number 'x'", "focus = x", "expected a float"};
    EXPECT_EQ(format(d),
              "a.scene:3:9: error: bad number 'x'\n"
              "    3 | focus = x\n"
              "      |         ^\n"
              "hint: expected a float");
}

// Catches a binary or endless line being echoed whole to a terminal.
TEST(Diagnostics, LongAndBinaryLinesAreTamed) {
    const Diagnostic d{Severity::warning, at(1, 5000), "m", std::string(10000, '\x1b'), ""};
    const std::string text = format(d);
    EXPECT_LT(text.size(), 600U);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

// Catches suggestions that miss swapped letters or offer far-fetched names.
TEST(Diagnostics, NearestNames) {
    constexpr std::array<std::string_view, 4> keys{"focus", "rotX", "rotZ", "distance"};
    EXPECT_EQ(nearest_names("focsu", keys), std::vector<std::string>{"focus"});
    EXPECT_EQ(nearest_names("rotY", keys), (std::vector<std::string>{"rotX", "rotZ"}));
    EXPECT_TRUE(nearest_names("zzzzzz", keys).empty());
    EXPECT_EQ(suggest("focsu", keys), "did you mean 'focus'?");
    EXPECT_EQ(suggest("qqqq", keys), "expected one of: focus, rotX, rotZ, distance");
}

}  // namespace
}  // namespace sundog
