// SPDX-License-Identifier: Apache-2.0
// Keyframes (glTF 2.0, section 3.11 "Animations").
#pragma once

#include "import/gltf/nodes.h"

namespace sundog::import::gltf {

/// The weights' keyframes of nodes whose mesh has morph targets, by the node's number in the tree.
using WeightTracks = std::unordered_map<scene::Index, scene::KeyframeTrack>;

/// Gives the nodes their keyframes, and returns those of weights. Animations that move what an earlier one does are
/// not played.
WeightTracks read_animations(Asset& asset, NodeGraph& graph);

}  // namespace sundog::import::gltf
