// SPDX-License-Identifier: Apache-2.0
// Triangles in groups, and groups of groups, so that what is far away can send its light as one.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace sundog::bake {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// A binary tree over triangles, divided by the directions that they face before the places where they are.
/// Deterministic.
class ElementTree {
public:
    struct Node {
        Vec3 center;                 ///< Of its area.
        float radius;                ///< Of a ball around the centre that holds it all.
        Vec3 axis;                   ///< Unit: the mean normal.
        float area;                  ///< Of its triangles.
        float thickness;             ///< How far it reaches off the plane through its centre across its axis.
        float projected;             ///< Of its triangles as seen along the axis.
        std::uint32_t first, count;  ///< Its triangles: places in order().
        std::uint32_t right;         ///< Its second child; the first one is the next node. 0: one triangle.
        std::uint32_t middle;        ///< The triangle whose middle is nearest to the centre.
        /// As good as a plane: its triangles face one way, and none is far behind others.
        [[nodiscard]] bool is_flat() const { return projected > 0.95F * area && thickness < 0.25F * radius; }
        /// Its triangles lie in one plane.
        [[nodiscard]] bool is_plane() const { return projected > 0.9999F * area && thickness < 1e-3F * radius; }
        [[nodiscard]] bool is_leaf() const { return right == 0; }
    };

    /// `triangles` are indices into `positions`; neither is kept.
    ElementTree(std::span<const Vec3> positions, std::span<const TriangleIndices> triangles);

    /// The root is the first; children come after their parents. Empty where there are no triangles.
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

private:
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace sundog::bake
