// SPDX-License-Identifier: Apache-2.0
// Damage to texts: the same for the same seed on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace sundog::fuzz {

/// `text` after a few changes: characters changed, parts left out, repeated or moved, pieces of `others` and numbers
/// that are hard to bear put in.
std::string mutated(std::string text, std::span<const std::string> others, std::uint64_t seed);

}  // namespace sundog::fuzz
