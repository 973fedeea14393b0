// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 (Khronos Group 2021), text and binary.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace sundog::import::gltf {

/// Reads a .gltf or .glb file with what it names: its default scene's meshes, materials, lights, animations and first
/// camera, Z up, with the materials of a variant (KHR_materials_variants) if one is named. Errors: InputError for what
/// can't be understood, or requires an extension that isn't read; what can be drawn all the same is a warning.
scene::Scene import_gltf(const std::filesystem::path& file, const WarningSink& warn, std::string_view variant = {});

}  // namespace sundog::import::gltf
