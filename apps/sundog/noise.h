// SPDX-License-Identifier: Apache-2.0
// `sundog render --denoise`.
#pragma once

#include <string>
#include <string_view>

#include "denoise/denoiser.h"
#include "device/device.h"
#include "session/render_result.h"

namespace sundog::app {

/// "auto", "filter" or "oidn". Errors: UsageError.
denoise::Method parse_denoiser(std::string_view text);

/// Denoises a whole picture whose variance is known; its pixels keep their numbers of samples. Stopped, it stays as it
/// is. A note says where Open Image Denoise failed and the filter stood in. Returns what is to be said of it: "denoised
/// by NAME in 0.52 s".
std::string remove_noise(denoise::Denoiser& denoiser, Device& device, const Frame& frame, const StopFlag& stop,
                         RenderResult& result);

}  // namespace sundog::app
