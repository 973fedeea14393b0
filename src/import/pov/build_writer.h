// SPDX-License-Identifier: Apache-2.0
// From objects as read to the scene's objects, lights and materials.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "import/pov/build_context.h"
#include "import/pov/build_materials.h"
#include "import/pov/build_node.h"
#include "import/pov/build_part_textures.h"

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
        std::uint32_t interior_owner = 0;  // As scene::Object's.
        bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
        scene::ObjectPhotons photons{};
        // Light groups: those whose lights reach objects here, whether the scene's own do, and the group of lights
        // here.
        bool in_light_group = false;
        scene::LightSet lights{};
        std::uint32_t light_group = 0;
        std::uint32_t projects = 0;  // As scene::Object's.
    };
    [[nodiscard]] Surroundings within(const Surroundings& around, const Node& node);
    void enter_light_group(const Node& node, const NodeGroup& group, Surroundings& inside);
    /// The number of a light set of the scene's, which gets it if it is new.
    std::uint32_t number_of(const scene::LightSet& lights);

    /// For cutaway_textures: parts without a texture get those of the parts that have some.
    [[nodiscard]] Surroundings cutaway(const Node& node, const NodeGroup& group, const Surroundings& inside);

    /// Tells where a part is.
    [[nodiscard]] std::shared_ptr<const scene::InsideTest> inside_test_of(const TexturedPart& part,
                                                                          const Surroundings& inside);

    void add(const Node& node, const Surroundings& around);
    void add_light(const NodeLight& light, const Surroundings& inside);
    /// Puts what a light is projected through into the scene, for it alone.
    void project(const NodeLight& node, const Surroundings& inside, scene::Light& light);
    std::shared_ptr<const scene::Solid> solid_of(const Node& node, const Surroundings& around);
    scene::Index material_of(const Node& node, const Surroundings& inside);
    /// Of a blob whose components have textures.
    scene::Index blob_material(const NodeBlob& blob, const Surroundings& inside, Place where);
    /// A blob with materials for its components, each where it is strongest: of those that can't be blended.
    [[nodiscard]] scene::Blob blob_of(const NodeBlob& blob, const Surroundings& inside);
    scene::Mesh mesh_of(const NodeMesh& mesh, const Surroundings& inside, scene::Index material);
    std::shared_ptr<const scene::SolidMesh> solid_mesh_of(const NodeMesh& mesh, const Surroundings& inside);

    BuildContext& context_;
    MaterialTable materials_;
    std::uint32_t light_groups_ = 0, projectors_ = 0, whole_targets_ = 0, interior_owners_ = 0;  // So far.
    std::map<std::vector<std::uint32_t>, std::uint32_t> light_sets_;
};

}  // namespace sundog::pov
