// SPDX-License-Identifier: Apache-2.0
// The Vulkan instance and what is known of each physical device before it is opened.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "device/device.h"
#include "device/vulkan/functions.h"

namespace sundog::vulkan {

/// Gets each message of the validation layer.
using MessageSink = std::function<void(std::string_view)>;

/// Owns a VkInstance.
class Instance {
public:
    /// With a sink, the validation layer is switched on where it is installed. Errors: DeviceError.
    explicit Instance(MessageSink validation = {});
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;
    ~Instance();

    [[nodiscard]] const InstanceFunctions& functions() const { return functions_; }
    [[nodiscard]] std::vector<VkPhysicalDevice> physical_devices() const;

private:
    Library library_;
    std::unique_ptr<MessageSink> validation_;  // at an address that the messenger can keep
    InstanceFunctions functions_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

/// What a physical device offers.
struct Adapter {
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;
    DeviceInfo info;
    std::string why_unusable;  ///< Empty if it can be used; else one sentence.
    std::uint32_t compute_queue_family = 0;
    bool computes_doubles = false;  ///< As exact solids need.
    std::uint64_t max_storage_buffer_bytes = 0;
    std::uint64_t max_allocation_bytes = 0;
    VkPhysicalDeviceMemoryProperties memory{};
};

/// Asks a physical device for everything that the renderer needs.
Adapter probe(const Instance& instance, VkPhysicalDevice physical_device);

}  // namespace sundog::vulkan
