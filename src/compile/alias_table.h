// SPDX-License-Identifier: Apache-2.0
// Walker's alias method (An Efficient Method for Generating Discrete Random Variables with General Distributions,
// 1977), set up as Vose does (1991): entries drawn by weight in constant time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sundog {

/// An entry is drawn evenly; it stands for itself in the share `keep` of the cases, else for entry `alias`.
struct AliasEntry {
    float keep = 1;
    std::uint32_t alias = 0;
};

/// The table of weights that are not negative and have a finite sum above 0; as long as they are.
std::vector<AliasEntry> alias_table(std::span<const double> weights);

}  // namespace sundog
