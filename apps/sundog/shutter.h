// SPDX-License-Identifier: Apache-2.0
// Motion blur: pictures of a shutter that is open for a while.
#pragma once

#include "render.h"

namespace sundog::app {

/// A picture whose samples see the scene at moments that are spread evenly over the shutter's time, from
/// `options.time_s` on: the camera, lights, objects and bent meshes all move. Meshes that bend are made anew for each
/// moment, so the session is left with the last one's. Errors: DeviceError.
RenderResult render_open_shutter(const RenderArguments& arguments, FrameOptions options, const Stage& stage,
                                 const ProgressSink& progress, const StopFlag& stop);

}  // namespace sundog::app
