// SPDX-License-Identifier: Apache-2.0
// Textures chosen by a picture (POV-Ray reference, section 3.4.6.5.3 "Material Maps").
#pragma once

#include <memory>
#include <vector>

#include "import/pov/build_items.h"
#include "scene/pattern.h"

namespace sundog::pov {

/// What a `material_map { }` says.
struct MaterialMap {
    scene::Pattern pattern;  ///< Of kind `material`: the number of a texture at each point.
    std::vector<std::shared_ptr<const Block>> textures;
};
/// Errors: InputError where there is no texture.
MaterialMap read_material_map(BuildContext& context, const Block& block);

}  // namespace sundog::pov
