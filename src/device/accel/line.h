// SPDX-License-Identifier: Apache-2.0
// Where a ray passes planes and boxes: the only arithmetic that structures do with rays.
//
// All of it is monotone in single precision: of two planes, the one farther along the ray never gets the smaller t,
// since rounding keeps the order of differences and of products with one number. So a box inside another box (or on one
// side of a plane) gets an interval inside the other's, to the bit, and a structure that goes by these intervals can't
// lose a hit to rounding. That is why all structures find the same hits as no structure does.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/vec.h"
#include "device/bvh/node_hits.h"

namespace sundog::accel {

/// A stretch of a ray, both ends included.
struct Interval {
    float enter, leave;
    [[nodiscard]] bool empty() const { return !(enter <= leave); }
};

/// The line that a ray lies on.
struct Line {
    Vec3 origin;
    Vec3 inverse;  ///< 1 / direction, finite (kernel::finite_inverse).

    Line(kernel::vec3 from, kernel::vec3 direction)
        : origin{from.x, from.y, from.z},
          inverse{kernel::finite_inverse(direction.x), kernel::finite_inverse(direction.y),
                  kernel::finite_inverse(direction.z)} {}

    /// Where it passes the plane at `place` across `axis`.
    [[nodiscard]] float at(std::size_t axis, float place) const { return (place - origin[axis]) * inverse[axis]; }
};

/// The part of `range` in which the line is in the box (Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986).
inline Interval clip(const Bounds3& box, const Line& line, Interval range) {
    const auto axis = [&](float origin, float inverse, float lower, float upper) {
        const float a = (lower - origin) * inverse, b = (upper - origin) * inverse;
        range.enter = std::max(range.enter, std::min(a, b));
        range.leave = std::min(range.leave, std::max(a, b));
    };
    axis(line.origin.x, line.inverse.x, box.lower.x, box.upper.x);
    axis(line.origin.y, line.inverse.y, box.lower.y, box.upper.y);
    axis(line.origin.z, line.inverse.z, box.lower.z, box.upper.z);
    return range;
}

}  // namespace sundog::accel
