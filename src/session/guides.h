// SPDX-License-Identifier: Apache-2.0
// What the eye rays of a picture meet, without light: for filters that remove noise.
#pragma once

#include <vector>

#include "base/progress.h"
#include "device/device.h"

namespace sundog {

/// Means over each pixel of a picture, row by row; all empty where there are none. Where surfaces don't bend light
/// (thin veils, boundaries of media), of what is seen through them, too, each by the share of its light that reaches
/// the eye.
struct PictureGuides {
    /// Albedo: of each ray what light is to be divided by (denoise::divisor()), so 1 where it meets no diffuse surface:
    /// where a pixel sees a wall and glass or the sky beside it, the quotient lies between theirs.
    std::vector<Vec3> albedo, normal;
    std::vector<float> depth;  ///< The harmonic mean; infinite where nothing was met.
};

/// Traces a grid of 3 by 3 places in each pixel, so that edges are as smooth as the picture's. None for cameras whose
/// rays the host makes (focal blur, meshes, functions): these see several things at one place. Stopped, they are none.
PictureGuides trace_guides(Device& device, const Frame& frame, const StopFlag& stop);

}  // namespace sundog
