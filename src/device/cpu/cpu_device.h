// SPDX-License-Identifier: Apache-2.0
// The CPU device: Embree (or a structure of ours) for traversal, oneTBB for tiles, the kernel compiled for 4, 8 and 16
// lanes.
#pragma once

#include <memory>

#include "device/acceleration.h"
#include "device/device.h"
#include "device/primary_hits.h"

namespace sundog {

/// How to run on the CPU.
struct CpuOptions {
    int threads = 0;  ///< 0: all that the process may use.
    int lanes = 0;    ///< 4 (SSE4.2), 8 (AVX2) or 16 (AVX-512); 0: the widest this processor has.
    Acceleration acceleration = Acceleration::embree;
    bool light_buffers = true;  ///< What lamps see is asked before shadow rays, where that is faster: the same picture.
    PrimaryHits primary = PrimaryHits::automatic;  ///< With Embree alone; structures of ours trace.
};

/// Errors: DeviceError if `lanes` is more than the processor has.
std::unique_ptr<Device> make_cpu_device(const CpuOptions& options);

}  // namespace sundog
