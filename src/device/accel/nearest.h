// SPDX-License-Identifier: Apache-2.0
// The nearest of the hits that a ray's tests find, in whatever order they come.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "base/vec.h"

namespace sundog::accel {

/// A hit, as kernel::Hit, before the geometry's first primitive is added.
struct Found {
    float t = 0, u = 0, v = 0;
    std::uint32_t geometry = 0;
    std::uint32_t primitive = 0;  ///< In its geometry; of a solid: its material.
    Vec3 normal;                  ///< In the space that the geometry was traced in.
    bool leaves = false;          ///< The ray leaves a solid shape here.
};

/// Hits within kCoincident of the nearest one are at one place, and the first of them in order counts: what is left
/// before what is entered, then what was written first. Which of them were found first makes no difference.
class Nearest {
public:
    explicit Nearest(float t_max) : reach_(t_max) {}

    /// Hits beyond this are of no use any more.
    [[nodiscard]] float reach() const { return reach_; }
    [[nodiscard]] bool found() const { return count_ > 0; }
    /// The one that counts; there must be one.
    [[nodiscard]] const Found& best() const { return hits_[count_ - 1]; }

    void enter(const Found& hit);

private:
    /// Within a relative distance of 1e-6 there are 17 floats at most.
    static constexpr std::size_t kMost = 20;
    float reach_;
    /// Ascending by t; each comes before all nearer ones in order, so that it counts if they turn out too near to it.
    std::array<Found, kMost> hits_;
    std::size_t count_ = 0;
};

}  // namespace sundog::accel
