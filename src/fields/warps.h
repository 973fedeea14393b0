// SPDX-License-Identifier: Apache-2.0
// Warps (POV-Ray reference, section 3.4.7.5.5 "Warp"), as values that povray 3.7 prints show them.
#pragma once

#include "scene/pattern.h"

namespace sundog::fields {

/// The point of a pattern that shows at p.
Vec3d warped(const scene::Warp& warp, Vec3d p);

}  // namespace sundog::fields
