// SPDX-License-Identifier: Apache-2.0
// Whether triangles stand between two points, for who computes light without a picture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "base/vec.h"

namespace sundog::cpu {

/// An Embree scene of triangles alone, all of which stop light from both sides. Asking is thread-safe.
class TriangleOccluders {
public:
    /// `triangles` are indices into `positions`; neither is kept. Builds on `threads` threads (0: all). Errors:
    /// DeviceError.
    TriangleOccluders(std::span<const Vec3> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
                      int threads);
    TriangleOccluders(const TriangleOccluders&) = delete;
    TriangleOccluders& operator=(const TriangleOccluders&) = delete;
    ~TriangleOccluders();

    /// Whether a triangle is met between the two points. Who asks from a surface, or towards one, moves the ends off
    /// it.
    [[nodiscard]] bool between(Vec3 from, Vec3 to) const;

    /// The first in number of all triangles that are met between the two points; none if none is.
    [[nodiscard]] std::optional<std::uint32_t> first_between(Vec3 from, Vec3 to) const;

private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
};

}  // namespace sundog::cpu
