// SPDX-License-Identifier: Apache-2.0
// Rays, and what they meet on a shape.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/vec3d.h"
#include "solids/small_vector.h"

namespace sundog::solids {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Points origin + t*direction. The direction need not be a unit vector, so t is the same in every space that the ray
/// is carried to.
struct Ray {
    Vec3d origin, direction;
    [[nodiscard]] Vec3d at(double t) const { return origin + direction * t; }
};

inline Ray transform_ray(const Affine3d& m, const Ray& ray) {
    return {transform_point(m, ray.origin), transform_vector(m, ray.direction)};
}

/// A ray with what is asked of it again and again on its way through a solid's nodes.
struct WorldRay : Ray {
    Vec3d inverse;    ///< Of the direction; infinite along axes where that is 0.
    double distance;  ///< Of the ray's origin from the world's, in steps of the direction.
    explicit WorldRay(const Ray& ray)
        : Ray(ray),
          inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z},
          distance(std::sqrt(dot(ray.origin, ray.origin) / dot(ray.direction, ray.direction))) {}
};

/// An interval of a ray's parameter; crossings at its ends don't count.
struct Range {
    double lower = 0, upper = kInfinity;
    [[nodiscard]] bool contains(double t) const { return t > lower && t < upper; }
    /// Not even one point: an interval of no length (through a flat box) has one.
    [[nodiscard]] bool empty() const { return !(lower <= upper); }
};

/// A place where a ray meets a shape's boundary.
struct Crossing {
    double t = 0;
    double u = 0, v = 0;     ///< The shape's own: where on the part.
    std::uint32_t part = 0;  ///< The shape's own: which of its faces or segments.
    bool toggles = true;     ///< The ray changes between inside and outside; a mere surface has no inside.
    bool visible = true;     ///< A surface is there; false where an open shape lacks its end.
};

using CrossingList = SmallVector<Crossing, 8>;

/// Appends the ends of one interval that lie in `range`, and tells whether the ray is inside at range.lower. `lower`
/// and `upper` are crossings with lower.t <= upper.t.
inline bool append_interval(const Crossing& lower, const Crossing& upper, Range range, CrossingList& out) {
    const bool starts_inside = lower.t <= range.lower && upper.t > range.lower;
    if (range.contains(lower.t)) out.push_back(lower);
    // Not asked of the upper end alone: an interval that begins after the range does not end in it.
    if (range.contains(upper.t) && lower.t < range.upper) out.push_back(upper);
    return starts_inside;
}

/// The stretch of a ray that is inside a convex shape, as far as it lies in a range: between two crossings, or from or
/// to beyond the range.
struct Stretch {
    Crossing lower, upper;
    bool begins = false, ends = false;  ///< Whether `lower` and `upper` are there.
};

/// The part in `range` of what is inside between two crossings with lower.t <= upper.t; false where there is none.
inline bool stretch_between(const Crossing& lower, const Crossing& upper, Range range, Stretch& out) {
    out.begins = range.contains(lower.t);
    out.ends = range.contains(upper.t) && lower.t < range.upper;
    if (out.begins) out.lower = lower;
    if (out.ends) out.upper = upper;
    return out.begins || (lower.t <= range.lower && upper.t > range.lower);
}

}  // namespace sundog::solids
