// SPDX-License-Identifier: Apache-2.0
// Textures chosen or blended by a pattern (POV-Ray reference, sections 3.4.6.5.1 "Texture Maps" and 3.4.6.5.2 "Tiles").
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "import/pov/build_context.h"
#include "scene/pigment.h"

namespace sundog::pov {

/// A texture in a map: where it stands, or which choice it is.
struct TextureEntry {
    float at = 0;
    std::shared_ptr<const scene::LayeredTexture> texture;
};

/// The map as parts side by side, or, where entries differ in their pigments alone, as layers of mapped pigments. More
/// parts than devices draw become layers, too: with the mean of the entries' finishes and one warning a scene.
scene::LayeredTexture blend_textures(BuildContext& context, Place where, const scene::Pattern& pattern,
                                     std::vector<TextureEntry> entries);

/// Whether two finishes look the same.
bool same_finishes(const scene::Finish& a, const scene::Finish& b);

/// A texture, and how much of it there is at a point of the space that it lies in.
struct SharedTexture {
    std::shared_ptr<const scene::ShareOfPoint> share;
    std::shared_ptr<const scene::LayeredTexture> texture;
};

/// Textures side by side, in one space, by their shares, which should add up to 1. None if these are more parts than
/// devices draw.
std::optional<scene::LayeredTexture> textures_by_shares(const std::vector<SharedTexture>& textures,
                                                        const SourceLocation& where);

}  // namespace sundog::pov
