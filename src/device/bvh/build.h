// SPDX-License-Identifier: Apache-2.0
// Builds the wide bounding volume hierarchy that GPU traversal reads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"
#include "device/bvh/node.h"

namespace sundog::bvh {

/// A hierarchy over primitives known by their bounds alone.
struct WideBvh {
    std::vector<kernel::WideNode> nodes;  ///< The root is the first; never empty.
    std::vector<std::uint32_t> order;     ///< Leaf place -> index of the primitive in the builder's input.
    std::uint32_t depth = 0;              ///< Levels, at most kernel::BVH_MAX_DEPTH.
    Bounds3 bounds;                       ///< Of all primitives; empty where there are none.
};

/// Builds by the surface area heuristic over binned centroids (Wald, "On fast Construction of SAH-based Bounding
/// Volume Hierarchies", 2007), splitting the child of largest area until a node has eight. Bounds must be finite and
/// not empty; their size may be zero. Runs on all threads of the calling oneTBB arena; the result does not depend on
/// how many there are.
WideBvh build(std::span<const Bounds3> primitives);

}  // namespace sundog::bvh
