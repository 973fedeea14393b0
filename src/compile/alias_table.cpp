// SPDX-License-Identifier: Apache-2.0
#include "compile/alias_table.h"

#include <numeric>

namespace sundog {

std::vector<AliasEntry> alias_table(std::span<const double> weights) {
    const std::size_t count = weights.size();
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<AliasEntry> table(count);
    std::vector<double> share(count);
    std::vector<std::uint32_t> poor, rich;
    for (std::size_t i = 0; i < count; ++i) {
        share[i] = weights[i] / sum * static_cast<double>(count);
        table[i].alias = static_cast<std::uint32_t>(i);
        (share[i] < 1 ? poor : rich).push_back(static_cast<std::uint32_t>(i));
    }
    while (!poor.empty() && !rich.empty()) {
        const std::uint32_t low = poor.back(), high = rich.back();
        poor.pop_back();
        table[low] = {static_cast<float>(share[low]), high};
        share[high] -= 1 - share[low];
        if (share[high] < 1) {
            rich.pop_back();
            poor.push_back(high);
        }
    }
    // What rounding leaves is full.
    return table;
}

}  // namespace sundog
