// SPDX-License-Identifier: Apache-2.0
// Single places of a picture through the kernel.
#pragma once

#include <span>

#include "device/cpu/ray_batch.h"
#include "device/device.h"

namespace sundog::cpu {

/// Radiance at `places` of the picture that `scene` is a view for, by the kernel's camera; `radiance` is as long.
BatchRays trace_places(const kernel::SceneView& scene, RayKernel kernel, std::span<const PicturePlace> places,
                       std::span<Vec3> radiance);

}  // namespace sundog::cpu
