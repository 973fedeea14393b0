// SPDX-License-Identifier: Apache-2.0
// A bounding volume hierarchy over a few to a few thousand boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solids/bounds.h"

namespace sundog::solids {

class BoundsTree {
public:
    BoundsTree() = default;
    /// Over boxes of any size, infinite ones too; empty boxes are never visited.
    explicit BoundsTree(std::span<const Bounds3d> boxes);

    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    [[nodiscard]] Bounds3d bounds() const { return nodes_.empty() ? Bounds3d{} : nodes_[0].box; }

    /// Calls visit(index) for every box that the ray meets within `range`, in no special order. visit may shorten
    /// range.upper, and what lies behind is passed over then.
    template <class Visit>
    void along(const Ray& ray, Range& range, const Visit& visit) const {
        along(ray, {1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z}, range, visit);
    }
    /// The same with the inverse of the ray's direction, where it is known.
    template <class Visit>
    void along(const Ray& ray, Vec3d inverse, Range& range, const Visit& visit) const {
        if (nodes_.empty()) return;
        SmallVector<std::uint32_t, 64> stack;
        stack.push_back(0);
        while (!stack.empty()) {
            const Node& node = nodes_[stack.back()];
            const auto self = static_cast<std::uint32_t>(&node - nodes_.data());
            stack.pop_back();
            if (clip(node.box, ray, inverse, range).empty()) continue;
            if (node.count > 0) {
                for (std::uint32_t i = 0; i < node.count; ++i) {
                    const Item& item = items_[node.first + i];
                    if (!clip(item.box, ray, inverse, range).empty()) visit(item.index);
                }
                continue;
            }
            // The nearer half first: it is popped first when pushed last.
            const bool forward = ray.direction[node.axis] >= 0;
            stack.push_back(forward ? node.first : self + 1);
            stack.push_back(forward ? self + 1 : node.first);
        }
    }
    /// Calls visit(index) for every box that holds the point, until it returns true.
    template <class Visit>
    bool any_at(Vec3d point, const Visit& visit) const {
        if (nodes_.empty()) return false;
        SmallVector<std::uint32_t, 64> stack;
        stack.push_back(0);
        while (!stack.empty()) {
            const Node& node = nodes_[stack.back()];
            const auto self = static_cast<std::uint32_t>(&node - nodes_.data());
            stack.pop_back();
            if (!contains(node.box, point)) continue;
            if (node.count == 0) {
                stack.push_back(node.first);
                stack.push_back(self + 1);
                continue;
            }
            for (std::uint32_t i = 0; i < node.count; ++i) {
                const Item& item = items_[node.first + i];
                if (contains(item.box, point) && visit(item.index)) return true;
            }
        }
        return false;
    }

private:
    struct Node {
        Bounds3d box;
        std::uint32_t first = 0;  ///< Leaf: into items_. Else the second child; the first follows its parent.
        std::uint16_t count = 0;  ///< Items of a leaf; 0 for an inner node.
        std::uint16_t axis = 0;   ///< Along which an inner node's halves lie.
    };
    struct Item {
        Bounds3d box;
        std::uint32_t index;
    };
    void build(std::uint32_t first, std::uint32_t count);

    std::vector<Node> nodes_;
    std::vector<Item> items_;
};

}  // namespace sundog::solids
