// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sundog::bench {

/// Processor model, hardware threads and memory of this machine in one line, as Linux reports them ("unknown
/// processor" where it doesn't).
std::string machine_name();

/// The value of the first line "key : value" of a text like /proc/cpuinfo; empty if there is none.
std::string field_of(const std::string& text, const std::string& key);

}  // namespace sundog::bench
