// SPDX-License-Identifier: Apache-2.0
#include "device/bvh/build.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "device/bvh/encode.h"
#include "device/bvh/split.h"

namespace sundog::bvh {
namespace {

using kernel::BVH_MAX_DEPTH;
using kernel::BVH_MAX_LEAF;
using kernel::BVH_WIDTH;

/// Nodes over fewer primitives are built by one thread.
constexpr std::size_t kParallelCount = 1U << 12U;
/// Coordinates beyond this are taken as this, so that no sum or difference of two overflows.
constexpr float kLargestCoordinate = 1e37F;

/// A subtree whose node and primitive numbers start from 0; nodes[0] is its top.
struct Subtree {
    std::vector<kernel::WideNode> nodes;
    std::vector<std::uint32_t> order;
    std::uint32_t depth = 0;
};

/// Most primitives that a subtree can take whose top lies on `level` (the root's is 0).
std::uint64_t capacity(std::uint32_t level) {
    std::uint64_t primitives = std::uint64_t{BVH_WIDTH} * BVH_MAX_LEAF;
    for (std::uint32_t l = level + 1; l < BVH_MAX_DEPTH; ++l) primitives *= BVH_WIDTH;
    return primitives;
}

/// Up to eight ranges that become the children of one node.
struct Family {
    std::array<Range, BVH_WIDTH> ranges;
    std::size_t count = 0;
};

/// The range to split next: the largest of those too big for a leaf; when there is none left, the largest of the
/// others, since a free slot costs nothing. BVH_WIDTH if no range can be split.
std::size_t range_to_split(const Family& family, float scale) {
    std::size_t best = BVH_WIDTH;
    bool best_is_big = false;
    float best_area = -1;
    for (std::size_t i = 0; i < family.count; ++i) {
        const Range& range = family.ranges[i];
        const bool big = range.references.size() > BVH_MAX_LEAF;
        if (range.references.size() < 2 || (best_is_big && !big)) continue;
        const float area = half_area(range.box, scale);
        if ((big && !best_is_big) || area > best_area) {
            best = i;
            best_is_big = big;
            best_area = area;
        }
    }
    return best;
}

Family divide(const Range& range) {
    Family family;
    family.ranges[0] = range;
    family.count = 1;
    const float scale = area_scale(range.box);
    while (family.count < BVH_WIDTH) {
        const std::size_t chosen = range_to_split(family, scale);
        if (chosen == BVH_WIDTH) break;
        const Range whole = family.ranges[chosen];
        split(whole, family.ranges[chosen], family.ranges[family.count]);
        ++family.count;
    }
    return family;
}

/// Eight ranges of equal size: what keeps the depth bounded where the heuristic would peel off a few at a time.
Family divide_evenly(const Range& range) {
    Family family;
    family.ranges[0] = range;
    family.count = 1;
    while (family.count < BVH_WIDTH) {
        for (std::size_t i = family.count; i-- > 0;) {
            const Range whole = family.ranges[i];
            split_median(whole, family.ranges[2 * i], family.ranges[2 * i + 1]);
        }
        family.count *= 2;
    }
    return family;
}

void append(Subtree& tree, std::size_t slot, const Subtree& child) {
    // The child's top goes to its slot, what is below it to the end; its node i becomes offset + i for i > 0.
    const auto offset = static_cast<std::uint32_t>(tree.nodes.size()) - 1;
    const auto primitives = static_cast<std::uint32_t>(tree.order.size());
    const auto moved = [&](kernel::WideNode node) {
        node.child_base += offset;
        node.primitive_base += primitives;
        return node;
    };
    tree.nodes[slot] = moved(child.nodes[0]);
    for (std::size_t i = 1; i < child.nodes.size(); ++i) tree.nodes.push_back(moved(child.nodes[i]));
    tree.order.insert(tree.order.end(), child.order.begin(), child.order.end());
    tree.depth = std::max(tree.depth, child.depth + 1);
}

/// Builds the subtree over `range` into `tree`, its top into tree.nodes[slot], which exists.
void build_below(const Range& range, std::uint32_t level, Subtree& tree, std::size_t slot) {
    const std::size_t count = range.references.size();
    Family family = divide(range);
    const auto fits = [&](const Range& r) {
        return r.references.size() <= (level + 1 < BVH_MAX_DEPTH ? capacity(level + 1) : BVH_MAX_LEAF);
    };
    if (!std::all_of(family.ranges.begin(), family.ranges.begin() + static_cast<std::ptrdiff_t>(family.count), fits)) {
        family = divide_evenly(range);
    }

    std::array<Child, BVH_WIDTH> children{};
    for (std::size_t i = 0; i < family.count; ++i) {
        const std::size_t n = family.ranges[i].references.size();
        children[i] = {to_bounds(family.ranges[i].box), n <= BVH_MAX_LEAF ? static_cast<std::uint32_t>(n) : 0};
    }
    PackedNode packed = pack(std::span(children).first(family.count));
    packed.node.primitive_base = static_cast<std::uint32_t>(tree.order.size());
    packed.node.child_base = static_cast<std::uint32_t>(tree.nodes.size());
    std::array<const Range*, BVH_WIDTH> inner{};
    std::size_t inner_count = 0;
    for (const std::uint32_t c : packed.child_in_slot) {
        if (c == BVH_WIDTH) continue;
        if (children[c].leaf_count == 0) {
            inner[inner_count++] = &family.ranges[c];
        } else {
            for (const Reference& reference : family.ranges[c].references) tree.order.push_back(reference.primitive);
        }
    }
    tree.nodes[slot] = packed.node;
    tree.nodes.resize(tree.nodes.size() + inner_count);
    if (count < kParallelCount) {
        std::uint32_t depth = 0;
        for (std::size_t i = 0; i < inner_count; ++i) {
            tree.depth = 0;
            build_below(*inner[i], level + 1, tree, packed.node.child_base + i);
            depth = std::max(depth, tree.depth);
        }
        tree.depth = depth + 1;
        return;
    }
    std::array<Subtree, BVH_WIDTH> subtrees;
    tbb::parallel_for(std::size_t{0}, inner_count, [&](std::size_t i) {
        subtrees[i].nodes.resize(1);
        build_below(*inner[i], level + 1, subtrees[i], 0);
    });
    tree.depth = 1;
    for (std::size_t i = 0; i < inner_count; ++i) append(tree, packed.node.child_base + i, subtrees[i]);
}

}  // namespace

WideBvh build(std::span<const Bounds3> primitives) {
    if (primitives.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw std::length_error("more than 2^32 - 1 primitives in one hierarchy");
    }
    std::vector<Reference> references(primitives.size());
    const auto limited = [](float v) { return std::clamp(v, -kLargestCoordinate, kLargestCoordinate); };
    tbb::parallel_for(std::size_t{0}, primitives.size(), [&](std::size_t i) {
        const Bounds3& b = primitives[i];
        references[i] = {{limited(b.lower.x), limited(b.lower.y), limited(b.lower.z)},
                         static_cast<std::uint32_t>(i),
                         {limited(b.upper.x), limited(b.upper.y), limited(b.upper.z)},
                         0.0F};
    });
    const Range range = make_range(references);
    Subtree tree;
    tree.order.reserve(primitives.size());
    tree.nodes.resize(1);
    if (primitives.empty()) {
        tree.nodes[0] = pack({}).node;
        tree.depth = 1;
    } else {
        build_below(range, 0, tree, 0);
    }
    WideBvh bvh;
    bvh.nodes = std::move(tree.nodes);
    bvh.order = std::move(tree.order);
    bvh.depth = tree.depth;
    if (!primitives.empty()) bvh.bounds = to_bounds(range.box);
    return bvh;
}

}  // namespace sundog::bvh
