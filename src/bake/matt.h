// SPDX-License-Identifier: Apache-2.0
// Scenes as radiosity sees them.
#pragma once

#include "scene/scene.h"

namespace sundog::bake {

/// Turns mirrors and what refracts into matt surfaces that send back as much, in all directions: of MTL's and glTF's
/// materials, but not of POV-Ray's textures. Surfaces that light passes straight keep that.
void make_matt(scene::Scene& scene);

}  // namespace sundog::bake
