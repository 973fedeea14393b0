// SPDX-License-Identifier: Apache-2.0
// From the light of both sides of a surface to what is kept of it.
#pragma once

#include <array>

#include "bake/patches.h"

namespace sundog::bake {

/// Radiance of a part's vertices, seen from the front and from the back.
using PartSides = std::array<std::vector<Vec3>, 2>;

/// Whether a material has a picture that is written beside its light.
bool is_textured(const scene::Material& material);

/// What a textured surface's light is apart from its texture.
Vec3 light_of_white(Vec3 radiance, Vec3 albedo);

/// Whether the back is clearly the brighter side, all in all: by a quarter, so that what is about as bright stays as it
/// was written.
bool is_turned(const PartSides& sides);

/// Gives a part that side's light, and turns it to where the light is.
void take_side(Part& part, PartSides& sides, bool turned);

}  // namespace sundog::bake
