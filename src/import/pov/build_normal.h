// SPDX-License-Identifier: Apache-2.0
// Normals (POV-Ray reference, section 3.4.6.2 "Normal").
#pragma once

#include <memory>
#include <vector>

#include "import/pov/build_items.h"
#include "import/pov/build_pattern.h"
#include "scene/pigment.h"

namespace sundog::pov {

using NormalPointer = std::shared_ptr<const scene::Normal>;

/// A normal in a map: where it stands, its weight (average) or which choice it is. Null: not bent.
struct NormalEntry {
    double at = 0;
    NormalPointer normal;
};

/// Moves all parts of a normal: each is looked up through `old_from_new` first.
void move_normal(scene::Normal& normal, const Affine3d& old_from_new);
/// Bends where a normal lies.
void bend_normal(scene::Normal& normal, const scene::Warp& warp);

/// The normals of a map, each weighted by its share of `pattern`. Null if none of them bends anything.
NormalPointer blend_normals(const scene::Pattern& pattern, std::vector<NormalEntry> entries);

/// The normal of a `normal { }`, changed from `start` (null: none) as its items say. The normals of its maps start from
/// `entry_start`, the normal of #default.
NormalPointer read_normal(BuildContext& context, const Block& block, const NormalPointer& start,
                          const NormalPointer& entry_start);

}  // namespace sundog::pov
