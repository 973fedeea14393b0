// SPDX-License-Identifier: Apache-2.0
// What a mtllib line names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sundog::import {

/// The names on a mtllib line, which may hold blanks: all of the line if there is such a file, else the longest
/// runs of words that are files; words without a file are put together up to one that ends in ".mtl".
std::vector<std::string> split_library_names(const std::filesystem::path& named_in, std::string_view line);

}  // namespace sundog::import
