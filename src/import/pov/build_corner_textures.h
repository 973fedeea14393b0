// SPDX-License-Identifier: Apache-2.0
// Textures that blend between the corners of a triangle (texture_list; POV-Ray reference, section 3.4.5.2.4 "Mesh2").
#pragma once

#include <array>
#include <map>

#include "import/pov/build_texture.h"
#include "scene/solid.h"

namespace sundog::pov {

using CornerTextures = std::array<TexturePointer, 3>;

/// The uv coordinates of a triangle's corners that blended textures are made for.
inline constexpr std::array<Vec2, 3> kCornerUvs{{{0, 0}, {0.5F, 0}, {0, 0.5F}}};

/// The texture of one triangle, whatever its corners' are: each by its share of where a point lies between the corners,
/// which are in the mesh's space. Null where these are more than can be drawn side by side, or lie in a line.
TexturePointer blended_between(const CornerTextures& corners, const std::array<Vec3d, 3>& positions,
                               const SourceLocation& where);

/// Makes a texture for each set of three, and keeps it.
class CornerBlender {
public:
    /// One texture that has each corner's colour there and blends in between, by uv coordinates of kCornerUvs. The
    /// finish is the corners'. Null where a corner's texture is no plain colour, or their finishes differ.
    TexturePointer blended(const CornerTextures& corners);

private:
    std::map<CornerTextures, TexturePointer> known_;
};

/// Gives triangles that blend their corners the coordinates of kCornerUvs.
void set_corner_uvs(scene::SolidMesh& mesh, const std::vector<std::size_t>& triangles);

}  // namespace sundog::pov
