// SPDX-License-Identifier: Apache-2.0
// Where a scene's surroundings lie around it.
#pragma once

#include "scene/scene.h"

namespace sundog::scene {

/// The directions from which a picture of all directions hangs (Environment::up and middle), unit and across each
/// other.
struct Compass {
    Vec3 up{0, 0, 1};
    Vec3 middle{0, 1, 0};   ///< North, too: where azimuths count from.
    bool mirrored = false;  ///< The scene's coordinates are left-handed: right and left of `middle` are swapped.
};

/// Up is the axis nearest to what the scene's camera calls so, which orbit cameras call +Z. The middle is +Y, or +Z
/// where +Y is up or down.
Compass compass_of(const Scene& scene);

/// The unit direction `azimuth_deg` from the middle, clockwise as one sees it from above, and `elevation_deg` over the
/// horizon.
Vec3 direction_at(const Compass& compass, float azimuth_deg, float elevation_deg);

/// The unit direction of a place in the environment's picture, (0, 0) to (1, 1) from its upper left corner. To the
/// right of the middle lies cross(middle, up).
Vec3 direction_in(const Environment& environment, float u, float v);

/// Hangs a picture around the scene, turned by `turn_deg` counter-clockwise as one sees it from above. Its colours
/// become finite and not negative. Where the scene's coordinates are left-handed its columns are reversed, so that it
/// is seen as it is.
void hang(Environment environment, float turn_deg, Scene& scene);

}  // namespace sundog::scene
