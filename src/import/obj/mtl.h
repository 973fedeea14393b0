// SPDX-License-Identifier: Apache-2.0
// Material libraries (.mtl).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/text_file.h"
#include "scene/scene.h"

namespace sundog::import {

/// Reads the text of a library and appends its materials and textures to the scene. `file` is where the text comes
/// from: textures are relative to its folder. Errors: InputError.
void read_mtl(const SourceText& source, const std::filesystem::path& file, scene::Scene& scene,
              const WarningSink& warn);

}  // namespace sundog::import
