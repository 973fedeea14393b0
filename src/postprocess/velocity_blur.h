// SPDX-License-Identifier: Apache-2.0
// Motion blur of a picture of one moment: a stand-in for a shutter that is open for a while.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"

namespace sundog::postprocess {

/// Where what a pixel shows is when the shutter opens and closes, in pixels from where the picture shows it, which is
/// halfway in time; y down.
struct PixelPath {
    Vec2 opens, closes;
};

/// The picture of the moment in the middle; each plane has width*height values, row by row.
struct MovingPicture {
    int width = 0, height = 0;
    std::span<const Vec3> radiance;        ///< Linear RGB.
    std::span<const float> depth;          ///< From the eye; infinite on a miss.
    std::span<const std::uint32_t> group;  ///< The same number for what belongs to one thing.
    std::span<const PixelPath> path;
};

/// Longer paths are taken for so many pixels, to each end.
inline constexpr float kLongestPath_px = 1024;

/// Spreads each pixel's light along its path, the parabola through its three places (velocities kept by pixel: Rosado,
/// Motion Blur as a Post-Processing Effect, GPU Gems 3, 2007; by depth, and with what is behind a thing shining through
/// its ends: McGuire, Hennessy, Bukowski and Osman, A Reconstruction Filter for Plausible Motion Blur, I3D 2012). What
/// is before a pixel is laid over it by the share of time for which it covers it; where the pixel's own thing has left
/// it for a while, what lies along its path behind it shows. Pixels at a silhouette, whose light is partly another
/// thing's that goes another way, spread what their thing shows beside them. Runs on all cores; the bits don't depend
/// on how many. Empty where `stop` was requested. Errors: std::invalid_argument for planes of another size.
std::vector<Vec3> velocity_blurred(const MovingPicture& picture, const StopFlag& stop);

}  // namespace sundog::postprocess
