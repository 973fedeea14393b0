// SPDX-License-Identifier: Apache-2.0
// From the names that input files give other files to paths.
#pragma once

#include <filesystem>
#include <string_view>

namespace sundog {

/// A file that `named_in` names as `name`: relative to its folder, with backslashes as separators too.
std::filesystem::path resolve_path(const std::filesystem::path& named_in, std::string_view name);

/// True for an existing regular file. Never throws.
bool is_file(const std::filesystem::path& file);

/// Where a texture or library lies: as resolve_path says, or, where nothing lies there (files often carry the paths of
/// another machine), under its last name beside `named_in`. Empty if neither exists.
std::filesystem::path find_file(const std::filesystem::path& named_in, std::string_view name);

}  // namespace sundog
