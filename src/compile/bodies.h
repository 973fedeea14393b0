// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/render_scene.h"
#include "scene/scene.h"

namespace sundog {

/// Where bodies of materials without layers reach into each other, or hold something and dim the light on its way
/// there, gives each of their materials its Material::interior and sets FEATURE_BODIES. A body alone needs neither:
/// what a ray is in it sees from the side of the surface that it meets. All materials are compiled, and `objects` is
/// unchanged since.
void find_bodies(const scene::Scene& scene, RenderScene& out);

}  // namespace sundog
