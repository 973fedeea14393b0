// SPDX-License-Identifier: Apache-2.0
// The functions that POV-Ray's functions.inc declares by number.
#pragma once

#include <cstdint>
#include <string_view>

namespace sundog::pov {

struct InternalFunction {
    std::uint32_t number;          ///< As in `internal(number)`.
    std::string_view name;         ///< As functions.inc calls it.
    std::uint32_t argument_count;  ///< x, y, z and what follows.
    double (*value)(const double* arguments);
};

/// The function of that number, or null where it isn't known (yet).
const InternalFunction* internal_function(std::uint32_t number);

}  // namespace sundog::pov
