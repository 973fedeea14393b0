// SPDX-License-Identifier: Apache-2.0
// Packs up to eight child boxes into a compact node.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/vec.h"
#include "device/bvh/node.h"

namespace sundog::bvh {

/// A child to be packed.
struct Child {
    Bounds3 bounds;
    std::uint32_t leaf_count = 0;  ///< Primitives, 1 to BVH_MAX_LEAF; 0: an inner node.
};

/// A node whose children lie in slots.
struct PackedNode {
    kernel::WideNode node;
    /// Slot -> place in `children`, or kernel::BVH_WIDTH where the slot is free. Inner children's nodes and leaves'
    /// primitives must be numbered in the order of the slots.
    std::array<std::uint32_t, kernel::BVH_WIDTH> child_in_slot;
};

/// Packs 0 to 8 children; child_base and primitive_base are left zero. The packed boxes contain the children's.
PackedNode pack(std::span<const Child> children);

/// The box of a slot as traversal sees it, in exact arithmetic rounded outwards to float.
Bounds3 unpack(const kernel::WideNode& node, std::uint32_t slot);

}  // namespace sundog::bvh
