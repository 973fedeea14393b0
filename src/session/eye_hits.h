// SPDX-License-Identifier: Apache-2.0
// What a pinhole's rays through the pixels' middles meet, and where that is at other moments.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "device/device.h"
#include "postprocess/velocity_blur.h"

namespace sundog {

/// Row by row.
struct EyeHits {
    std::vector<float> depth;             ///< Distance from the eye; infinite on a miss.
    std::vector<float> axis_depth;        ///< Along the view axis.
    std::vector<std::uint32_t> instance;  ///< Into Frame::instances; NONE for what rests, and one more for the sky.
    std::vector<std::uint32_t> object;    ///< Into RenderScene::geometries; NONE on a miss.
};

/// The instance of pixels that see nothing.
inline constexpr std::uint32_t kNoInstance = kernel::NONE - 1;

/// True if the frame's rays are a plain pinhole's (or a thin lens's in its place): what the functions below can tell.
bool has_pinhole(const Frame& frame);

/// Traces one ray a pixel, through a pinhole. None where it was stopped.
std::optional<EyeHits> trace_eye_hits(Device& device, const Frame& frame, const RenderScene& scene,
                                      const StopFlag& stop);

/// Where each pixel's thing is when the shutter opens and closes, by cameras and instances of three frames; `hits` are
/// the middle one's. What is behind the eye at one end goes on as it comes from the other.
std::vector<postprocess::PixelPath> paths_on_screen(const EyeHits& hits, const Frame& opens, const Frame& middle,
                                                    const Frame& closes);

}  // namespace sundog
