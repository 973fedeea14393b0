// SPDX-License-Identifier: Apache-2.0
// From a picture's planes to what the filter reads.
#pragma once

#include <vector>

#include "denoise/denoise.h"
#include "denoise/planes.h"

namespace sundog::denoise {

/// What light is divided by: albedo where there is enough of it, else 1.
std::vector<Vec3> divisors(const NoisyPicture& picture);

/// The picture's light, without what stands out by its noise alone.
Light light_of(const NoisyPicture& picture, const std::vector<Vec3>& divisors, const Layout& layout);

Guides guides_of(const NoisyPicture& picture, const Layout& layout);

}  // namespace sundog::denoise
