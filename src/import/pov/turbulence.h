// SPDX-License-Identifier: Apache-2.0
// Noise for expressions: f_noise3d and vturbulence.
#pragma once

#include "base/vec3d.h"

namespace sundog::pov {

/// Noise over space, 0 to 1, around 0.5: gradient noise (Perlin 2002, "Improving Noise") whose directions come from a
/// hash of the cell. It has the character of POV-Ray's noise, not its very values.
double noise(Vec3d point);

/// A direction of noise at a point: three noises far from each other, -1 to 1.
Vec3d vector_noise(Vec3d point);

/// vturbulence: the sum over octaves of vector_noise, each `lambda` times as fine and `omega` times as strong.
Vec3d turbulence(Vec3d point, double lambda, double omega, double octaves);

}  // namespace sundog::pov
