// SPDX-License-Identifier: Apache-2.0
// Cameras (POV-Ray reference, section 3.4.2 "Camera").
#pragma once

#include "import/pov/build_object.h"
#include "scene/scene.h"

namespace sundog::pov {

/// A camera while its vectors still depend on what follows.
struct CameraParts {
    scene::ProjectionCamera camera;
};

/// The camera of a `camera { }`, with look_at, angle and transformations worked into its vectors.
CameraParts read_camera(ObjectReader& objects, const Block& block, CameraParts start = {});

}  // namespace sundog::pov
