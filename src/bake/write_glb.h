// SPDX-License-Identifier: Apache-2.0
// Baked scenes as glTF.
#pragma once

#include <filesystem>

#include "bake/bake.h"

namespace sundog::bake {

/// Writes a binary glTF 2.0 file (Khronos 2021): vertices with their light as COLOR_0 (linear, float), unlit materials
/// (KHR_materials_unlit) with the scene's base colour maps, a mesh for each object and material, and the view of
/// `frame`, if that is a pinhole's, as a camera. Y is up there, whatever it is in the scene. The file is whole or
/// untouched. Errors: OutputError.
void write_glb(const std::filesystem::path& file, const scene::Scene& scene, const BakedScene& baked,
               const Frame& frame);

}  // namespace sundog::bake
