// SPDX-License-Identifier: Apache-2.0
// Boxes that may reach to infinity.
#pragma once

#include <algorithm>

#include "base/vec3d.h"
#include "solids/ray.h"

namespace sundog::solids {

inline Bounds3d everywhere() { return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}}; }
inline bool is_finite(const Bounds3d& b) { return sundog::is_finite(b.lower) && sundog::is_finite(b.upper); }
inline bool contains(const Bounds3d& b, Vec3d p) {
    return p.x >= b.lower.x && p.x <= b.upper.x && p.y >= b.lower.y && p.y <= b.upper.y && p.z >= b.lower.z &&
           p.z <= b.upper.z;
}
/// The smallest box around both.
Bounds3d joined(const Bounds3d& a, const Bounds3d& b);
/// What both have in common; empty where nothing.
Bounds3d common(const Bounds3d& a, const Bounds3d& b);
/// The box around a carried box; infinite sides stay infinite.
Bounds3d transformed(const Affine3d& m, const Bounds3d& b);
/// Grown by so little that only rounding needs it (a billionth of its size and place).
Bounds3d padded(const Bounds3d& b);

/// The part of `range` in which the ray is in the box; empty where it misses it. `inverse` is of the ray's direction.
inline Range clip(const Bounds3d& b, const Ray& ray, Vec3d inverse, Range range) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis];
        if (ray.direction[axis] == 0) {
            if (o < b.lower[axis] || o > b.upper[axis]) return {1, 0};
            continue;
        }
        const double t0 = (b.lower[axis] - o) * inverse[axis];
        const double t1 = (b.upper[axis] - o) * inverse[axis];
        range.lower = std::max(range.lower, std::min(t0, t1));
        range.upper = std::min(range.upper, std::max(t0, t1));
    }
    return range;
}
inline Range clip(const Bounds3d& b, const WorldRay& ray, Range range) { return clip(b, ray, ray.inverse, range); }
inline Range clip(const Bounds3d& b, const Ray& ray, Range range) {
    return clip(b, ray, {1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z}, range);
}

}  // namespace sundog::solids
