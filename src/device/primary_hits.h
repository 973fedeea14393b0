// SPDX-License-Identifier: Apache-2.0
// How the CPU finds what the eye sees.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sundog {

/// automatic: by scan conversion where that is faster, else by tracing; raster: by scan conversion wherever it can be.
enum class PrimaryHits : std::uint8_t { automatic, trace, raster };

/// Their names on the command line, in the enumeration's order.
inline constexpr std::array<std::string_view, 3> kPrimaryHitsNames{"auto", "trace", "raster"};

/// The one of that name; automatic for an unknown one (callers check names first).
constexpr PrimaryHits primary_hits_named(std::string_view name) {
    for (std::size_t i = 0; i < kPrimaryHitsNames.size(); ++i)
        if (kPrimaryHitsNames[i] == name) return static_cast<PrimaryHits>(i);
    return PrimaryHits::automatic;
}

}  // namespace sundog
