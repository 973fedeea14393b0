// SPDX-License-Identifier: Apache-2.0
#include "bake/form_factors.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
    walled_.resize(surfaces.triangles.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, walled_.size(), 256), [&](const auto& range) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) {
            const Vec3 middle = middle_of(corners_[t]);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = surfaces.triangles[t][k];
                // If that isn't in the plane, short of the corner, which may be the wall's as well.
                const Vec3 inside = surfaces.inside[v], near = surfaces.positions[v] * 0.9F + middle * 0.1F;
                const bool in_plane = std::abs(dot(faces_[t], inside - middle)) < lift_;
                if (is_walled(middle, in_plane ? inside : near, faces_[t])) walled_[t] |= 1U << k;
            }
        }
    });
    for (std::uint32_t t = 0; t < walled_.size(); ++t)
        if (walled_[t] != 0) divided_.push_back(t);
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

Vec3 FormFactors::part_above(const Receiver& receiver, Corners t) {
    const auto height = [&](Vec3 p) { return dot(receiver.normal, p - receiver.point); };
    if (height(t.b) > height(t.a)) std::swap(t.a, t.b);
    if (height(t.c) > height(t.a)) std::swap(t.a, t.c);
    const auto towards = [&](Vec3 p) {
        const float top = height(t.a), bottom = height(p);
        return bottom < 0 ? t.a + (p - t.a) * (top / (top - bottom)) : p;
    };
    return (t.a + towards(t.b) + towards(t.c)) / 3;
}

void FormFactors::add_share(const Receiver& receiver, std::uint32_t triangle, const Corners& t, float area, float most,
                            int level, Shares& shares) const {
    const Vec3 normal = faces_[triangle];
    // A surface doesn't see itself, though rounding may say so.
    if (!(std::abs(dot(normal, receiver.point - t.a)) > lift_)) return;
    const auto height = [&](Vec3 p) { return dot(receiver.normal, p - receiver.point); };
    const float lowest = std::min({height(t.a), height(t.b), height(t.c)});
    if (!(std::max({height(t.a), height(t.b), height(t.c)}) > 0)) return;
    const Vec3 middle = middle_of(t);
    const auto distance2 = [](Vec3 way) { return dot(way, way); };
    const float radius2 = std::max({distance2(t.a - middle), distance2(t.b - middle), distance2(t.c - middle)});
    const bool is_far = distance2(middle - receiver.point) > 16 * radius2 && lowest >= 0;
    const float share = is_far ? disc_form_factor(receiver.point, receiver.normal, middle, normal, area)
                               : triangle_form_factor(receiver.point, receiver.normal, t.a, t.b, t.c);
    if (share < kLeastShare) return;
    if (share <= 2 * most || level == kMostLevels) {
        const Vec3 place = height(middle) > 0 ? middle : part_above(receiver, t);
        if (!sees(receiver, place, normal)) return;
        const bool is_beyond = walled_[triangle] != 0 && is_walled(middle_of(corners_[triangle]), place, normal);
        (is_beyond ? shares.beyond : shares.here) += share;
        return;
    }
    const Vec3 ab = (t.a + t.b) * 0.5F, bc = (t.b + t.c) * 0.5F, ca = (t.c + t.a) * 0.5F;
    for (const Corners& part : {Corners{t.a, ab, ca}, {ab, t.b, bc}, {ca, bc, t.c}, {ab, bc, ca}})
        add_share(receiver, triangle, part, area / 4, most, level + 1, shares);
}

Vec3 FormFactors::place_of(const Receiver& receiver, const ElementTree::Node& node) const {
    const Vec3 middle = middle_of(corners_[node.middle]);
    const float height = dot(receiver.normal, middle - receiver.point);
    if (height > 0 || !node.is_plane()) return middle;
    // Up the plane, into the part of it that is above.
    const Vec3 up = receiver.normal - node.axis * dot(receiver.normal, node.axis);
    const float slope2 = dot(up, up);
    const float reach = std::sqrt(slope2) * std::sqrt(node.area * (0.75F / kPi));
    return slope2 > 0 ? middle + up * ((std::max(reach + height, 0.0F) / 2 - height) / slope2) : middle;
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
    // Where the horizon cuts it, little is known of what is above.
    const bool is_cut = std::abs(dot(receiver.normal, way)) < node.radius;
    if (node.area * height * facing > (is_cut ? 0.25F * most : most) * kPi * distance2) return kTooCoarse;
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
        const std::uint32_t back = dot(node.axis, point - node.center) > 0 ? 0 : 1;
        const auto add = [&](std::size_t to, float share) {
            Link link{};
            link.node = static_cast<std::uint32_t>(to) & 0x7fffffffU;
            link.back = back & 1U;
            link.share = share;
            if (share > 0) query.links.push_back(link);
        };
        if (node.is_leaf()) {
            Shares shares;
            add_share(receiver, node.middle, corners_[node.middle], node.area, most_[number], 0, shares);
            add(number, shares.here);
            if (shares.beyond > 0) {
                const auto at = std::lower_bound(divided_.begin(), divided_.end(), node.middle) - divided_.begin();
                add(nodes.size() + static_cast<std::size_t>(at), shares.beyond);
            }
            continue;
        }
        const float share = share_of(receiver, node, most_[number]);
        if (share < 0) {
            query.stack.push_back(node.right);
            query.stack.push_back(number + 1);
        } else if (share >= kLeastShare && sees(receiver, place_of(receiver, node), faces_[node.middle])) {
            add(number, share);
        }
    }
}

}  // namespace sundog::bake
