// SPDX-License-Identifier: Apache-2.0
// Image files in scenes (POV-Ray reference, section 3.4.7.6 "Image Map").
#pragma once

#include <filesystem>
#include <optional>
#include <string>

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

/// Takes the modifiers that image maps share (once, map_type, interpolate, …). False if none follows.
bool read_image_modifier(ItemReader& items, scene::ImageMap& image);

/// The image of an `image_map { }`. A missing or damaged file is a warning, and magenta squares.
scene::ImageMap read_image_map(BuildContext& context, const Block& block);

}  // namespace sundog::pov
