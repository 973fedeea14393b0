// SPDX-License-Identifier: Apache-2.0
// What is shown in place of what is missing: magenta and black, hard to overlook.
#pragma once

#include <string>

#include "scene/scene.h"

namespace sundog::scene {

/// A magenta material, with black squares where there are texture coordinates.
Material missing_material(std::string name, SourceLocation where);

/// Index of the scene's texture of magenta and black squares, made when first asked for.
Index missing_texture(Scene& scene);

}  // namespace sundog::scene
