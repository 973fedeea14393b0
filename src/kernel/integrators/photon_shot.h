// SPDX-License-Identifier: Apache-2.0
// What is said about photons when they are shot. C++ only.
#ifndef SUNDOG_KERNEL_INTEGRATORS_PHOTON_SHOT_H
#define SUNDOG_KERNEL_INTEGRATORS_PHOTON_SHOT_H

#include "kernel/shared.h"

namespace sundog::kernel {

/// What photons are shot, and how far they are followed.
struct PhotonShot {
    uint light = 0;        ///< Into `lights`.
    uint target = 0;       ///< What they are shot at: as in Geometry::photons.
    uint max_depth = 0;    ///< Surfaces on the way at most.
    float min_weight = 0;  ///< Share below which one is dropped.
    uint media_steps = 0;  ///< Most of them that are stored along a stretch of media.
    float media_step = 0;  ///< And how far apart at least.
};

}  // namespace sundog::kernel

#endif
