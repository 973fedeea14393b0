// SPDX-License-Identifier: Apache-2.0
// Pictures with a palette, as the numbers of its colours.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace sundog::output {

/// One number a pixel, row 0 at the top.
struct IndexedImage {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> indices;
};

/// The palette's numbers of a GIF's first picture or of a PNG with a palette; nothing for other files. Errors:
/// InputError for one that can't be read or is damaged.
std::optional<IndexedImage> read_indices(const std::filesystem::path& file);

}  // namespace sundog::output
