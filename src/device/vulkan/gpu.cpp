// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/gpu.h"

#include <limits>

#include "base/diagnostics.h"

namespace sundog::vulkan {
namespace {

Adapter usable_adapter(const Instance& instance, std::size_t index) {
    const auto devices = instance.physical_devices();
    if (index >= devices.size()) {
        throw DeviceError("there is no GPU number " + std::to_string(index) + ", only " +
                          std::to_string(devices.size()));
    }
    Adapter adapter = probe(instance, devices[index]);
    if (!adapter.why_unusable.empty()) {
        throw DeviceError("the GPU '" + adapter.info.name + "' can't be used: " + adapter.why_unusable);
    }
    return adapter;
}

}  // namespace

Gpu::Gpu(std::size_t index, MessageSink validation, TransferOptions transfer)
    : instance_(std::move(validation)), adapter_(usable_adapter(instance_, index)), transfer_(transfer) {
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = adapter_.compute_queue_family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkPhysicalDeviceVulkan13Features features13{};
    features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    features13.maintenance4 = VK_TRUE;  // SPIR-V 1.6 names the workgroup's size in a way that needs it
    VkPhysicalDeviceVulkan12Features features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    features.pNext = &features13;
    features.scalarBlockLayout = VK_TRUE;
    VkDeviceCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    create.pNext = &features;
    create.queueCreateInfoCount = 1;
    create.pQueueCreateInfos = &queue;
    VkPhysicalDeviceFeatures features10{};
    features10.shaderFloat64 = adapter_.computes_doubles ? VK_TRUE : VK_FALSE;
    create.pEnabledFeatures = &features10;
    VkDevice device = VK_NULL_HANDLE;
    check(instance_.functions().vkCreateDevice(adapter_.physical_device, &create, nullptr, &device),
          "opening the GPU '" + adapter_.info.name + "'");
    // Before any other entry point is known, so that a driver that lacks one still gets its device destroyed.
    const auto destroy =
        reinterpret_cast<PFN_vkDestroyDevice>(instance_.functions().vkGetDeviceProcAddr(device, "vkDestroyDevice"));
    device_ = Owned<VkDevice>(device, [destroy](VkDevice d) { destroy(d, nullptr); });
    functions_ = DeviceFunctions(instance_.functions(), device);
    functions_.vkGetDeviceQueue(device, adapter_.compute_queue_family, 0, &queue_);

    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool.queueFamilyIndex = adapter_.compute_queue_family;
    VkCommandPool pool_handle = VK_NULL_HANDLE;
    check(functions_.vkCreateCommandPool(device, &pool, nullptr, &pool_handle), "making a command pool");
    pool_ = own(pool_handle, functions_.vkDestroyCommandPool);
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = pool_handle;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(functions_.vkAllocateCommandBuffers(device, &allocate, &commands_), "making a command buffer");
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    VkFence fence_handle = VK_NULL_HANDLE;
    check(functions_.vkCreateFence(device, &fence, nullptr, &fence_handle), "making a fence");
    fence_ = own(fence_handle, functions_.vkDestroyFence);
}

Gpu::~Gpu() {
    // Nothing that is about to be destroyed may be in use; a lost device has nothing in use.
    if (functions_.vkDeviceWaitIdle) functions_.vkDeviceWaitIdle(device());
}

void Gpu::run(const std::function<void(VkCommandBuffer)>& record) {
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(functions_.vkBeginCommandBuffer(commands_, &begin), "recording commands");
    record(commands_);
    check(functions_.vkEndCommandBuffer(commands_), "recording commands");
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands_;
    const VkFence fence = fence_.get();
    check(functions_.vkQueueSubmit(queue_, 1, &submit, fence), "submitting work");
    check(functions_.vkWaitForFences(device(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
          "waiting for the GPU");
    check(functions_.vkResetFences(device(), 1, &fence), "resetting a fence");
}

}  // namespace sundog::vulkan
