// SPDX-License-Identifier: Apache-2.0
// Objects between their block and the scene: transformations and textures can still change from outside.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "base/vec3d.h"
#include "import/pov/build_texture.h"
#include "import/pov/entity.h"
#include "scene/scene.h"
#include "scene/solid.h"

namespace sundog::pov {

struct Node;
using NodePointer = std::shared_ptr<const Node>;

/// A texture, and where it lies in the space of the object's parent.
struct PlacedTexture {
    TexturePointer texture;  ///< Null: none of its own.
    Affine3d parent_from_texture;
};

/// Triangles whose `material` is an index into `textures`.
struct NodeMesh {
    scene::SolidMesh triangles;
    std::vector<TexturePointer> textures;  ///< In the mesh's own space.
};

/// A blob whose components may have textures, in the blob's space; null: the blob's.
struct NodeBlob {
    scene::Blob blob;
    std::vector<TexturePointer> textures;  ///< As many as components, or none.
};

/// A light among objects, in its own space until it is placed.
struct NodeLight {
    scene::Light light;
    NodePointer looks_like;                      ///< In the light's space; null: invisible.
    std::vector<NodePointer> projected_through;  ///< In the space that the light is described in; empty: everywhere.
    Affine3d parent_from_projector;
};

/// union, merge and intersection; a difference is an intersection with inverted children.
struct NodeGroup {
    scene::SolidGroup::Kind kind = scene::SolidGroup::Kind::combined;
    std::vector<NodePointer> children;
};

using NodeShape =
    std::variant<std::monostate, scene::SolidSphere, scene::SolidBox, scene::SolidCone, scene::HalfSpace, scene::Torus,
                 scene::Polynomial, scene::Superellipsoid, NodeBlob, scene::Lathe, scene::SurfaceOfRevolution,
                 scene::Prism, scene::SphereSweep, scene::HeightField, scene::Disc, scene::FlatPolygon,
                 scene::Isosurface, scene::JuliaFractal, scene::Ovus, scene::Lemon, scene::Parametric,
                 std::shared_ptr<const NodeMesh>, NodeGroup, std::shared_ptr<const NodeLight>>;

/// An object as its block says it. An empty shape stands for what isn't drawn (left out with a warning).
struct Node {
    struct Clip {
        NodePointer node;
        Affine3d parent_from_clip;
    };
    Place where;
    Keyword keyword{};
    NodeShape shape;
    Affine3d parent_from_shape;
    PlacedTexture texture, interior_texture;
    TexturePointer
        fallback;  ///< #default's where the block is: an outermost object's is for all parts without a texture.
    InteriorPointer interior;
    Affine3d parent_from_interior;
    std::vector<Clip> clipped_by, bounded_by;
    bool inverted = false;
    bool hollow = false;
    bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
    Boxed<scene::ObjectPhotons> photons;  ///< None: as what it is a part of.
    bool split_union = true;              ///< Photons are shot at a union's parts, not at all of it.
    bool double_illuminate = false;
    bool cutaway_textures = false;
    bool declared = false;              ///< A declared object, used by name.
    std::optional<bool> global_lights;  ///< light_group: whether the scene's own lights reach its objects.
};

}  // namespace sundog::pov
