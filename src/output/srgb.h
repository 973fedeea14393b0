// SPDX-License-Identifier: Apache-2.0
// The sRGB transfer function (IEC 61966-2-1; its inverse is in base/srgb.h), exact for stored pictures and fast for the
// display.
#pragma once

#include <cstdint>
#include <span>

#include "base/srgb.h"
#include "base/vec.h"

namespace sundog::output {

/// The sRGB value, 0..1, of a linear value in 0..1.
double srgb_from_linear(double linear);

/// 8-bit sRGB codes of linear RGB, rounded to nearest, 3 bytes a pixel. Values are clamped to 0..1; NaN becomes 0.
/// `codes` must hold 3 * linear.size() bytes.
void encode_srgb8(std::span<const Vec3> linear, std::span<std::uint8_t> codes);

}  // namespace sundog::output
