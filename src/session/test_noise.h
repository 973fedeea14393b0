// SPDX-License-Identifier: Apache-2.0
// Noise for tests: the same numbers each time.
#pragma once

#include <cstdint>

namespace sundog {

/// Uniform in [0, 1).
inline float random_number(int x, int y, std::uint32_t sample) {
    std::uint64_t bits = static_cast<std::uint64_t>(x * 4096 + y) << 32U | sample;  // SplitMix64
    for (int i = 0; i < 2; ++i) {
        bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
        bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    }
    return static_cast<float>(bits >> 40U) * 0x1p-24F;
}

}  // namespace sundog
