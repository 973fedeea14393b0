// SPDX-License-Identifier: Apache-2.0
// Focal blur of a picture that a pinhole made: a stand-in for a lens.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"

namespace sundog::postprocess {

/// How the light of one place is spread over the picture. Both have the same second moment.
enum class Spread : std::uint8_t {
    disc,      ///< As a round lens does.
    gaussian,  ///< Softer, without the lens's edge.
};

/// A thin lens before a picture.
struct ThinLens {
    float scale_px = 0;  ///< Its radius times the pixels that a unit of length has at distance 1.
    float focus = 1;     ///< Distance of what is sharp, along the view axis.
};

/// Wider discs are cut to this radius, in pixels.
inline constexpr float kWidestBlur_px = 64;

/// The radius in pixels of the disc that a point at this depth along the view axis becomes, with a sign: positive
/// before the plane of focus, negative behind it (Potmesil and Chakravarty, A Lens and Aperture Camera Model for
/// Synthetic Image Generation, SIGGRAPH 1981; for a lens of radius R in focus at D it is R (1/depth - 1/D)).
float signed_blur_px(const ThinLens& lens, float axis_depth);

/// A sharp picture; each plane has width*height values, row by row.
struct SharpPicture {
    int width = 0, height = 0;
    std::span<const Vec3> radiance;     ///< Linear RGB.
    std::span<const float> axis_depth;  ///< Along the view axis; infinite on a miss.
};

/// The picture as through the lens, about: what is near spreads over what is behind it, what is far doesn't spread
/// over what is before it, and where a near thing's rim becomes transparent, what is around it stands for what is
/// behind it. What lies beyond the picture is as its border. Runs on all cores; the bits don't depend on how many.
/// Empty where `stop` was requested. Errors: std::invalid_argument for planes of another size.
std::vector<Vec3> lens_blurred(const SharpPicture& picture, const ThinLens& lens, Spread spread, const StopFlag& stop);

}  // namespace sundog::postprocess
