// SPDX-License-Identifier: Apache-2.0
// Meshes whose vertices move on their own: skins and morph targets, as glTF 2.0 describes them (its specification,
// sections 3.7.2.2 "Morph Targets" and 3.7.3 "Skins").
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/scene.h"

namespace sundog::scene {

/// How a mesh is bent over time: morph targets first, then joints.
struct Deformation {
    struct Joint {
        Index node = 0;           ///< Of the tree.
        Affine3 joint_from_mesh;  ///< The inverse of its place when the skin was bound.
    };
    /// The joints that carry a vertex, by their number among `joints`.
    struct Influence {
        std::array<std::uint32_t, 4> joint{};
        std::array<float, 4> weight{};  ///< Their sum is 1.
    };
    /// What a target's whole weight adds to each position and normal; empty: nothing.
    struct Target {
        std::vector<Vec3> positions, normals;
    };

    std::shared_ptr<const NodeTree> tree;
    std::vector<Vec3> positions, normals;  ///< At rest; as many as the mesh has.
    std::vector<Target> targets;
    std::vector<float> weights;  ///< Of the targets, where weight_track doesn't say.
    Boxed<KeyframeTrack> weight_track;
    std::vector<Joint> joints;
    std::vector<std::vector<Influence>> influences;  ///< Sets of one for each position: glTF's vertices have 4 or 8.
    std::vector<std::uint32_t> vertex_of_normal;     ///< The position that moves along with each normal.
};

/// True if it changes with time.
bool moves(const Deformation& deformation);

/// True if some object is bent over time, so that meshes have to be made for each moment.
bool is_deforming(const Scene& scene);

/// Puts all meshes that are bent into the form of a moment.
void deform(Scene& scene, float time_s);

}  // namespace sundog::scene
