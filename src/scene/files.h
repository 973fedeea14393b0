// SPDX-License-Identifier: Apache-2.0
// The files that a scene was read from.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace sundog::scene {

/// Adds a file to Scene::files, unless it is there.
void add_file(Scene& scene, const std::filesystem::path& file);

/// True if the file was read for this scene.
bool has_file(const Scene& scene, const std::filesystem::path& file);

}  // namespace sundog::scene
