// SPDX-License-Identifier: Apache-2.0
// One texture for an object of several: by where its parts are (POV-Ray reference, sections 3.4.5.1.1 "Blob" and
// 3.4.6.10 "Cutaway Textures").
#pragma once

#include "import/pov/build_node.h"
#include "import/pov/build_texture_map.h"

namespace sundog::pov {

/// A blob's components' textures, each by its share of the field at a point; `own`, in the blob's space, is the
/// components' that have none. None if they are more than can be drawn side by side.
std::optional<scene::LayeredTexture> blob_texture(const NodeBlob& blob, const TexturePointer& own,
                                                  const SourceLocation& where);

/// A part of a group that has a texture, in the group's space.
struct TexturedPart {
    TexturePointer texture;
    Affine3d group_from_texture;
    NodePointer node;  ///< What is inside of it.
    Affine3d group_from_parent;
};

/// All parts of a group with a texture of their own, or one of a union they are in. What is cut out of others is none.
std::vector<TexturedPart> textured_parts(const NodeGroup& group);

/// What is cut through parts shows: their textures, in equal shares where several are at a point, and the first part's
/// where none is. `insides` tell where each part is. None if they are more than can be drawn side by side.
std::optional<scene::LayeredTexture> cutaway_texture(
    const std::vector<TexturedPart>& parts, const std::vector<std::shared_ptr<const scene::InsideTest>>& insides,
    const SourceLocation& where);

}  // namespace sundog::pov
