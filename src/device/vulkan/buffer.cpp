// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/buffer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "base/diagnostics.h"

namespace sundog::vulkan {
namespace {

/// The first memory type among those allowed that has all the flags.
std::optional<std::uint32_t> memory_type(const Adapter& adapter, std::uint32_t allowed, VkMemoryPropertyFlags flags) {
    for (std::uint32_t i = 0; i < adapter.memory.memoryTypeCount; ++i) {
        if ((allowed >> i & 1U) && (adapter.memory.memoryTypes[i].propertyFlags & flags) == flags) return i;
    }
    return std::nullopt;
}

std::uint32_t choose_memory_type(const Adapter& adapter, std::uint32_t allowed, Memory memory) {
    constexpr VkMemoryPropertyFlags visible = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
    constexpr VkMemoryPropertyFlags coherent = visible | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    // Best first; Vulkan promises one type that is both visible and coherent.
    std::array<VkMemoryPropertyFlags, 3> wishes{};
    switch (memory) {
        case Memory::device:
            // Memory of integrated and software GPUs is visible as well: no staging then.
            wishes = {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0, 0};
            break;
        case Memory::upload:
            wishes = {coherent | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, coherent, coherent};
            break;
        case Memory::readback:
            wishes = {coherent | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, visible | VK_MEMORY_PROPERTY_HOST_CACHED_BIT,
                      coherent};
            break;
    }
    for (const VkMemoryPropertyFlags flags : wishes) {
        if (const auto type = memory_type(adapter, allowed, flags)) return *type;
    }
    throw DeviceError("Vulkan: the driver has no memory of the kind that is needed");
}

}  // namespace

Buffer::Buffer(const Gpu& gpu, std::size_t bytes, VkBufferUsageFlags usage, Memory memory, const std::string& name)
    : bytes_(std::max<std::size_t>(bytes, 4)) {
    const DeviceFunctions& f = gpu.functions();
    const std::string what = "making the buffer '" + name + "' of " + std::to_string(bytes_) + " bytes";
    VkBufferCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    create.size = bytes_;
    create.usage = usage;
    VkBuffer buffer = VK_NULL_HANDLE;
    check(f.vkCreateBuffer(gpu.device(), &create, nullptr, &buffer), what);
    buffer_ = gpu.own(buffer, f.vkDestroyBuffer);

    VkMemoryRequirements requirements{};
    f.vkGetBufferMemoryRequirements(gpu.device(), buffer, &requirements);
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.allocationSize = requirements.size;
    allocate.memoryTypeIndex = choose_memory_type(gpu.adapter(), requirements.memoryTypeBits, memory);
    VkDeviceMemory memory_handle = VK_NULL_HANDLE;
    check(f.vkAllocateMemory(gpu.device(), &allocate, nullptr, &memory_handle), what);
    memory_ = gpu.own(memory_handle, f.vkFreeMemory);
    check(f.vkBindBufferMemory(gpu.device(), buffer, memory_handle, 0), what);

    const VkMemoryPropertyFlags flags = gpu.adapter().memory.memoryTypes[allocate.memoryTypeIndex].propertyFlags;
    coherent_ = (flags & VK_MEMORY_PROPERTY_HOST_COHERENT_BIT) != 0;
    // Device memory that is mapped saves the staging copy, if writes need no flushing.
    const bool maps_device =
        gpu.transfer().map_device_memory && (flags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) && coherent_;
    if (memory != Memory::device || maps_device) {
        void* address = nullptr;
        check(f.vkMapMemory(gpu.device(), memory_handle, 0, VK_WHOLE_SIZE, 0, &address), what);
        mapped_ = {static_cast<std::byte*>(address), bytes_};
    }
}

VkMappedMemoryRange Buffer::whole_range() const {
    VkMappedMemoryRange range{};
    range.sType = VK_STRUCTURE_TYPE_MAPPED_MEMORY_RANGE;
    range.memory = memory_.get();
    range.size = VK_WHOLE_SIZE;
    return range;
}

void Buffer::invalidate(const Gpu& gpu) const {
    if (coherent_) return;
    const VkMappedMemoryRange range = whole_range();
    check(gpu.functions().vkInvalidateMappedMemoryRanges(gpu.device(), 1, &range), "reading GPU memory");
}

void Buffer::flush(const Gpu& gpu) const {
    if (coherent_) return;
    const VkMappedMemoryRange range = whole_range();
    check(gpu.functions().vkFlushMappedMemoryRanges(gpu.device(), 1, &range), "writing GPU memory");
}

Buffer make_storage(Gpu& gpu, std::span<const std::byte> content, const std::string& name) {
    Buffer buffer(gpu, content.size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                  Memory::device, name);
    write(gpu, buffer, content);
    return buffer;
}

void write(Gpu& gpu, const Buffer& buffer, std::span<const std::byte> content) {
    if (content.empty()) return;
    if (!buffer.mapped().empty()) {
        std::memcpy(buffer.mapped().data(), content.data(), content.size());
        return;
    }
    const Buffer staging(gpu, std::min(gpu.transfer().staging_bytes, content.size()), VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                         Memory::upload, "staging");
    for (std::size_t done = 0; done < content.size();) {
        const std::size_t piece = std::min(staging.bytes(), content.size() - done);
        std::memcpy(staging.mapped().data(), content.data() + done, piece);
        gpu.run([&](VkCommandBuffer commands) {
            const VkBufferCopy region{0, done, piece};
            gpu.functions().vkCmdCopyBuffer(commands, staging.get(), buffer.get(), 1, &region);
        });
        done += piece;
    }
}

}  // namespace sundog::vulkan
