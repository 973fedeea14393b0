// SPDX-License-Identifier: Apache-2.0
// What a point is inside of.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/vec3d.h"
#include "device/render_scene.h"

namespace sundog {

/// In RenderScene::interiors: that of objects without an interior of their own that are around an eye or a light.
/// Unlike INTERIOR_PLAIN it is no surface's, so that a part that is cut out of glass isn't taken for the end of the
/// sky.
inline constexpr std::uint32_t kInteriorAround = 2;

/// Fills `out` with PatternedMaterial::medium of what holds a point at rest, NONE behind; solids first. What finds no
/// place in it is left out. Meshes of plain triangles have no inside.
void set_media_insides(const RenderScene& scene, Vec3d point, std::span<std::uint32_t> out);

/// PatternedMaterial::interior of up to four things that hold a point at rest; 0 behind.
std::array<std::uint32_t, 4> interiors_around(const RenderScene& scene, Vec3d point);

}  // namespace sundog
