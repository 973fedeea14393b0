// SPDX-License-Identifier: Apache-2.0
// Warps (POV-Ray reference, section 3.4.7.5.5 "Warp").
#pragma once

#include "import/pov/build_items.h"
#include "scene/pattern.h"

namespace sundog::pov {

/// The warp of a `warp { }`. Errors: InputError.
scene::Warp read_warp(BuildContext& context, const Block& block);

}  // namespace sundog::pov
