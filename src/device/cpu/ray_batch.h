// SPDX-License-Identifier: Apache-2.0
// Single rays through the kernel, as many at a time as it has lanes.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"
#include "kernel/compat/cpp.h"

namespace sundog::cpu {

/// A ray to follow; the direction is a unit vector.
struct BatchRay {
    Vec3 origin, direction;
    float t_max = 3.0e38F;  ///< Under 0: not followed.
};

/// What came back along one.
struct BatchAnswer {
    Vec3 radiance;
    float distance = 0;  ///< To the first surface; 3e38 if there is none. Valid where the frame's aovs aren't 0.
};

/// Rays of all kinds that a batch took, and the shadow rays among them.
struct BatchRays {
    std::uint64_t rays = 0, shadow_rays = 0;
};

/// Follows `rays`; `answers` are as many.
using RayKernel = BatchRays (*)(const kernel::SceneView& scene, std::span<const BatchRay> rays,
                                std::span<BatchAnswer> answers);

// The same function for each width (see tile_kernel.h).
BatchRays trace_rays_4(const kernel::SceneView& scene, std::span<const BatchRay> rays, std::span<BatchAnswer> answers);
BatchRays trace_rays_8(const kernel::SceneView& scene, std::span<const BatchRay> rays, std::span<BatchAnswer> answers);
BatchRays trace_rays_16(const kernel::SceneView& scene, std::span<const BatchRay> rays, std::span<BatchAnswer> answers);

}  // namespace sundog::cpu
