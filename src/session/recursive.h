// SPDX-License-Identifier: Apache-2.0
// Recursive antialiasing: pixels are divided where their corners differ.
#pragma once

#include <cstdint>
#include <optional>

#include "base/progress.h"
#include "device/device.h"
#include "session/render_result.h"

namespace sundog {

/// As POV-Ray's second method does it (reference, section 3.2.8.7 "Anti-Aliasing Options").
struct RecursiveSampling {
    double threshold = 0.3;  ///< As in ColorContrast.
    double gamma = 2.5;      ///< As in ColorContrast.
    int depth = 3;           ///< How often a pixel's square may be halved, 0 to kMostRecursion.
};
inline constexpr int kMostRecursion = 9;

/// Traces the corners of `region`'s pixels (all of the picture's if there is none). A square whose corners differ is
/// divided in four, as often as `sampling` says; a pixel is the mean of its squares, each the mean of its corners.
/// Neighbours share corners. The film's weights are how many squares a pixel has; it has no further planes.
/// The device must have can_trace_places() for the frame.
RenderResult render_recursively(Device& device, const Frame& frame, const RecursiveSampling& sampling,
                                const ProgressSink& progress, const StopFlag& stop,
                                const std::optional<PixelRect>& region = {});

}  // namespace sundog
