// SPDX-License-Identifier: Apache-2.0
// How many samples a pixel gets in one pass over the picture. Freestanding.
#pragma once

#include <cstdint>

namespace sundog::sampling {

/// Most samples that a pixel gets in one pass.
inline constexpr std::uint32_t kLargestPass = 16;

/// Size of the pass that begins after `done` samples a pixel, of `total`: 1, 1, 2, 4, 8, 16, 16, …, and what is
/// left at the end; 0 when done. So a first picture stands early and later passes cost little overhead. It depends
/// on nothing but its arguments: sums of floats are grouped by passes, so timing must not change them.
constexpr std::uint32_t pass_size(std::uint32_t done, std::uint32_t total) {
    if (done >= total) return 0;
    const std::uint32_t doubling = done == 0 ? 1 : done;
    const std::uint32_t wanted = doubling < kLargestPass ? doubling : kLargestPass;
    return wanted < total - done ? wanted : total - done;
}

}  // namespace sundog::sampling
