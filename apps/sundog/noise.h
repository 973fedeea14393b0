// SPDX-License-Identifier: Apache-2.0
// `sundog render --denoise`.
#pragma once

#include "device/device.h"
#include "session/render_result.h"

namespace sundog::app {

/// Filters a whole picture whose variance is known; its pixels keep their numbers of samples. Stopped, it stays as it
/// is. Returns how many seconds that took.
double remove_noise(Device& device, const Frame& frame, const StopFlag& stop, RenderResult& result);

}  // namespace sundog::app
