// SPDX-License-Identifier: Apache-2.0
#include "device/choose/choose.h"

#include "base/diagnostics.h"
#include "device/cpu/cpu_device.h"

namespace sundog {

std::vector<DeviceListing> list_devices() { return {{make_cpu_device({})->info(), true, ""}}; }

std::unique_ptr<Device> open_device(std::string_view choice, int threads) {
    if (choice == "gpu") throw DeviceError("no GPU can be used: Sundog was built without Vulkan");
    CpuOptions options;
    options.threads = threads;
    return make_cpu_device(options);
}

}  // namespace sundog
