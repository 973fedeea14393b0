// SPDX-License-Identifier: Apache-2.0
// The functions that POV-Ray's functions.inc declares by number.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fields/function_builder.h"

namespace sundog::fields {

struct InternalFunction {
    std::uint32_t number;          ///< As in `internal(number)`.
    std::string_view name;         ///< As functions.inc calls it.
    std::uint32_t argument_count;  ///< x, y, z and what follows.
};

/// The function of that number, or null where it isn't known.
const InternalFunction* internal_function(std::uint32_t number);

/// Its operations on as many arguments as it has; `number` must be known.
Number build_internal_function(std::uint32_t number, std::span<const Number> arguments);

}  // namespace sundog::fields
