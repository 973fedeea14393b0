// SPDX-License-Identifier: Apache-2.0
// From the names that scene files give other files to paths.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace sundog::import {

/// A file that `named_in` names as `name`: relative to its folder, with backslashes as separators too.
std::filesystem::path resolve_path(const std::filesystem::path& named_in, std::string_view name);

/// True for an existing regular file. Never throws.
bool is_file(const std::filesystem::path& file);

/// Where a texture or library lies: as resolve_path says, or, where nothing lies there (files often carry the paths of
/// another machine), under its last name beside `named_in`. Empty if neither exists.
std::filesystem::path find_file(const std::filesystem::path& named_in, std::string_view name);

/// The names on a mtllib line, which may hold blanks: all of the line if there is such a file, else the longest
/// runs of words that are files; words without a file are put together up to one that ends in ".mtl".
std::vector<std::string> split_library_names(const std::filesystem::path& named_in, std::string_view line);

/// Adds a file to the scene's list once.
void add_file(scene::Scene& scene, const std::filesystem::path& file);

}  // namespace sundog::import
