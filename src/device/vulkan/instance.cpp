// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/instance.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/diagnostics.h"
#include "device/vulkan/shaders/layout.h"

namespace sundog::vulkan {
namespace {

constexpr std::uint32_t kNeededVersion = VK_API_VERSION_1_3;
constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

std::string version_text(std::uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

bool has_validation_layer(const GlobalFunctions& functions) {
    std::uint32_t count = 0;
    check(functions.vkEnumerateInstanceLayerProperties(&count, nullptr), "listing layers");
    std::vector<VkLayerProperties> layers(count);
    check(functions.vkEnumerateInstanceLayerProperties(&count, layers.data()), "listing layers");
    return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, kValidationLayer) == 0;
    });
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* sink) {
    (*static_cast<const MessageSink*>(sink))(data->pMessage);
    return VK_FALSE;
}

/// The first queue family that computes.
std::optional<std::uint32_t> compute_family(const Instance& instance, VkPhysicalDevice physical_device) {
    std::uint32_t count = 0;
    instance.functions().vkGetPhysicalDeviceQueueFamilyProperties(physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    instance.functions().vkGetPhysicalDeviceQueueFamilyProperties(physical_device, &count, families.data());
    for (std::uint32_t i = 0; i < count; ++i) {
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return i;
    }
    return std::nullopt;
}

}  // namespace

Instance::Instance(MessageSink validation) {
    const GlobalFunctions global(library_);
    std::uint32_t version = 0;
    check(global.vkEnumerateInstanceVersion(&version), "asking for the loader's version");
    if (version < kNeededVersion) {
        throw DeviceError("the Vulkan loader is version " + version_text(version) + ", 1.3 is needed");
    }
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "sundog";
    application.apiVersion = kNeededVersion;
    VkInstanceCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    create.pApplicationInfo = &application;
    VkDebugUtilsMessengerCreateInfoEXT messenger{};
    const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    const bool validate = validation && has_validation_layer(global);
    if (validate) {
        validation_ = std::make_unique<MessageSink>(std::move(validation));
        messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
        messenger.messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT;
        messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
        messenger.pfnUserCallback = on_message;
        messenger.pUserData = validation_.get();
        create.pNext = &messenger;
        create.enabledLayerCount = 1;
        create.ppEnabledLayerNames = &kValidationLayer;
        create.enabledExtensionCount = 1;
        create.ppEnabledExtensionNames = &extension;
    }
    check(global.vkCreateInstance(&create, nullptr, &instance_), "starting");
    functions_ = InstanceFunctions(library_, instance_);
    if (validate && functions_.vkCreateDebugUtilsMessengerEXT && functions_.vkDestroyDebugUtilsMessengerEXT) {
        functions_.vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_);
    }
}

Instance::~Instance() {
    if (messenger_) functions_.vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
    if (instance_) functions_.vkDestroyInstance(instance_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::physical_devices() const {
    std::uint32_t count = 0;
    check(functions_.vkEnumeratePhysicalDevices(instance_, &count, nullptr), "listing GPUs");
    std::vector<VkPhysicalDevice> devices(count);
    check(functions_.vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "listing GPUs");
    devices.resize(count);
    return devices;
}

Adapter probe(const Instance& instance, VkPhysicalDevice physical_device) {
    const InstanceFunctions& f = instance.functions();
    Adapter adapter;
    adapter.physical_device = physical_device;
    adapter.info.kind = "gpu";

    VkPhysicalDeviceVulkan11Properties properties11{};
    properties11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES;
    VkPhysicalDeviceVulkan12Properties properties12{};
    properties12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &properties11;
    properties11.pNext = &properties12;
    f.vkGetPhysicalDeviceProperties2(physical_device, &properties);
    const VkPhysicalDeviceLimits& limits = properties.properties.limits;
    const std::uint32_t version = properties.properties.apiVersion;
    adapter.info.name = properties.properties.deviceName;
    adapter.info.software = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    adapter.info.detail = "Vulkan " + version_text(version);
    if (version < kNeededVersion) {
        adapter.why_unusable = "its driver offers Vulkan " + version_text(version) + ", 1.3 is needed";
        return adapter;
    }
    adapter.info.detail += std::string(", driver ") + properties12.driverName + " " + properties12.driverInfo;
    adapter.max_storage_buffer_bytes = limits.maxStorageBufferRange;
    adapter.max_allocation_bytes = properties11.maxMemoryAllocationSize;
    f.vkGetPhysicalDeviceMemoryProperties(physical_device, &adapter.memory);

    VkPhysicalDeviceVulkan13Features features13{};
    features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceVulkan12Features features12{};
    features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    features12.pNext = &features13;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &features12;
    f.vkGetPhysicalDeviceFeatures2(physical_device, &features);

    adapter.computes_doubles = features.features.shaderFloat64 == VK_TRUE;

    const auto family = compute_family(instance, physical_device);
    constexpr VkSubgroupFeatureFlags needed_subgroup =
        VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_ARITHMETIC_BIT;
    if (!family) {
        adapter.why_unusable = "it has no queue that computes";
    } else if (!features12.scalarBlockLayout) {
        adapter.why_unusable = "its driver lacks scalar block layout";
    } else if (!features13.maintenance4) {
        adapter.why_unusable = "its driver lacks maintenance4, which Vulkan 1.3 requires";
    } else if ((properties11.subgroupSupportedOperations & needed_subgroup) != needed_subgroup ||
               !(properties11.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT)) {
        adapter.why_unusable = "its driver lacks subgroup arithmetic in compute shaders";
    } else if (limits.maxPerStageDescriptorStorageBuffers < kernel::BINDING_FRAME ||
               limits.maxDescriptorSetStorageBuffers < kernel::BINDING_FRAME) {
        adapter.why_unusable = "its shaders read at most " +
                               std::to_string(limits.maxPerStageDescriptorStorageBuffers) + " buffers, " +
                               std::to_string(kernel::BINDING_FRAME) + " are needed";
    } else if (limits.maxComputeWorkGroupInvocations < kernel::GROUP_WIDTH * kernel::GROUP_HEIGHT) {
        adapter.why_unusable =
            "its workgroups hold at most " + std::to_string(limits.maxComputeWorkGroupInvocations) + " invocations";
    }
    adapter.compute_queue_family = family.value_or(0);
    return adapter;
}

}  // namespace sundog::vulkan
