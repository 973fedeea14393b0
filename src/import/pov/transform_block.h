// SPDX-License-Identifier: Apache-2.0
// The map that a block of transformations stands for.
#pragma once

#include "base/vec3d.h"
#include "import/pov/entity.h"

namespace sundog::pov {

/// The map of `transform { … }`: what translate, rotate, scale and matrix do one after the other (manual, 3.3.1.12),
/// the inverse of all if `inverse` is among them (a singular map has none and stays as it is). Other items are passed
/// over.
Affine3d transform_of(const Block& block);

}  // namespace sundog::pov
