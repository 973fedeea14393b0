// SPDX-License-Identifier: Apache-2.0
#include "bake/form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/vec3d.h"

namespace sundog::bake {
namespace {

/// A triangle cut by a plane has at most four corners.
struct Polygon {
    std::array<Vec3d, 4> corners;
    std::size_t count = 0;
    void add(Vec3d corner) { corners[count++] = corner; }
};

/// What of a triangle is above the plane through the origin with that normal.
Polygon above_horizon(const std::array<Vec3d, 3>& triangle, Vec3d normal) {
    Polygon above;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d from = triangle[i], to = triangle[(i + 1) % 3];
        const double height = dot(from, normal), next = dot(to, normal);
        if (height >= 0) above.add(from);
        if ((height >= 0) != (next >= 0)) above.add(from + (to - from) * (height / (height - next)));
    }
    return above;
}

}  // namespace

float disc_form_factor(Vec3 point, Vec3 normal, Vec3 center, Vec3 axis, float area) {
    const Vec3 way = center - point;
    const float distance2 = dot(way, way);
    const float height = dot(normal, way);
    const float parallel = dot(normal, axis);
    // Heights of a disc's points spread as much as if they lay evenly within this of its middle's.
    const float reach = std::sqrt(area * std::max(1 - parallel * parallel, 0.0F) * (0.75F / kPi));
    if (!(height > -reach)) return 0;
    const bool is_cut = height < reach;
    const float above = is_cut ? (height + reach) / (2 * reach) : 1;
    const float mean_height = is_cut ? above * above * reach : height;
    const float per_distance = 1 / std::sqrt(distance2);
    const float cosine = mean_height * per_distance, cosine_there = dot(axis, way) * per_distance;
    const float size = area / (kPi * distance2);
    const float oblique = cosine * (2 - 3 * cosine_there * cosine_there) + parallel * cosine_there;
    return std::max(size * std::abs(cosine_there) * (cosine + above * size * oblique) / (1 + size), 0.0F);
}

float triangle_form_factor(Vec3 point, Vec3 normal, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3d from = to_double(point), n = to_double(normal);
    const Polygon seen = above_horizon({to_double(a) - from, to_double(b) - from, to_double(c) - from}, n);
    double sum = 0;
    for (std::size_t i = 0; i < seen.count; ++i) {
        const Vec3d r = seen.corners[i], s = seen.corners[(i + 1) % seen.count];
        const Vec3d across = cross(r, s);
        const double size = length(across);
        if (size > 0) sum += std::atan2(size, dot(r, s)) * dot(n, across) / size;
    }
    return static_cast<float>(std::abs(sum) / (2 * std::numbers::pi));
}

}  // namespace sundog::bake
