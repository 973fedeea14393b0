// SPDX-License-Identifier: Apache-2.0
#include "solids/bounds_tree.h"

#include <algorithm>
#include <cmath>

namespace sundog::solids {
namespace {

constexpr std::uint32_t kLeafSize = 4;

/// Middle of a box along an axis; of an infinite one, its finite end or 0.
double middle(const Bounds3d& b, std::size_t axis) {
    const double low = b.lower[axis];
    const double high = b.upper[axis];
    if (std::isfinite(low) && std::isfinite(high)) return 0.5 * low + 0.5 * high;
    return std::isfinite(low) ? low : std::isfinite(high) ? high : 0;
}

}  // namespace

BoundsTree::BoundsTree(std::span<const Bounds3d> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty()) items_.push_back({padded(boxes[i]), static_cast<std::uint32_t>(i)});
    if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
}

void BoundsTree::build(std::uint32_t first, std::uint32_t count) {
    const std::size_t self = nodes_.size();
    nodes_.emplace_back();
    Bounds3d box;
    Bounds3d middles;
    for (std::uint32_t i = first; i < first + count; ++i) {
        box = joined(box, items_[i].box);
        middles.include({middle(items_[i].box, 0), middle(items_[i].box, 1), middle(items_[i].box, 2)});
    }
    nodes_[self].box = box;
    if (count <= kLeafSize) {
        nodes_[self].first = first;
        nodes_[self].count = static_cast<std::uint16_t>(count);
        return;
    }
    const Vec3d extent = middles.upper - middles.lower;
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    // Halves of equal number keep the tree's depth at the logarithm, whatever the boxes are.
    const std::uint32_t half = count / 2;
    const auto begin = items_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [axis](const Item& a, const Item& b) {
        const double ma = middle(a.box, axis);
        const double mb = middle(b.box, axis);
        return ma != mb ? ma < mb : a.index < b.index;
    });
    nodes_[self].axis = static_cast<std::uint16_t>(axis);
    build(first, half);
    nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
    build(first + half, count - half);
}

}  // namespace sundog::solids
