// SPDX-License-Identifier: Apache-2.0
// The two levels of hierarchies over a scene, as the shaders read them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "device/bvh/build.h"
#include "device/render_scene.h"
#include "device/vulkan/shaders/layout.h"
#include "device/vulkan/solid_slots.h"

namespace sundog::vulkan {

/// A hierarchy among others in one array of nodes.
struct Part {
    std::uint32_t root = 0;
    std::uint32_t instance = kernel::NONE;
    Bounds3 bounds;  ///< In its own space.
};

/// All primitives of a scene in hierarchies: one over those at rest, one over each geometry that moves. Planes have no
/// bounds and are left out.
struct Hierarchy {
    /// Where something moves, the first `top_capacity` nodes are left for the top level.
    std::vector<kernel::WideNode> nodes;
    std::vector<kernel::Leaf> leaves;
    std::vector<Part> parts;
    std::uint32_t top_capacity = 0;
    std::uint32_t depth = 0;  ///< Levels of the deepest part.
};

/// `solids` are the scene's, as shaders read them.
Hierarchy build_hierarchy(const RenderScene& scene, const SolidSlots& solids = {});

/// The level above, over the parts as a frame places them.
struct TopLevel {
    std::vector<kernel::WideNode> nodes;  ///< At most Hierarchy::top_capacity.
    std::vector<kernel::TopRef> refs;     ///< At most as many as there are parts.
    std::uint32_t depth = 0;
};

TopLevel build_top_level(const Hierarchy& hierarchy, const Frame& frame);

}  // namespace sundog::vulkan
