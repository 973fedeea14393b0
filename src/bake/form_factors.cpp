// SPDX-License-Identifier: Apache-2.0
#include "bake/form_factors.h"

#include <algorithm>
#include <cmath>

#include "bake/form_factor.h"

namespace sundog::bake {
namespace {

/// What takes less of the view than this is not asked for.
constexpr float kLeastShare = 1e-7F;
/// A triangle is divided at most so many times.
constexpr int kMostLevels = 3;

}  // namespace

float lift_of(std::span<const Vec3> positions) {
    float largest = 0;
    for (const Vec3 p : positions) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    // As the kernel's hit_error: 64 units in the last place of the largest number involved.
    return largest * 3.8146973e-6F;
}

FormFactors::FormFactors(const Surfaces& surfaces, const cpu::TriangleOccluders& occluders,
                         std::span<const float> detail)
    : tree_(surfaces.positions, surfaces.triangles), occluders_(occluders), lift_(lift_of(surfaces.positions)) {
    for (const TriangleIndices& t : surfaces.triangles) {
        const Corners corners{surfaces.positions[t[0]], surfaces.positions[t[1]], surfaces.positions[t[2]]};
        corners_.push_back(corners);
        faces_.push_back(normalize(cross(corners.b - corners.a, corners.c - corners.a)));
    }
    const std::vector<ElementTree::Node>& nodes = tree_.nodes();
    most_.resize(nodes.size(), kMostShare);
    // Children come after their parents.
    for (std::size_t n = detail.empty() ? 0 : nodes.size(); n-- > 0;)
        most_[n] =
            nodes[n].is_leaf() ? kMostShare / detail[nodes[n].middle] : std::min(most_[n + 1], most_[nodes[n].right]);
}

bool FormFactors::sees(const Receiver& receiver, Vec3 place, Vec3 normal) const {
    const float off = dot(normal, receiver.point - place) > 0 ? lift_ : -lift_;
    return !occluders_.between(receiver.origin, place + normal * off);
}

bool FormFactors::is_walled(Vec3 a, Vec3 b, Vec3 normal) const {
    const Vec3 off = normal * lift_;
    return occluders_.between(a + off, b + off) || occluders_.between(a - off, b - off);
}

float FormFactors::share_of(const Receiver& receiver, const Corners& t, Vec3 normal, float area, float most,
                            int level) const {
    // A surface doesn't see itself, though rounding may say so.
    if (!(std::abs(dot(normal, receiver.point - t.a)) > lift_)) return 0;
    const auto height = [&](Vec3 p) { return dot(receiver.normal, p - receiver.point); };
    if (!(height(t.a) > 0) && !(height(t.b) > 0) && !(height(t.c) > 0)) return 0;
    const Vec3 middle = (t.a + t.b + t.c) / 3;
    const auto distance2 = [](Vec3 way) { return dot(way, way); };
    const float radius2 = std::max({distance2(t.a - middle), distance2(t.b - middle), distance2(t.c - middle)});
    const bool is_far = distance2(middle - receiver.point) > 16 * radius2 && height(middle) > 0;
    const float share = is_far ? disc_form_factor(receiver.point, receiver.normal, middle, normal, area)
                               : triangle_form_factor(receiver.point, receiver.normal, t.a, t.b, t.c);
    if (share < kLeastShare) return 0;
    if (share <= 2 * most || level == kMostLevels) return sees(receiver, middle, normal) ? share : 0;
    const Vec3 ab = (t.a + t.b) * 0.5F, bc = (t.b + t.c) * 0.5F, ca = (t.c + t.a) * 0.5F;
    const auto part = [&](Vec3 a, Vec3 b, Vec3 c) {
        return share_of(receiver, {a, b, c}, normal, area / 4, most, level + 1);
    };
    return part(t.a, ab, ca) + part(ab, t.b, bc) + part(ca, bc, t.c) + part(ab, bc, ca);
}

float FormFactors::share_of(const Receiver& receiver, const ElementTree::Node& node, float most) {
    constexpr float kTooCoarse = -1;
    if (!node.is_flat()) return kTooCoarse;
    const Vec3 way = node.center - receiver.point;
    const float distance2 = dot(way, way);
    if (distance2 < 4 * node.radius * node.radius) return kTooCoarse;
    // At most, whichever part of the node one looks at.
    const float spread = node.radius / std::sqrt(distance2);
    const float height = std::min(dot(receiver.normal, way) / std::sqrt(distance2) + spread, 1.0F);
    const float facing = std::min(std::abs(dot(node.axis, way)) / std::sqrt(distance2) + spread, 1.0F);
    if (node.area * height * facing > most * kPi * distance2) return kTooCoarse;
    return disc_form_factor(receiver.point, receiver.normal, node.center, node.axis, node.projected);
}

void FormFactors::find(Vec3 point, Vec3 normal, Query& query) const {
    query.links.clear();
    query.stack.clear();
    const Receiver receiver{point, normal, point + normal * lift_};
    const std::vector<ElementTree::Node>& nodes = tree_.nodes();
    if (!nodes.empty()) query.stack.push_back(0);
    while (!query.stack.empty()) {
        const std::uint32_t number = query.stack.back();
        query.stack.pop_back();
        const ElementTree::Node& node = nodes[number];
        // All of it is below the horizon.
        if (dot(normal, node.center - point) + node.radius <= 0) continue;
        float share = 0;
        if (node.is_leaf()) {
            share = share_of(receiver, corners_[node.middle], faces_[node.middle], node.area, most_[number], 0);
        } else {
            share = share_of(receiver, node, most_[number]);
            if (share < 0) {
                query.stack.push_back(node.right);
                query.stack.push_back(number + 1);
                continue;
            }
            if (share < kLeastShare) continue;
            const Corners& t = corners_[node.middle];
            if (!sees(receiver, (t.a + t.b + t.c) / 3, faces_[node.middle])) continue;
        }
        if (!(share > 0)) continue;
        Link link{};
        link.node = number & 0x7fffffffU;
        link.back = dot(node.axis, point - node.center) > 0 ? 0U : 1U;
        link.share = share;
        query.links.push_back(link);
    }
}

}  // namespace sundog::bake
