// SPDX-License-Identifier: Apache-2.0
// What cameras and lights (KHR_lights_punctual) of nodes become.
#pragma once

#include <optional>

#include "import/gltf/nodes.h"

namespace sundog::import::gltf {

/// The camera of a node, in the node's space.
scene::ProjectionCamera read_camera(const Json& camera);

/// The first camera among the shown nodes, placed; and the picture's size where it says its form.
void read_camera_of(Asset& asset, const NodeGraph& graph);

/// All lights of the shown nodes.
void read_lights(Asset& asset, const NodeGraph& graph);

}  // namespace sundog::import::gltf
