// SPDX-License-Identifier: Apache-2.0
// Linear light of sRGB-encoded numbers (IEC 61966-2-1).
#pragma once

#include <array>

namespace sundog {

/// The linear value, 0..1, of an sRGB value in 0..1.
double linear_from_srgb(double srgb);

/// The linear value of each 8-bit sRGB code.
const std::array<float, 256>& linear_of_srgb8();

}  // namespace sundog
