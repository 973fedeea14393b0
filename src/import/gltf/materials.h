// SPDX-License-Identifier: Apache-2.0
// Materials (glTF 2.0, section 3.9, and the KHR_materials_* extensions).
#pragma once

#include "import/gltf/asset.h"
#include "import/gltf/images.h"
#include "import/gltf/mesh.h"

namespace sundog::import::gltf {

/// Appends all materials of the file to the scene, in its order, and returns the texture coordinates that they go by.
/// Errors: InputError.
std::vector<UvSets> read_materials(Asset& asset);

/// The names of the file's variants (KHR_materials_variants).
std::vector<std::string> variant_names(Asset& asset);

/// The number of the variant of that name; none for an empty name. Errors: InputError.
std::optional<std::size_t> find_variant(Asset& asset, std::string_view name);

/// The material that a primitive has in a variant; none where that names none for it. `count` is how many there are.
std::optional<std::size_t> material_of_variant(const Json& primitive, std::size_t variant, std::size_t count);

/// A material's surface, without the extensions.
scene::PrincipledSurface read_surface(const Json& material, TextureReader& textures);

/// What a material's extensions say.
void read_extensions(const Json& material, TextureReader& textures, scene::PrincipledSurface& surface);

}  // namespace sundog::import::gltf
