// SPDX-License-Identifier: Apache-2.0
// What a traced place of the picture knows: enough to shade the pixels between four of them without a ray.
#pragma once

#include "stage/world.h"

namespace sundog::intro {

/// Sample::channels. radiance = added + light * texture colour at place / depth share.
inline constexpr int kAdded = 0;       ///< Radiance that no texture dims.
inline constexpr int kLight = 3;       ///< Light on the textured surface, times its own colour.
inline constexpr int kPlace = 6;       ///< Texture coordinates times the depth share.
inline constexpr int kDepthShare = 9;  ///< One over the depth, so that places are right in perspective.
inline constexpr int kChannels = 10;
inline constexpr int kTone =
    kPlace;  ///< Where there is no texture: red, green and blue as the screen gets them, 0 to 255.

struct Sample {
    float channels[kChannels];  ///< May be interpolated linearly across the picture.
    uint texture;               ///< 0: white everywhere.
    uint outline;               ///< Hash of what was hit, by the eye's ray and in clear mirrors.
    uint signature;             ///< Hash of what was hit, of each lamp's state there, and so on in all mirrors.
};

/// Where samples are wanted, in pixels relative to a tile's corner.
struct Spot {
    unsigned char x, y;
};

/// What was traced.
struct Counts {
    unsigned long long rays, samples;
};

}  // namespace sundog::intro
