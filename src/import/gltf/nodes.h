// SPDX-License-Identifier: Apache-2.0
// The tree of nodes (glTF 2.0, section 3.5 "Scenes").
#pragma once

#include <memory>
#include <vector>

#include "import/gltf/asset.h"
#include "scene/animation.h"

namespace sundog::import::gltf {

/// The nodes of the file in the scene's form; those of the shown scene first, in the order in which they are met.
struct NodeGraph {
    std::vector<std::size_t> file_index;   ///< Of each node of the tree.
    std::vector<scene::Index> tree_index;  ///< Of each node of the file.
    std::size_t shown_count = 0;           ///< How many of the tree's nodes belong to the shown scene.
    std::shared_ptr<scene::NodeTree> tree;
    std::vector<Affine3> world_from_node;  ///< At rest, of each node of the tree.
    std::vector<bool> moves;               ///< A node or one above it has keyframes; filled by finish_nodes().

    [[nodiscard]] Json json(Asset& asset, scene::Index node) const { return asset.list("nodes")[file_index[node]]; }
};

/// Reads all nodes. Errors: InputError for one with two parents, or above itself.
NodeGraph read_nodes(Asset& asset);

/// Fills in what depends on animations.
void finish_nodes(NodeGraph& graph);

/// Where EXT_mesh_gpu_instancing puts a node's mesh; one place, the node's own, without it.
std::vector<Affine3> read_instances(Asset& asset, const Json& node);

}  // namespace sundog::import::gltf
