// SPDX-License-Identifier: Apache-2.0
// translate, rotate, scale, matrix and transform (POV-Ray reference, section 3.3.1.12 "Transformations").
#pragma once

#include "base/vec3d.h"
#include "import/pov/build_items.h"

namespace sundog::pov {

/// The rotation about x, then y, then z by these angles in degrees.
Affine3d rotation_about_axes(Vec3d angles_deg);

/// Takes one transformation if one follows and puts it after those in `placed_from_local`. A scale of 0 is taken for 1,
/// with a warning, as POV-Ray does. Errors: InputError for a matrix that has no inverse.
bool read_transform(ItemReader& items, Affine3d& placed_from_local);

/// The transformation of a whole `transform { }` block.
Affine3d transform_of(BuildContext& context, const Block& block);

}  // namespace sundog::pov
