// SPDX-License-Identifier: Apache-2.0
// Boxes around single primitives of a RenderScene, with room for rounding.
#pragma once

#include <cstdint>

#include "device/render_scene.h"

namespace sundog::accel {

/// Solids without an end reach so far: Embree's cost estimate multiplies areas with numbers of objects in single
/// precision, so infinite boxes would spoil its tree, and beyond it nothing can be told apart in a picture anyway.
inline constexpr float kFarthest = 1e12F;

/// The box with its sides moved out, so that a hit a little nearer on another surface doesn't hide what is in the box:
/// as far as rounding goes for rays that come from about as far as the box reaches.
Bounds3 roomy(Bounds3 box);

/// A solid's surfaces' bounds rounded outwards to float, within kFarthest; not roomy.
Bounds3 bounds_of_solid(const solids::CompiledSolid& solid);

/// Of a triangle, sphere or box, in object space; not roomy. Empty for a triangle with a corner that isn't finite.
Bounds3 bounds_of(const RenderScene& scene, const kernel::Geometry& geometry, std::uint32_t primitive);

}  // namespace sundog::accel
