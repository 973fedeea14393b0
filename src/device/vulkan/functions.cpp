// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/functions.h"

#include <dlfcn.h>

#include "base/diagnostics.h"

namespace sundog::vulkan {
namespace {

const char* explain(VkResult result) {
    switch (result) {
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "out of memory";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "out of GPU memory";
        case VK_ERROR_DEVICE_LOST:
            return "the GPU was lost (its driver was reset or it hung)";
        case VK_ERROR_INITIALIZATION_FAILED:
            return "the driver could not start";
        case VK_ERROR_INCOMPATIBLE_DRIVER:
            return "no Vulkan driver is installed";
        case VK_ERROR_LAYER_NOT_PRESENT:
            return "a layer is missing";
        case VK_ERROR_EXTENSION_NOT_PRESENT:
            return "an extension is missing";
        case VK_ERROR_FEATURE_NOT_PRESENT:
            return "a feature is missing";
        case VK_ERROR_TOO_MANY_OBJECTS:
            return "the driver can't hold so many objects";
        default:
            return "unexpected error";
    }
}

}  // namespace

void check(VkResult result, const std::string& what) {
    if (result == VK_SUCCESS) return;
    throw DeviceError("Vulkan: " + what + ": " + explain(result) + " (VkResult " + std::to_string(result) + ")");
}

Library::Library()
    : handle_(dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL), [](void* handle) {
          if (handle) dlclose(handle);
      }) {
    if (!handle_) throw DeviceError("there is no Vulkan loader (libvulkan.so.1)");
    get_instance_proc_addr_ =
        reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(handle_.get(), "vkGetInstanceProcAddr"));
    if (!get_instance_proc_addr_) throw DeviceError("the Vulkan loader lacks vkGetInstanceProcAddr");
}

GlobalFunctions::GlobalFunctions(const Library& library) {
    const auto load = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
            library.get_instance_proc_addr()(nullptr, name));
        if (!function) throw DeviceError(std::string("the Vulkan loader lacks ") + name);
    };
    load(vkCreateInstance, "vkCreateInstance");
    load(vkEnumerateInstanceLayerProperties, "vkEnumerateInstanceLayerProperties");
    load(vkEnumerateInstanceVersion, "vkEnumerateInstanceVersion");
}

InstanceFunctions::InstanceFunctions(const Library& library, VkInstance instance) {
    const auto load_optional = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
            library.get_instance_proc_addr()(instance, name));
    };
    const auto load = [&](auto& function, const char* name) {
        load_optional(function, name);
        if (!function) throw DeviceError(std::string("the Vulkan loader lacks ") + name);
    };
    load_optional(vkCreateDebugUtilsMessengerEXT, "vkCreateDebugUtilsMessengerEXT");
    load(vkCreateDevice, "vkCreateDevice");
    load_optional(vkDestroyDebugUtilsMessengerEXT, "vkDestroyDebugUtilsMessengerEXT");
    load(vkDestroyInstance, "vkDestroyInstance");
    load(vkEnumeratePhysicalDevices, "vkEnumeratePhysicalDevices");
    load(vkGetDeviceProcAddr, "vkGetDeviceProcAddr");
    load(vkGetPhysicalDeviceFeatures2, "vkGetPhysicalDeviceFeatures2");
    load(vkGetPhysicalDeviceMemoryProperties, "vkGetPhysicalDeviceMemoryProperties");
    load(vkGetPhysicalDeviceProperties2, "vkGetPhysicalDeviceProperties2");
    load(vkGetPhysicalDeviceQueueFamilyProperties, "vkGetPhysicalDeviceQueueFamilyProperties");
}

DeviceFunctions::DeviceFunctions(const InstanceFunctions& instance, VkDevice device) {
    const auto load = [&](auto& function, const char* name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(instance.vkGetDeviceProcAddr(device, name));
        if (!function) throw DeviceError(std::string("the Vulkan driver lacks ") + name);
    };
    load(vkAllocateCommandBuffers, "vkAllocateCommandBuffers");
    load(vkAllocateDescriptorSets, "vkAllocateDescriptorSets");
    load(vkAllocateMemory, "vkAllocateMemory");
    load(vkBeginCommandBuffer, "vkBeginCommandBuffer");
    load(vkBindBufferMemory, "vkBindBufferMemory");
    load(vkCmdBindDescriptorSets, "vkCmdBindDescriptorSets");
    load(vkCmdBindPipeline, "vkCmdBindPipeline");
    load(vkCmdCopyBuffer, "vkCmdCopyBuffer");
    load(vkCmdDispatch, "vkCmdDispatch");
    load(vkCmdFillBuffer, "vkCmdFillBuffer");
    load(vkCmdPipelineBarrier, "vkCmdPipelineBarrier");
    load(vkCmdPushConstants, "vkCmdPushConstants");
    load(vkCreateBuffer, "vkCreateBuffer");
    load(vkCreateCommandPool, "vkCreateCommandPool");
    load(vkCreateComputePipelines, "vkCreateComputePipelines");
    load(vkCreateDescriptorPool, "vkCreateDescriptorPool");
    load(vkCreateDescriptorSetLayout, "vkCreateDescriptorSetLayout");
    load(vkCreateFence, "vkCreateFence");
    load(vkCreatePipelineCache, "vkCreatePipelineCache");
    load(vkCreatePipelineLayout, "vkCreatePipelineLayout");
    load(vkCreateShaderModule, "vkCreateShaderModule");
    load(vkDestroyBuffer, "vkDestroyBuffer");
    load(vkDestroyCommandPool, "vkDestroyCommandPool");
    load(vkDestroyDescriptorPool, "vkDestroyDescriptorPool");
    load(vkDestroyDescriptorSetLayout, "vkDestroyDescriptorSetLayout");
    load(vkDestroyDevice, "vkDestroyDevice");
    load(vkDestroyFence, "vkDestroyFence");
    load(vkDestroyPipeline, "vkDestroyPipeline");
    load(vkDestroyPipelineCache, "vkDestroyPipelineCache");
    load(vkDestroyPipelineLayout, "vkDestroyPipelineLayout");
    load(vkDestroyShaderModule, "vkDestroyShaderModule");
    load(vkEndCommandBuffer, "vkEndCommandBuffer");
    load(vkFlushMappedMemoryRanges, "vkFlushMappedMemoryRanges");
    load(vkFreeMemory, "vkFreeMemory");
    load(vkGetBufferMemoryRequirements, "vkGetBufferMemoryRequirements");
    load(vkGetDeviceQueue, "vkGetDeviceQueue");
    load(vkInvalidateMappedMemoryRanges, "vkInvalidateMappedMemoryRanges");
    load(vkMapMemory, "vkMapMemory");
    load(vkQueueSubmit, "vkQueueSubmit");
    load(vkResetFences, "vkResetFences");
    load(vkUpdateDescriptorSets, "vkUpdateDescriptorSets");
    load(vkWaitForFences, "vkWaitForFences");
    load(vkDeviceWaitIdle, "vkDeviceWaitIdle");
}

}  // namespace sundog::vulkan
