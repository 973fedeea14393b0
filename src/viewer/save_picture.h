// SPDX-License-Identifier: Apache-2.0
// Numbered pictures that never replace one another.
#pragma once

#include <filesystem>
#include <string>

#include "output/image.h"

namespace sundog::viewer {

/// Writes `image` as the first free of STEM-0001.png, STEM-0002.png, … in `folder` and returns its path. No file that
/// is there is ever written to. Errors: OutputError.
std::filesystem::path save_numbered_png(const std::filesystem::path& folder, const std::string& stem,
                                        const output::Image& image);

}  // namespace sundog::viewer
