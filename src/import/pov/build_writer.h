// SPDX-License-Identifier: Apache-2.0
// From objects as read to the scene's objects, lights and materials.
#pragma once

#include <memory>

#include "import/pov/build_context.h"
#include "import/pov/build_materials.h"
#include "import/pov/build_node.h"

namespace sundog::pov {

/// Puts objects into the scene. Unions become separate objects wherever that makes no difference.
class SceneWriter {
public:
    explicit SceneWriter(BuildContext& context) : context_(context), materials_(context.scene) {}

    void add(const Node& node) { add(node, Surroundings{.fallback = node.fallback}); }

    /// The object as one solid, with materials in the scene (for questions about its geometry). Null if it is empty.
    std::shared_ptr<const scene::Solid> solid_of(const Node& node) {
        return solid_of(node, Surroundings{.fallback = node.fallback});
    }

private:
    /// What an object gets from those that it is part of.
    struct Surroundings {
        Affine3d world_from_parent{};
        TexturePointer fallback{};  // #default's where the outermost object is, for parts without a texture.
        TexturePointer texture{}, interior_texture{};  // Null: none.
        Affine3d world_from_texture{}, world_from_interior_texture{};
        PlacedInterior interior{};
        bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
        bool double_illuminate = false;
    };
    [[nodiscard]] static Surroundings within(const Surroundings& around, const Node& node);

    /// For cutaway_textures: parts without a texture get that of the first part which has one.
    [[nodiscard]] static Surroundings cutaway(const Node& node, const NodeGroup& group, const Surroundings& inside);

    void add(const Node& node, const Surroundings& around);
    void add_light(const NodeLight& light, const Surroundings& inside);
    std::shared_ptr<const scene::Solid> solid_of(const Node& node, const Surroundings& around);
    scene::Index material_of(const Surroundings& inside);
    scene::Mesh mesh_of(const NodeMesh& mesh, const Surroundings& inside, scene::Index material);
    std::shared_ptr<const scene::SolidMesh> solid_mesh_of(const NodeMesh& mesh, const Surroundings& inside);

    BuildContext& context_;
    MaterialTable materials_;
};

}  // namespace sundog::pov
