// SPDX-License-Identifier: Apache-2.0
// Daylight: a clear sky and the sun in it, after Preetham, Shirley and Smits, "A Practical Analytic Model for
// Daylight", SIGGRAPH 1999.
#pragma once

#include "scene/environment.h"

namespace sundog::scene {

/// Hazes that the model was fitted to: from the clearest air to thick haze.
inline constexpr float kLeastTurbidity = 1.7F, kMostTurbidity = 10;

/// Radiance is scaled so that a white surface under full daylight (120 000 lux) has 1: colours are those of a picture
/// taken at noon, and evenings are as much darker as they are.
struct Daylight {
    Vec3 to_sun{0, 0, 1};  ///< Unit; not below the horizon.
    float turbidity = 3;   ///< How hazy the air is: 2 very clear, 3 clear, 6 hazy.
};

/// Linear RGB radiance of the sky, without the sun's disc, in a unit direction over the horizon. The paper's appendix
/// A.2: Perez's distribution of luminance and chromaticity, times those of the zenith.
Vec3 sky_radiance(const Daylight& daylight, Vec3 up, Vec3 direction);

/// What the sun sends to a surface that faces it, as scene::Light::color: sunlight of 5772 K and 133 000 lux, dimmed
/// on its way through the air by molecules, haze and ozone (the paper's appendix A.1).
Vec3 sun_color(const Daylight& daylight, Vec3 up);

/// The sky's picture, twice as wide as high, `up` and `middle` its axes. Below the horizon lies gray ground (albedo
/// 0.2) in the light of this sky and sun.
Environment make_sky(const Daylight& daylight, Vec3 up, Vec3 middle, std::uint32_t height);

/// Puts the scene under such a sky: its environment, and a sun in place of all that it had.
void put_under_sky(float azimuth_deg, float elevation_deg, float turbidity, Scene& scene);

}  // namespace sundog::scene
