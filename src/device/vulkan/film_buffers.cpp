// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/film_buffers.h"

#include <algorithm>
#include <cstring>

#include "device/vulkan/shaders/layout.h"

namespace sundog::vulkan {
namespace {

using kernel::PixelAovs;
using Sum = std::array<float, 4>;

/// At the beginning of the buffer of radiance.
constexpr std::size_t kCounterBytes = kernel::COUNTERS * sizeof(std::uint32_t);

std::uint64_t pixels_of(const PixelRect& rect) {
    return static_cast<std::uint64_t>(rect.width()) * static_cast<std::uint64_t>(rect.height());
}

Vec3 to_vec3(kernel::vec3 v) { return {v.x, v.y, v.z}; }

/// Everything written before is seen by everything that comes after.
void full_barrier(const Gpu& gpu, VkCommandBuffer commands) {
    constexpr VkPipelineStageFlags stages =
        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_HOST_BIT;
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_READ_BIT |
                            VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_HOST_READ_BIT;
    gpu.functions().vkCmdPipelineBarrier(commands, stages, stages, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

void copy(const Gpu& gpu, VkCommandBuffer commands, const Buffer& from, const Buffer& to, std::size_t first,
          std::size_t bytes) {
    const VkBufferCopy region{first, first, bytes};
    gpu.functions().vkCmdCopyBuffer(commands, from.get(), to.get(), 1, &region);
}

void store_aovs(const PixelAovs& values, std::size_t at, Film& film) {
    if (film.aovs & kernel::AOV_DEPTH) film.depth[at] = values.depth;
    if (film.aovs & kernel::AOV_NORMAL) film.normal[at] = to_vec3(values.normal);
    if (film.aovs & kernel::AOV_ALBEDO) film.albedo[at] = to_vec3(values.albedo);
    if (film.aovs & kernel::AOV_OBJECT) {
        film.object[at] = values.object;
        film.primitive[at] = values.primitive;
        film.material[at] = values.material;
    }
}

}  // namespace

std::uint64_t FilmBuffers::most_pixels(const Adapter& adapter, std::uint32_t aovs) {
    const std::uint64_t bytes = aovs != 0 ? sizeof(PixelAovs) : sizeof(Sum);
    return (std::min(adapter.max_storage_buffer_bytes, adapter.max_allocation_bytes) - kCounterBytes) / bytes;
}

void FilmBuffers::reserve(Gpu& gpu, Pipelines& pipelines, std::uint64_t pixels, std::uint32_t aovs) {
    constexpr VkBufferUsageFlags both = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | both;
    if (pixels > pixels_) {
        const std::size_t bytes = kCounterBytes + pixels * sizeof(Sum);
        radiance_ = Buffer(gpu, bytes, storage, Memory::device, "radiance");
        host_radiance_ = Buffer(gpu, bytes, both, Memory::readback, "radiance, on the host");
        pipelines.bind(kernel::BINDING_RADIANCE, radiance_);
        pixels_ = pixels;
    }
    const std::uint64_t aov_pixels = aovs != 0 ? pixels : 0;
    if (!aov_values_.get() || aov_pixels > aov_pixels_) {
        const std::size_t bytes = aov_pixels * sizeof(PixelAovs);
        aov_values_ = Buffer(gpu, bytes, storage, Memory::device, "auxiliary values");
        host_aovs_ = Buffer(gpu, bytes, both, Memory::readback, "auxiliary values, on the host");
        pipelines.bind(kernel::BINDING_AOVS, aov_values_);
        aov_pixels_ = aov_pixels;
    }
}

void FilmBuffers::fetch(const Gpu& gpu, const Film& film, const PixelRect& rect) {
    const std::size_t row_bytes = static_cast<std::size_t>(rect.width()) * sizeof(Sum);
    std::byte* to = host_radiance_.mapped().data() + kCounterBytes;
    for (int y = rect.y0; y < rect.y1; ++y, to += row_bytes) {
        std::memcpy(to, &film.radiance[film.index(rect.x0, y)], row_bytes);
    }
    host_radiance_.flush(gpu);
}

void FilmBuffers::record_before(const Gpu& gpu, VkCommandBuffer commands, const PixelRect& rect, bool continues) const {
    gpu.functions().vkCmdFillBuffer(commands, radiance_.get(), 0, kCounterBytes, 0);
    if (continues) copy(gpu, commands, host_radiance_, radiance_, kCounterBytes, pixels_of(rect) * sizeof(Sum));
    full_barrier(gpu, commands);
}

void FilmBuffers::record_after(const Gpu& gpu, VkCommandBuffer commands, const PixelRect& rect, bool with_aovs) const {
    full_barrier(gpu, commands);
    copy(gpu, commands, radiance_, host_radiance_, 0, kCounterBytes + pixels_of(rect) * sizeof(Sum));
    if (with_aovs) copy(gpu, commands, aov_values_, host_aovs_, 0, pixels_of(rect) * sizeof(PixelAovs));
    full_barrier(gpu, commands);
}

DispatchCounts FilmBuffers::counts(const Gpu& gpu) const {
    host_radiance_.invalidate(gpu);
    std::array<std::uint32_t, kernel::COUNTERS> counters{};
    std::memcpy(counters.data(), host_radiance_.mapped().data(), kCounterBytes);
    const auto joined = [&](std::size_t first) { return std::uint64_t{counters[first + 1]} << 32U | counters[first]; };
    return {joined(kernel::COUNTER_RAYS), joined(kernel::COUNTER_SHADOW_RAYS),
            counters[kernel::COUNTER_CUT_LOOPS] != 0};
}

void FilmBuffers::store(const Gpu& gpu, Film& film, const PixelRect& rect, std::uint32_t first_sample) const {
    const std::size_t row_bytes = static_cast<std::size_t>(rect.width()) * sizeof(Sum);
    const std::byte* from = host_radiance_.mapped().data() + kCounterBytes;
    for (int y = rect.y0; y < rect.y1; ++y, from += row_bytes) {
        std::memcpy(&film.radiance[film.index(rect.x0, y)], from, row_bytes);
    }
    const bool takes_cost = (film.aovs & kernel::AOV_COST) != 0;
    if (film.aovs != 0 && (first_sample == 0 || takes_cost)) {
        host_aovs_.invalidate(gpu);
        const std::byte* values = host_aovs_.mapped().data();
        for (int y = rect.y0; y < rect.y1; ++y) {
            for (int x = rect.x0; x < rect.x1; ++x, values += sizeof(PixelAovs)) {
                PixelAovs pixel;
                std::memcpy(&pixel, values, sizeof(pixel));
                const std::size_t at = film.index(x, y);
                if (first_sample == 0) store_aovs(pixel, at, film);
                if (takes_cost) film.cost[at] = (first_sample == 0 ? 0 : film.cost[at]) + pixel.cost;
            }
        }
    }
}

}  // namespace sundog::vulkan
