// SPDX-License-Identifier: Apache-2.0
// What units that hold a kernel share: one copy of the integrator each.
#pragma once

#include <cstdint>

#include "device/cpu/packet_traversal.h"
#include "kernel/integrators/whitted.h"

namespace sundog::cpu {
namespace {

using namespace kernel;

/// One copy of the integrator for pixels, for points of grid refinement and for rays that gather light.
[[gnu::noinline]] real3 radiance_along(const SceneView& scene, const Ray& ray, mask alive, RayCounts& counts,
                                       FirstHit& first) {
    return whitted_radiance(scene, ray, alive, counts, first);
}

std::uint64_t sum_lanes(word w) {
    std::uint64_t sum = 0;
    for (int lane = 0; lane < kLanes; ++lane) sum += w.v[lane];
    return sum;
}

}  // namespace
}  // namespace sundog::cpu
