// SPDX-License-Identifier: Apache-2.0
// The float functions that POV-Ray's expressions and user functions share.
#pragma once

#include <optional>
#include <span>

#include "import/pov/keywords.h"

namespace sundog::pov {

/// How many floats a function such as sin, pow or atan2 takes; 0 for words that are no such function or take any
/// number.
unsigned float_arity(Keyword keyword);

/// Its value. Outside of its domain it is what C's mathematics library says, except for small slips of rounding beyond
/// -1 and 1 in acos and asin, which are clamped.
double float_function(Keyword keyword, std::span<const double> arguments);

/// min, max, bitwise_and, bitwise_or, bitwise_xor of one or more floats; select of 3 or 4.
double aggregate_function(Keyword keyword, std::span<const double> arguments);

/// True for arguments for which it has no value (the square root of -1, the logarithm of 0).
bool outside_domain(Keyword keyword, std::span<const double> arguments);

}  // namespace sundog::pov
