// SPDX-License-Identifier: Apache-2.0
// Which structure finds hits on the CPU.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sundog {

/// See device/accel for what each of ours is.
enum class Acceleration : std::uint8_t { embree, bvh, kdtree, octree, grid, boxes, none };

/// Their names on the command line, in the enumeration's order.
inline constexpr std::array<std::string_view, 7> kAccelerationNames{"embree", "bvh",   "kdtree", "octree",
                                                                    "grid",   "boxes", "none"};

constexpr std::string_view name_of(Acceleration a) { return kAccelerationNames[static_cast<std::size_t>(a)]; }

/// The one of that name; Embree for an unknown one (callers check names first).
constexpr Acceleration acceleration_named(std::string_view name) {
    for (std::size_t i = 0; i < kAccelerationNames.size(); ++i)
        if (kAccelerationNames[i] == name) return static_cast<Acceleration>(i);
    return Acceleration::embree;
}

}  // namespace sundog
