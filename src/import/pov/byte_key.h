// SPDX-License-Identifier: Apache-2.0
// Keys of what was made before, so that what is equal is made once.
#pragma once

#include <string>

namespace sundog::pov {

/// Appends what numbers, addresses and plain structs without gaps consist of: equal for equal values.
template <class... Values>
void append_bytes(std::string& key, const Values&... values) {
    // NOLINTNEXTLINE(bugprone-sizeof-expression): of addresses, too
    (key.append(reinterpret_cast<const char*>(&values), sizeof(values)), ...);
}

}  // namespace sundog::pov
