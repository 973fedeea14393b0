// SPDX-License-Identifier: Apache-2.0
// Films of a pinhole and of one moment, blurred as if by a lens or a shutter.
#pragma once

#include <optional>

#include "base/progress.h"
#include "device/device.h"
#include "postprocess/lens_blur.h"

namespace sundog {

/// A whole picture of `frame` without its lens, blurred as by that lens (FrameParams::lens_radius, focus_distance).
/// The frame must have_pinhole(). None where it was stopped.
std::optional<Film> blurred_by_lens(Device& device, const Frame& frame, const RenderScene& scene, const Film& film,
                                    postprocess::Spread spread, const StopFlag& stop);

/// A whole picture of the moment halfway between two others, blurred as by a shutter that is open from one to the
/// other. The frames must have_pinhole(). None where it was stopped.
std::optional<Film> blurred_by_motion(Device& device, const Frame& opens, const Frame& middle, const Frame& closes,
                                      const RenderScene& scene, const Film& film, const StopFlag& stop);

}  // namespace sundog
