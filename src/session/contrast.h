// SPDX-License-Identifier: Apache-2.0
// Where a picture needs more samples.
#pragma once

#include <cstdint>
#include <vector>

#include "device/film.h"

namespace sundog {

/// Sampling by contrast, as POV-Ray's first method does it (reference, section 3.2.8.7 "Anti-Aliasing Options").
struct AdaptiveSampling {
    double threshold = 0.3;     ///< Sum of the differences of red, green and blue from which two pixels differ.
    double gamma = 2.5;         ///< Colours are compared as their 1/gamma-th powers.
    std::uint32_t samples = 9;  ///< That pixels get which differ from a neighbour; others have one.
};

/// Pixels that differ from the one to their left or above them, and those.
struct Contrast {
    std::vector<std::uint8_t> pixels;  ///< One for each of the film's: 1 or 0.
    /// Rectangles that hold them, don't overlap, and whose sides lie on multiples of 8 pixels or on the film's bounds.
    std::vector<PixelRect> regions;
};
Contrast contrast_of(const Film& film, const AdaptiveSampling& sampling);

}  // namespace sundog
