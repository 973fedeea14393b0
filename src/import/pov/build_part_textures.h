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

/// A part of a group, in the group's space: where a point is inside of all of `nodes`, which are the part itself and
/// the groups in it that it is in.
struct TexturedPart {
    struct PlacedNode {
        NodePointer node;
        Affine3d group_from_parent;
    };
    TexturePointer texture;  ///< Null: none of its own, nor of a group that it is in.
    Affine3d group_from_texture;
    std::vector<PlacedNode> nodes;
};

/// A group's parts, those without a texture only where they are in groups of it. What is cut out of others is none.
std::vector<TexturedPart> textured_parts(const NodeGroup& group);

/// What is cut through parts shows: their textures, in equal shares where several are at a point. As povray's pictures
/// show, a part without a texture is black. Where none is, at a part's own surface, black shows if there are such
/// parts, else the first part's texture. `insides` tell where each part is. None if the textures are more than can be
/// drawn side by side.
std::optional<scene::LayeredTexture> cutaway_texture(
    const std::vector<TexturedPart>& parts, const std::vector<std::shared_ptr<const scene::InsideTest>>& insides,
    const SourceLocation& where);

}  // namespace sundog::pov
