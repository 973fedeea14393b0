// SPDX-License-Identifier: Apache-2.0
// The Vulkan device: the same kernel as SPIR-V over our own wide BVH. Found at run time.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "device/device.h"

namespace sundog {

/// A Vulkan physical device, usable or not.
struct VulkanAdapter {
    DeviceInfo info;
    std::string why_unusable;  ///< Empty if it can be used; else one sentence.
};

/// All adapters of this machine; empty where there is no Vulkan loader or driver (`why` then says so).
std::vector<VulkanAdapter> vulkan_adapters(std::string& why);

/// How to open an adapter.
struct VulkanOptions {
    /// If set, the Khronos validation layer is switched on where it is installed, and its messages come here.
    std::function<void(std::string_view)> on_validation_message;
    /// False: the GPU's memory is treated as if the host didn't see it, as is so on most cards. For tests on others.
    bool map_device_memory = true;
    /// Bytes that are copied to such memory at a time, at least 1.
    std::size_t staging_bytes = std::size_t{32} << 20U;
};

/// Opens adapter number `index` of vulkan_adapters(). Errors: DeviceError.
std::unique_ptr<Device> make_vulkan_device(std::size_t index, const VulkanOptions& options = {});

}  // namespace sundog
