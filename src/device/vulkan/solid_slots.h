// SPDX-License-Identifier: Apache-2.0
// Exact solids as the shaders read them (shaders/layout.h says how they are laid out).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device/render_scene.h"

namespace sundog::solids {
class CompiledSolid;
}

namespace sundog::vulkan {

/// All solids of a scene.
struct SolidSlots {
    std::vector<std::uint64_t> slots;
    std::vector<std::uint32_t> roots;  ///< Of each of the scene's solids: its first node's slot.
    std::uint32_t kinds = 0;           ///< SHAPE_* that occur, as bits.
    std::uint32_t depth = 0;           ///< Groups in each other, at most.
};

/// What of a solid shaders don't draw ("has a blob"), or an empty string.
std::string not_drawn_of(const solids::CompiledSolid& solid);

/// Flattens the scene's solids, of all of which shaders draw everything.
SolidSlots solid_slots(const RenderScene& scene);

}  // namespace sundog::vulkan
