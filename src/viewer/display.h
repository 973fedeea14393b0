// SPDX-License-Identifier: Apache-2.0
// From the film to what a screen shows.
#pragma once

#include <cstdint>
#include <span>

#include "device/film.h"
#include "output/image.h"
#include "output/tone.h"

namespace sundog::viewer {

/// How radiance is shown.
struct Exposure {
    float ev = 0;  ///< Stops: the picture is times 2^ev.
    output::ToneMapping tone;
    friend bool operator==(const Exposure&, const Exposure&) = default;
};

/// Means of the film's pixels times 2^ev, mapped to what a screen shows and sRGB-encoded (IEC 61966-2-1), as opaque
/// 0xAARRGGBB, row by row into `argb` (one entry for each pixel of the film). Within 1/255 of the exact encoding;
/// pixels without samples and NaN are black. Runs on all cores.
void to_display(const Film& film, const Exposure& exposure, std::span<std::uint32_t> argb);

/// Paints the pixels white that rays were traced through: those whose cost, which the film must have, isn't 0.
void paint_traced(const Film& film, std::span<std::uint32_t> argb);

/// The same picture as linear RGB, for writing to a file of 8 bits.
output::Image to_image(const Film& film, const Exposure& exposure);

}  // namespace sundog::viewer
