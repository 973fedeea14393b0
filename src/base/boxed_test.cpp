// SPDX-License-Identifier: Apache-2.0
#include "base/boxed.h"

#include <gtest/gtest.h>

#include <utility>

namespace sundog {
namespace {

struct Part {
    int number = 7;
};

// Catches a part that is made by looking at it: a million objects would carry what they don't have.
TEST(Boxed, ReadsAsDefaultsUntilWrittenTo) {
    Boxed<Part> part;
    EXPECT_EQ(std::as_const(part)->number, 7);
    EXPECT_FALSE(part.has_value());
    part->number = 8;
    EXPECT_TRUE(part.has_value());
    EXPECT_EQ(std::as_const(part)->number, 8);
    part.reset();
    EXPECT_EQ(std::as_const(part)->number, 7);
}

// Catches copies that share one value.
TEST(Boxed, CopiesAreTheirOwn) {
    Boxed<Part> part = Part{1};
    Boxed<Part> copy = part;
    copy->number = 2;
    EXPECT_EQ(part->number, 1);
    part = copy;
    copy->number = 3;
    EXPECT_EQ(part->number, 2);
    const Boxed<Part> moved = std::move(part);
    EXPECT_EQ(moved->number, 2);
}

}  // namespace
}  // namespace sundog
