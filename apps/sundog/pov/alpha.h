// SPDX-License-Identifier: Apache-2.0
// Output_Alpha: how much of the sky is seen through each pixel.
#pragma once

#include "device/film.h"
#include "output/image.h"
#include "scene/scene.h"

namespace sundog::app {

/// True where a picture of this scene can have pixels that aren't opaque.
bool shows_transparent_sky(const scene::Scene& scene);

/// Makes `scene` one whose picture is the share of the sky that is seen through each pixel: without lights, mirrors and
/// glow, before a white sky. As with POV-Ray, what is seen through glass counts, what is reflected doesn't.
void leave_only_the_sky(scene::Scene& scene);

/// Gives `image`, a picture of `scene`, the alpha that `sky_share` (a picture of what leave_only_the_sky() left) tells,
/// and takes the sky out of its colours. Both are of the same pixels.
void add_alpha(output::Image& image, const Film& sky_share, const scene::Scene& scene);

}  // namespace sundog::app
