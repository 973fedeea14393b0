// SPDX-License-Identifier: Apache-2.0
// Cameras of meshes and of functions (POV-Ray reference, section 3.4.2.2.3 "Mesh projection"; user_defined of 3.8).
#pragma once

#include <memory>

#include "import/pov/build_object.h"
#include "scene/scene.h"

namespace sundog::pov {

/// A `mesh_camera { }`: rays per pixel, distribution, maximum distance, meshes. What `location` and `direction` say
/// of it comes later.
scene::MeshCamera read_mesh_camera(ObjectReader& objects, const Block& block);

/// Three functions of x and y in `location { }` or `direction { }`.
std::shared_ptr<const scene::Function> read_camera_functions(BuildContext& context, const Block& block);

}  // namespace sundog::pov
