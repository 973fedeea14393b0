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
            return Kind::quadric;
        case Numbers::disc:
            return Kind::disc;
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
    part.front_material = leaf.material;
    part.back_material = leaf.interior_material != scene::Solid::kInherited ? leaf.interior_material : leaf.material;
    const solids::ShapeNumbers numbers = leaf.shape->numbers();
    part.kind = kind_of(*leaf.shape, numbers.kind);
    if (part.kind != Kind::anything) {
        std::copy_n(numbers.values.begin(), std::min(numbers.values.size(), part.numbers.size()), part.numbers.begin());
        part.exact = part.kind != Kind::torus;
        part.all_shows = part.kind != Kind::disc && (part.kind != Kind::cone || leaf.shape->is_convex());
        return part;
    }
    const Bounds3d box = solids::joined(leaf.shape->bounds({}), leaf.shape->inside_bounds({}));
    if (box.empty() || !solids::is_finite(box)) return part;
    part.kind = Kind::box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double room = 1e-6 * (std::abs(box.lower[axis]) + std::abs(box.upper[axis])) + 1e-12;
        part.numbers[axis] = box.lower[axis] - room;
        part.numbers[axis + 3] = box.upper[axis] + room;
    }
    return part;
}

bool is_joined(const CompiledSolid::Node& node) {
    return node.combination == Combination::combined || node.combination == Combination::merged;
}

}  // namespace

QuickSolid::QuickSolid(const CompiledSolid& solid) {
    complete = make_complete(solid);
    if (complete) {
        set_conditions(solid, 0, {});
        plain = std::none_of(solid.leaves().begin(), solid.leaves().end(),
                             [](const CompiledSolid::Leaf& leaf) { return leaf.needs_uv; });
        return;
    }
    parts.clear();
    nodes.assign(1, {});
    make_stretches(solid, 0, 0);
    // A box along the world's axes tells no more than Embree's.
    const bool nothing = nodes[0].kind == QuickNode::Kind::anything ||
                         (nodes[0].kind == QuickNode::Kind::part && parts[nodes[0].first].kind == Kind::box &&
                          is_along_axes(parts[nodes[0].first].shape_from_world));
    if (nothing) nodes.clear();
}

/// All of the solid's nodes at their own numbers; false where there are too many, or some that can't be here.
bool QuickSolid::make_complete(const CompiledSolid& solid) {
    if (solid.nodes().size() > kMaxQuickNodes || solid.leaves().size() > kMaxQuickParts) return false;
    bool any_exact = false;
    for (const CompiledSolid::Node& node : solid.nodes()) {
        if (node.gate != CompiledSolid::kNoGate) return false;
        QuickNode out;
        out.inverted = node.inverted;
        out.first = node.first;
        out.count = node.count;
        out.kind = node.combination == Combination::leaf ? QuickNode::Kind::part
                   : is_joined(node)                     ? QuickNode::Kind::joined
                                                         : QuickNode::Kind::common;
        nodes.push_back(out);
    }
    for (std::uint32_t i = 0; i < solid.leaves().size(); ++i) {
        parts.push_back(part_of(solid, i));
        any_exact = any_exact || parts.back().exact;
    }
    return any_exact;
}

/// Tells the parts at and below a node when they are seen; `above` has what the nodes above say of that.
// NOLINTNEXTLINE(misc-no-recursion): as deep as kMaxQuickNodes
void QuickSolid::set_conditions(const CompiledSolid& solid, std::size_t index, QuickPart above) {
    const CompiledSolid::Node& node = solid.nodes()[index];
    above.flips = above.flips != node.inverted;
    if (node.combination == Combination::leaf) {
        parts[node.first].flips = above.flips;
        parts[node.first].shows = above.shows;
        parts[node.first].conditions = std::move(above.conditions);
        return;
    }
    for (std::uint32_t child = 0; child < node.count; ++child) {
        QuickPart below = above;
        below.shows = above.shows && (node.combination != Combination::clipped || child == 0);
        for (std::uint32_t other = 0; other < node.count; ++other)
            if (other != child && node.combination != Combination::combined)
                below.conditions.push_back({node.first + other, node.combination != Combination::merged});
        set_conditions(solid, node.first + child, std::move(below));
    }
}

/// Makes node `to` of what is known of where solid.nodes()[from] is.
// NOLINTNEXTLINE(misc-no-recursion): as deep as kMaxQuickNodes
void QuickSolid::make_stretches(const CompiledSolid& solid, std::size_t from, std::size_t to) {
    const CompiledSolid::Node& node = solid.nodes()[from];
    if (node.inverted) return;
    if (node.combination == Combination::leaf) {
        const QuickPart part = part_of(solid, node.first);
        if (part.kind == Kind::anything || parts.size() == kMaxQuickParts) return;
        nodes[to].kind = QuickNode::Kind::part;
        nodes[to].first = static_cast<std::uint32_t>(parts.size());
        parts.push_back(part);
        return;
    }
    const bool joined = is_joined(node);
    std::vector<std::uint32_t> children;
    for (std::uint32_t i = 0; i < node.count; ++i)
        if (joined || !solid.nodes()[node.first + i].inverted) children.push_back(node.first + i);
    if (nodes.size() + children.size() > kMaxQuickNodes) return;
    const std::size_t first = nodes.size();
    nodes.resize(first + children.size());
    for (std::size_t i = 0; i < children.size(); ++i) make_stretches(solid, children[i], first + i);
    std::size_t known = 0;
    for (std::size_t i = 0; i < children.size(); ++i)
        known += nodes[first + i].kind != QuickNode::Kind::anything ? 1 : 0;
    if (known == 0 || (joined && known < children.size())) return;
    nodes[to].kind = joined ? QuickNode::Kind::joined : QuickNode::Kind::common;
    nodes[to].first = static_cast<std::uint32_t>(first);
    nodes[to].count = static_cast<std::uint32_t>(children.size());
}

}  // namespace sundog::cpu
