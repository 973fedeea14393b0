// SPDX-License-Identifier: Apache-2.0
// Materials (glTF 2.0, section 3.9, and the KHR_materials_* extensions).
#pragma once

#include "import/gltf/asset.h"
#include "import/gltf/images.h"

namespace sundog::import::gltf {

/// Appends all materials of the file to the scene, in its order. Errors: InputError.
void read_materials(Asset& asset);

/// A material's surface, without the extensions.
scene::PrincipledSurface read_surface(const Json& material, TextureReader& textures);

/// What a material's extensions say.
void read_extensions(const Json& material, TextureReader& textures, scene::PrincipledSurface& surface);

}  // namespace sundog::import::gltf
