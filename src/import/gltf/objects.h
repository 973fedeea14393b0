// SPDX-License-Identifier: Apache-2.0
// Nodes with meshes become objects.
#pragma once

#include "import/gltf/animations.h"
#include "import/gltf/mesh.h"
#include "import/gltf/nodes.h"

namespace sundog::import::gltf {

/// Appends an object for each node with a mesh (and each of its instances): in world space where it rests, else in the
/// space of its node.
void read_objects(Asset& asset, const NodeGraph& graph, const WeightTracks& weights, MeshReader& meshes);

/// What of a skin (and of morph targets) a mesh is bent by; null for a rigid mesh. `node` has the mesh.
std::shared_ptr<const scene::Deformation> read_deformation(Asset& asset, const NodeGraph& graph, scene::Index node,
                                                           const MeshData& data, const WeightTracks& weights);

}  // namespace sundog::import::gltf
