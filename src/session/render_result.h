// SPDX-License-Identifier: Apache-2.0
// What becomes of a picture.
#pragma once

#include <optional>
#include <vector>

#include "device/device.h"

namespace sundog {

/// What became of a picture.
struct RenderResult {
    Film film;
    RenderStats stats;
    double seconds = 0;
    bool stopped = false;  ///< True if the StopFlag ended it early; the film then holds what was done.
    /// Of each pixel's mean, channel by channel, where the picture was made in blocks of samples (as large
    /// as the mean's square where there were too few to tell); else empty.
    std::vector<Vec3> variance{};
};

/// How many samples a picture took in all.
inline double samples_taken(const RenderResult& result) {
    auto samples = static_cast<double>(result.stats.points);
    if (samples == 0)
        for (const auto& pixel : result.film.radiance) samples += pixel[3];
    return samples;
}

/// The pixels to render: `region`, or all of the frame's.
inline PixelRect picture_of(const Frame& frame, const std::optional<PixelRect>& region) {
    return region.value_or(
        PixelRect{0, 0, static_cast<int>(frame.params.width), static_cast<int>(frame.params.height)});
}

}  // namespace sundog
