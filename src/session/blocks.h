// SPDX-License-Identifier: Apache-2.0
// Pictures of the same number of samples everywhere that tell how noisy they are.
#pragma once

#include <cstdint>

#include "base/progress.h"
#include "device/device.h"
#include "session/render_result.h"

namespace sundog {

/// How many parts the samples of a pixel are looked at in, and how many samples each has.
struct SampleBlocks {
    std::uint32_t count = 0, size = 0;
};
/// About as many blocks as samples in each: 2 of 2, 4 of 4, 8 of 8. Never under 2; at least `samples` in all.
SampleBlocks blocks_of(std::uint32_t samples);

/// Renders samples of one scrambled Sobol sequence in blocks; from the spread of the blocks' means comes
/// RenderResult::variance. What the sequence spreads evenly over the whole of it (where in the pixel samples lie)
/// varies more between blocks than between whole sequences: of edges the variance is too large, never too small. The
/// frame's PixelSampling::pattern and cells are not looked at; its filter is.
RenderResult render_in_blocks(Device& device, const Frame& frame, std::uint32_t samples, const ProgressSink& progress,
                              const StopFlag& stop);

}  // namespace sundog
