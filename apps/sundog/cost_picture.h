// SPDX-License-Identifier: Apache-2.0
// `sundog render --show cost`: how many steps through the acceleration structure each pixel takes.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/progress.h"
#include "output/image.h"
#include "render.h"

namespace sundog::app {

/// A colour, linear RGB, for a number of steps: black for none, then a tenfold number for each of dark blue (1), blue
/// (10), green (100), yellow (1,000), red (10,000) and white (100,000 and more), and what lies between.
Vec3 cost_color(double steps);

/// A picture's heat map.
struct CostPicture {
    output::Image image;
    double mean = 0, most = 0;  ///< Steps a pixel.
    bool stopped = false;       ///< By the StopFlag: some pixels are black.
};

/// Renders `samples` samples a pixel on a CPU device with a structure of ours and shows the steps of one, on average.
CostPicture cost_picture(Device& device, const Frame& frame, int samples, const ProgressSink& progress,
                         const StopFlag& stop);

/// The job of `--show cost`: makes the picture, writes it and says what it shows. Exit status.
int render_cost(const RenderArguments& arguments, const OutputPlan& plan, const Stage& stage);

}  // namespace sundog::app
