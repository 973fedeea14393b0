// SPDX-License-Identifier: Apache-2.0
// Pigments (POV-Ray reference, section 3.4.6.1 "Pigment").
#pragma once

#include <memory>

#include "import/pov/build_items.h"
#include "import/pov/build_pattern.h"
#include "scene/pigment.h"

namespace sundog::pov {

/// Moves a pigment: every pattern and image in it is looked up through `old_from_new` first.
void move_pigment(scene::Pigment& pigment, const Affine3d& old_from_new);

/// Bends a pigment and all within it.
void bend_pigment(scene::Pigment& pigment, const scene::Warp& warp);

/// True if the colour depends on where on an object one looks.
bool is_positional(const scene::Pigment& pigment);

/// The pigment of a `pigment { }` (or of `image_map { }` on its own), changed from `start` as its items say.
scene::Pigment read_pigment(BuildContext& context, const Block& block, scene::Pigment start);

/// A map's row as read: where it stands and what stands there. `[0.2, 0.5 color A color B]` is two of them.
using PigmentEntries = std::vector<scene::PigmentEntry>;

/// Sorts by place, keeping the order of equals.
void sort_entries(PigmentEntries& entries);

}  // namespace sundog::pov
