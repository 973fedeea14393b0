// SPDX-License-Identifier: Apache-2.0
// Texture files of a scene.
#pragma once

#include <filesystem>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace sundog::import {

/// Index of the texture that `file` holds, read now unless the scene has it already. `srgb`: its colours are
/// sRGB-encoded; the same file used both ways gives two textures. Errors: InputError if the file can't be read.
scene::Index texture_from_file(scene::Scene& scene, const std::filesystem::path& file, bool srgb,
                               const SourceLocation& where);

}  // namespace sundog::import
