// SPDX-License-Identifier: Apache-2.0
// Numbers in POV-Ray's text, and long lists of them without a token each.
#pragma once

#include <optional>

#include "import/pov/entity.h"

namespace sundog::pov {

/// Reads an unsigned decimal number (digits with a point anywhere, exponent) that starts at `at` and moves `at` behind
/// it. Text must end with a byte that isn't part of a number. Too large a number is infinite.
double scan_number(const char*& at);

/// Moves `at` past blanks, newlines and comments (`//`, nested `/* */`). False where a comment has no end.
bool skip_blanks(const char*& at, const char* end);

/// Reads numbers and vectors of numbers, separated by commas, up to a `}`, to which it moves `at`. Nothing, and `at`
/// unmoved, where anything else is met: then it takes the whole language to read it.
std::optional<ValueList> scan_literal_list(const char*& at, const char* end);

}  // namespace sundog::pov
