// SPDX-License-Identifier: Apache-2.0
// Sampling until the picture's error is small enough, or time is over.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "base/progress.h"
#include "device/device.h"
#include "session/render_result.h"

namespace sundog {

/// When a picture is good enough. Errors are those that the eye sees: of square roots of radiance, where 1 is white.
struct ErrorTarget {
    /// Half the width of the 95% confidence interval of each channel that a pixel and its eight neighbours must stay
    /// under; 0: the smaller the better, for as long as there is time and samples.
    double error = 0.01;
    double time_limit_s = std::numeric_limits<double>::infinity();
    std::uint32_t most_samples = 1024;  ///< A pixel.
    float gain = 1;                     ///< What the picture's radiance will be shown times.
};

/// A picture and how good it is.
struct ErrorDrivenResult : RenderResult {
    double mean_samples = 0;   ///< A pixel.
    double largest_error = 0;  ///< Of all pixels that have enough samples to tell; 0 if none has.
    double met = 0;            ///< Share of the pixels whose own error is under the target.
};

/// Renders samples in blocks of kSampleBlock, each by a scrambled Sobol sequence of its own, and takes the blocks'
/// means as independent estimates of a pixel: their spread gives the confidence interval (L'Ecuyer and Lemieux, Recent
/// Advances in Randomized Quasi-Monte Carlo Methods, 2002; Student's t). Pixels whose interval is too wide get further
/// blocks. Every pixel has at least one block, however little time there is, unless `stop` is requested. Without a time
/// limit the picture's bits depend on the arguments alone. The frame's PixelSampling::pattern and cells are not looked
/// at; its filter is.
ErrorDrivenResult render_to_error(Device& device, const Frame& frame, const ErrorTarget& target,
                                  const ProgressSink& progress, const StopFlag& stop,
                                  const std::optional<PixelRect>& region = {});
inline constexpr std::uint32_t kSampleBlock = 4;
/// Blocks before an interval is believed.
inline constexpr std::uint32_t kFewestBlocks = 4;

}  // namespace sundog
