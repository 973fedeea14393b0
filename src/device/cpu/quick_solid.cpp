// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/quick_solid.h"

#include <algorithm>

namespace sundog::cpu {
namespace {

using solids::Combination;
using solids::CompiledSolid;
using Kind = QuickPart::Kind;

Kind kind_of(const solids::Shape& shape, solids::ShapeNumbers::Kind kind) {
    using Numbers = solids::ShapeNumbers::Kind;
    switch (kind) {
        case Numbers::sphere:
            return Kind::sphere;
        case Numbers::box:
            return shape.is_convex() ? Kind::box : Kind::anything;
        case Numbers::half_space:
            return Kind::half_space;
        case Numbers::cone:
            return Kind::cone;
        case Numbers::quadric:
            return shape.is_convex() ? Kind::quadric : Kind::anything;
        case Numbers::torus:
            return Kind::torus;
        default:
            return Kind::anything;
    }
}

bool is_along_axes(const Affine3d& m) {
    return m.x.y == 0 && m.x.z == 0 && m.y.x == 0 && m.y.z == 0 && m.z.x == 0 && m.z.y == 0;
}

/// The part for a leaf. Shapes of which no more is known are their boxes, in their own space; of those that even lack
/// an end the kind stays `anything`.
QuickPart part_of(const CompiledSolid& solid, std::uint32_t index) {
    const CompiledSolid::Leaf& leaf = solid.leaves()[index];
    QuickPart part;
    part.leaf = index;
    part.shape_from_world = leaf.shape_from_world;
    const solids::ShapeNumbers numbers = leaf.shape->numbers();
    part.kind = kind_of(*leaf.shape, numbers.kind);
    if (part.kind != Kind::anything) {
        std::copy_n(numbers.values.begin(), std::min(numbers.values.size(), part.numbers.size()), part.numbers.begin());
        return part;
    }
    const Bounds3d box = leaf.shape->bounds({});
    if (box.empty() || !solids::is_finite(box)) return part;
    part.kind = Kind::box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double room = 1e-6 * (std::abs(box.lower[axis]) + std::abs(box.upper[axis])) + 1e-12;
        part.numbers[axis] = box.lower[axis] - room;
        part.numbers[axis + 3] = box.upper[axis] + room;
    }
    return part;
}

bool is_exact(const QuickPart& part, const CompiledSolid& solid) {
    return part.kind != Kind::anything && part.kind != Kind::torus && solid.leaves()[part.leaf].shape->is_convex() &&
           solid.leaves()[part.leaf].shape->numbers().kind != solids::ShapeNumbers::Kind::none;
}

}  // namespace

QuickSolid::QuickSolid(const CompiledSolid& solid) {
    if (make_exact(solid)) return;
    parts.clear();
    nodes.emplace_back();
    make_node(solid, 0, 0);
    // A box along the world's axes tells no more than Embree's.
    const bool nothing = nodes[0].kind == QuickNode::Kind::anything ||
                         (nodes[0].kind == QuickNode::Kind::part && parts[nodes[0].first].kind == Kind::box &&
                          is_along_axes(parts[nodes[0].first].shape_from_world));
    if (nothing) nodes.clear();
}

bool QuickSolid::make_exact(const CompiledSolid& solid) {
    const CompiledSolid::Node& root = solid.nodes()[0];
    if (root.inverted || root.gate != CompiledSolid::kNoGate) return false;
    const bool leaf = root.combination == Combination::leaf;
    if (!leaf && !root.convex_parts && !root.convex_clips) return false;
    if (!leaf && root.count > kMaxExactParts) return false;
    bool keeps = false;
    for (std::uint32_t i = 0; i < (leaf ? 1 : root.count); ++i) {
        const CompiledSolid::Node& node = leaf ? root : solid.nodes()[root.first + i];
        if (node.combination != Combination::leaf || node.gate != CompiledSolid::kNoGate) return false;
        if (node.inverted && root.convex_clips) return false;
        QuickPart part = part_of(solid, node.first);
        if (!is_exact(part, solid)) return false;
        part.role = node.inverted                ? QuickPart::Role::cut
                    : root.convex_clips && i > 0 ? QuickPart::Role::clip
                                                 : QuickPart::Role::keep;
        keeps = keeps || !node.inverted;
        parts.push_back(part);
    }
    exact = keeps;
    return exact;
}

/// Makes node `to` of what solid.nodes()[from] is.
void QuickSolid::make_node(const CompiledSolid& solid, std::size_t from, std::size_t to) {
    const CompiledSolid::Node& node = solid.nodes()[from];
    if (node.inverted) return;
    if (node.combination == Combination::leaf) {
        const QuickPart part = part_of(solid, node.first);
        if (part.kind == Kind::anything) return;
        nodes[to].kind = QuickNode::Kind::part;
        nodes[to].first = static_cast<std::uint32_t>(parts.size());
        parts.push_back(part);
        return;
    }
    const bool joined = node.combination == Combination::combined || node.combination == Combination::merged;
    std::vector<std::uint32_t> children;
    for (std::uint32_t i = 0; i < node.count; ++i)
        if (joined || !solid.nodes()[node.first + i].inverted) children.push_back(node.first + i);
    if (nodes.size() + children.size() > kMaxQuickNodes) return;
    const std::size_t first = nodes.size();
    nodes.resize(first + children.size());
    for (std::size_t i = 0; i < children.size(); ++i) make_node(solid, children[i], first + i);
    const auto knows = [&](std::size_t i) { return nodes[first + i].kind != QuickNode::Kind::anything; };
    std::size_t known = 0;
    for (std::size_t i = 0; i < children.size(); ++i) known += knows(i) ? 1 : 0;
    if (known == 0 || (joined && known < children.size())) return;
    nodes[to].kind = joined ? QuickNode::Kind::joined : QuickNode::Kind::common;
    nodes[to].first = static_cast<std::uint32_t>(first);
    nodes[to].count = static_cast<std::uint32_t>(children.size());
}

}  // namespace sundog::cpu
