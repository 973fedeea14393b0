// SPDX-License-Identifier: Apache-2.0
// Bounds of what pigments give.
#pragma once

#include "scene/pigment.h"

namespace sundog {

/// No less than the largest magnitude of red, green and blue that a pigment has at any point.
[[nodiscard]] float most_of(const scene::Pigment& pigment);

}  // namespace sundog
