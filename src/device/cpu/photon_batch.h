// SPDX-License-Identifier: Apache-2.0
// Photons through the kernel, as many at a time as it has lanes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/photons.h"
#include "device/cpu/ray_batch.h"
#include "kernel/compat/cpp.h"

namespace sundog::kernel {
struct PhotonShot;
}

namespace sundog::cpu {

/// A photon that leaves a light; the direction is a unit vector.
struct BatchPhoton {
    Vec3 origin, direction;
    Vec3 power;
    std::uint32_t ring = 0;  ///< Which of a pattern's rings it is on; for the caller.
};

/// What became of them.
struct PhotonHarvest {
    StoredPhotons stored;
    std::vector<std::uint8_t> met;  ///< For each that was shot, 1 if it met what it was shot at.
    BatchRays rays;
};

/// Follows photons of one light that are shot at one target, and appends to what is stored.
using PhotonKernel = void (*)(const kernel::SceneView& scene, const kernel::PhotonShot& shot,
                              std::span<const BatchPhoton> photons, PhotonHarvest& harvest);

// The same function for each width (see tile_kernel.h).
void trace_photons_4(const kernel::SceneView& scene, const kernel::PhotonShot& shot,
                     std::span<const BatchPhoton> photons, PhotonHarvest& harvest);
void trace_photons_8(const kernel::SceneView& scene, const kernel::PhotonShot& shot,
                     std::span<const BatchPhoton> photons, PhotonHarvest& harvest);
void trace_photons_16(const kernel::SceneView& scene, const kernel::PhotonShot& shot,
                      std::span<const BatchPhoton> photons, PhotonHarvest& harvest);

}  // namespace sundog::cpu
