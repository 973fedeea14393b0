// SPDX-License-Identifier: Apache-2.0
// Participating media (POV-Ray reference, section 3.4.8 "Media").
#pragma once

#include "import/pov/build_items.h"
#include "scene/medium.h"

namespace sundog::pov {

/// The medium of a `media { }`.
scene::Medium read_medium(BuildContext& context, const Block& block);

/// Moves the densities of all media of an interior, if any.
void move_interior(scene::Interior& interior, const Affine3d& old_from_new);

}  // namespace sundog::pov
