// SPDX-License-Identifier: Apache-2.0
// Which device to use: the only place below the apps that knows both CPU and Vulkan.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "device/acceleration.h"
#include "device/device.h"
#include "device/primary_hits.h"

namespace sundog {

/// One line of `sundog info --devices`.
struct DeviceListing {
    DeviceInfo info;
    bool chosen_by_auto = false;
    std::string why_unusable;  ///< Empty if usable.
};

/// The CPU, every Vulkan adapter, and, where there is no adapter at all, a line that says why.
std::vector<DeviceListing> list_devices();

/// choice: "cpu", "gpu" (hardware before software) or "auto" (a hardware GPU if there is one, else the CPU).
/// threads: for the CPU, 0 for all; acceleration and primary: likewise. Errors: DeviceError, which says why there is no
/// usable GPU.
std::unique_ptr<Device> open_device(std::string_view choice, int threads,
                                    Acceleration acceleration = Acceleration::embree,
                                    PrimaryHits primary = PrimaryHits::automatic);

}  // namespace sundog
