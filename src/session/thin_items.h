// SPDX-License-Identifier: Apache-2.0
// What the corners of grid refinement's squares could miss: things that are thin on the screen.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "device/render_scene.h"

namespace sundog {

/// A box around a connected part of a geometry, at rest in its object's space.
struct ThinItem {
    Vec3 center;
    Vec3 half_x, half_y, half_z;  ///< From the middle to the middles of three sides.
    std::uint32_t instance = kernel::NONE;
};

/// Boxes around all parts of a scene that may come to look thin: spheres, boxes, exact solids, and the connected parts
/// of meshes, those that fill little of their box in pieces. At most kMostItems; of larger scenes, boxes around
/// several.
inline constexpr std::size_t kMostItems = 20'000;
std::vector<ThinItem> thin_items(const RenderScene& scene);

/// For each square of 8 by 8 pixels of a frame, row by row: to which side (8, 4, 2 or 1) it must be divided so that
/// every item that it may show is met by some of its corners. Items that the eye is in or that reach behind it count as
/// large. Cameras other than perspective and orthographic ones get no marks.
std::vector<std::uint8_t> finest_squares(const std::vector<ThinItem>& items, const Frame& frame);

}  // namespace sundog
