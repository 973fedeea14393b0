// SPDX-License-Identifier: Apache-2.0
// Photons and radiosity for scenes whose format has no words for them.
#pragma once

#include "scene/photons.h"
#include "scene/scene.h"

namespace sundog::scene {

/// About `count` photons, shot at whatever mirrors or refracts.
Photons photons_for(int count);

/// `rays` for each value, gathered more finely than by POV-Ray's defaults, which are meant for a quick look.
Radiosity radiosity_for(int rays);

}  // namespace sundog::scene
