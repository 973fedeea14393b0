// SPDX-License-Identifier: Apache-2.0
// GPU memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "device/vulkan/gpu.h"

namespace sundog::vulkan {

/// Where a buffer's memory should lie.
enum class Memory {
    device,    ///< Fast for the GPU.
    upload,    ///< Mapped, written by the host.
    readback,  ///< Mapped and cached where there is such memory, read by the host.
};

/// A buffer with memory of its own. Empty when default-constructed.
class Buffer {
public:
    Buffer() = default;
    /// `name` is what error messages call it. Size 0 is made 4. Errors: DeviceError, out of memory among them.
    Buffer(const Gpu& gpu, std::size_t bytes, VkBufferUsageFlags usage, Memory memory, const std::string& name);

    [[nodiscard]] VkBuffer get() const { return buffer_.get(); }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    /// The mapped memory; empty where it is not visible to the host.
    [[nodiscard]] std::span<std::byte> mapped() const { return mapped_; }
    /// Makes what the GPU wrote visible to the host.
    void invalidate(const Gpu& gpu) const;
    /// Makes what the host wrote visible to the GPU; only memory for reading back needs it.
    void flush(const Gpu& gpu) const;

private:
    [[nodiscard]] VkMappedMemoryRange whole_range() const;

    // The memory must outlive the buffer that is bound to it.
    Owned<VkDeviceMemory> memory_;
    Owned<VkBuffer> buffer_;
    std::size_t bytes_ = 0;
    std::span<std::byte> mapped_;
    bool coherent_ = true;
};

/// A storage buffer in GPU memory with the given content.
Buffer make_storage(Gpu& gpu, std::span<const std::byte> content, const std::string& name);

/// Overwrites the start of a buffer that was made with VK_BUFFER_USAGE_TRANSFER_DST_BIT.
void write(Gpu& gpu, const Buffer& buffer, std::span<const std::byte> content);

}  // namespace sundog::vulkan
