// SPDX-License-Identifier: Apache-2.0
// An opened GPU: logical device, queue, and the handles that live on it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "device/vulkan/instance.h"

namespace sundog::vulkan {

/// A Vulkan handle with what destroys it.
template <class Handle>
class Owned {
public:
    Owned() = default;
    Owned(Handle handle, std::function<void(Handle)> destroy) : handle_(handle), destroy_(std::move(destroy)) {}
    Owned(Owned&& other) noexcept
        : handle_(std::exchange(other.handle_, Handle{})), destroy_(std::move(other.destroy_)) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(handle_, other.handle_);
        std::swap(destroy_, other.destroy_);
        return *this;
    }
    ~Owned() {
        if (handle_) destroy_(handle_);
    }
    [[nodiscard]] Handle get() const { return handle_; }
    explicit operator bool() const { return handle_ != Handle{}; }

private:
    Handle handle_{};
    std::function<void(Handle)> destroy_;
};

/// How content comes into the GPU's own memory.
struct TransferOptions {
    /// Written directly where the host sees that memory; if false, always through a staging buffer, as on most cards.
    bool map_device_memory = true;
    /// Size of the staging buffer; what is larger goes piece by piece.
    std::size_t staging_bytes = std::size_t{32} << 20U;
};

/// Owns a VkDevice with one compute queue and one command buffer that is recorded, submitted and awaited at once.
class Gpu {
public:
    /// Opens number `index` of the instance's physical devices. Errors: DeviceError.
    Gpu(std::size_t index, MessageSink validation, TransferOptions transfer = {});
    Gpu(const Gpu&) = delete;
    Gpu& operator=(const Gpu&) = delete;
    ~Gpu();

    [[nodiscard]] const Adapter& adapter() const { return adapter_; }
    [[nodiscard]] const TransferOptions& transfer() const { return transfer_; }
    [[nodiscard]] const DeviceFunctions& functions() const { return functions_; }
    [[nodiscard]] VkDevice device() const { return device_.get(); }

    /// Records commands with `record`, runs them and returns when they are done.
    void run(const std::function<void(VkCommandBuffer)>& record);

    /// Takes a new handle into care; `destroy` is the entry point that destroys it.
    template <class Handle>
    [[nodiscard]] Owned<Handle> own(Handle handle,
                                    void (*destroy)(VkDevice, Handle, const VkAllocationCallbacks*)) const {
        return {handle, [device = device(), destroy](Handle h) { destroy(device, h, nullptr); }};
    }

private:
    Instance instance_;
    Adapter adapter_;
    TransferOptions transfer_;
    Owned<VkDevice> device_;
    DeviceFunctions functions_;
    VkQueue queue_ = VK_NULL_HANDLE;
    Owned<VkCommandPool> pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    Owned<VkFence> fence_;
};

}  // namespace sundog::vulkan
