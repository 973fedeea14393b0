// SPDX-License-Identifier: Apache-2.0
// How linear colours become the whole numbers of a picture file.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "output/image.h"

namespace sundog::output {

/// The colours' codes, 0 to 2^bits-1, rounded to nearest; values are clamped to 0..1, NaN becomes 0. Channels of a
/// pixel follow each other: gray (with `encoding.grayscale`: luminance by ITU-R BT.709) or red, green, blue; then alpha
/// where the image has it, which is not gamma encoded.
std::vector<std::uint16_t> codes_of(const Image& image, const Encoding& encoding, int bits);

/// Channels of a pixel that codes_of() gives.
int channels_of(const Image& image, const Encoding& encoding);

/// The same as 8-bit RGB or RGBA, for formats without shades of gray: a gray value stands in all three.
std::vector<std::uint8_t> codes8_of(const Image& image, const Encoding& encoding);

}  // namespace sundog::output
