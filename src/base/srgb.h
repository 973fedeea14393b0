// SPDX-License-Identifier: Apache-2.0
// sRGB (IEC 61966-2-1): linear light of encoded numbers, and luminance.
#pragma once

#include <array>

#include "base/vec.h"

namespace sundog {

/// Luminance of linear RGB (ITU-R BT.709, the primaries of sRGB).
constexpr float luminance(Vec3 color) { return 0.2126F * color.x + 0.7152F * color.y + 0.0722F * color.z; }

/// The linear value, 0..1, of an sRGB value in 0..1.
double linear_from_srgb(double srgb);

/// The linear value of each 8-bit sRGB code.
const std::array<float, 256>& linear_of_srgb8();

}  // namespace sundog
