// SPDX-License-Identifier: Apache-2.0
// Image files in scenes (POV-Ray reference, section 3.4.7.6 "Image Map").
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/pov/build_items.h"
#include "scene/pigment.h"

namespace sundog::pov {

/// An image file named in a block: `[png] "name" [gamma …] [premultiplied …]`.
struct ImageName {
    std::string name;
    Place where;
    std::optional<double> gamma;  ///< As written; `srgb` is 2.2.
};

/// Takes the file's kind, name and decoding. Errors: InputError where no name follows.
ImageName read_image_name(ItemReader& items);

/// How much of the light that passes is tinted, by numbers of a palette.
using PaletteFilters = std::map<std::uint8_t, float>;

/// Takes the modifiers that image maps share (once, map_type, interpolate, …). False if none follows. Filters of single
/// palette entries are put into `filters`; where it is null, they are a warning.
bool read_image_modifier(ItemReader& items, scene::ImageMap& image, PaletteFilters* filters = nullptr);

/// The palette's number of each pixel of a texture that was read from a file; empty where the file has no palette.
std::vector<std::uint8_t> palette_numbers(const scene::Texture& texture);

/// The texture with palette numbers for red, where it has a palette; else the texture itself.
scene::Index numbered_texture(BuildContext& context, scene::Index index);

/// What an image's numbers mean: colours, which files store encoded, or heights and the like, which they store as they
/// are.
enum class ImageUse : std::uint8_t { color, data };

/// The image of an `image_map { }` or `bump_map { }`. A missing or damaged file is a warning, and magenta squares.
scene::ImageMap read_image_map(BuildContext& context, const Block& block, ImageUse use = ImageUse::color,
                               PaletteFilters* filters = nullptr);

}  // namespace sundog::pov
