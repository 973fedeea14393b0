// SPDX-License-Identifier: Apache-2.0
// The promises that a Scene makes to who reads it.
#pragma once

#include "scene/scene.h"

namespace sundog::scene {

/// Checks what scene.h promises: indices in range, three normals and texture coordinates a triangle or none, finite
/// numbers, textures of the size they claim, at least one material. Importers keep this; programs that make scenes
/// themselves can ask. Errors: InputError at the thing at fault.
void validate(const Scene& scene);

}  // namespace sundog::scene
