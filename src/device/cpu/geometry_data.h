// SPDX-License-Identifier: Apache-2.0
// What Embree's callbacks are told of a geometry.
#pragma once

#include <cstdint>

#include "device/cpu/embree.h"
#include "device/render_scene.h"

namespace sundog::cpu {

struct QuickSolid;

struct GeometryData {
    const RenderScene* scene;
    kernel::Geometry geometry;
    const solids::CompiledSolid* solid = nullptr;  ///< Of a GEOMETRY_SOLID.
    const QuickSolid* quick = nullptr;             ///< Of it, where that tells anything.
    std::uint32_t visible_to = kernel::RAY_ALL;    ///< RAY_* bits. Debian's Embree has no ray masks: callbacks ask.
    RTCGeometry handle = nullptr;                  ///< Owned by the scene it is attached to.
    bool culling = false;
    bool one_sided = false;  ///< The eye doesn't see MATERIAL_ONE_SIDED from behind.

    [[nodiscard]] bool opaque(std::uint32_t material) const {
        return (scene->materials[material].flags & kernel::MATERIAL_TRANSPARENT) == 0;
    }
};

}  // namespace sundog::cpu
