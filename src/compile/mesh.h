// SPDX-License-Identifier: Apache-2.0
// Appends a mesh to the kernel's arrays.
#pragma once

#include "base/diagnostics.h"
#include "device/render_scene.h"
#include "scene/scene.h"

namespace sundog {

/// Which of the optional arrays the whole scene has; triangles of meshes without them get NONE there.
struct MeshAttributes {
    bool normals = false;
    bool uvs = false;
    bool further = false;  ///< Colours, tangents or second texture coordinates; `uvs` is then true as well.
};

/// Appends the mesh's vertices, and its triangles except those without area (one warning for all of them), and
/// returns how many triangles there are. Errors: InputError where indices would not fit into 32 bits.
std::uint32_t append_mesh(const scene::Object& object, const scene::Mesh& mesh, MeshAttributes attributes,
                          RenderScene& out, const WarningSink& warn);

/// True where a mesh is the whole surface of something solid (or of several), seen from outside: nobody there sees its
/// triangles from behind.
bool is_closed(const scene::Mesh& mesh);

}  // namespace sundog
