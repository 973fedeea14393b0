// SPDX-License-Identifier: Apache-2.0
// The pixels of one dispatch in GPU memory, and their way from and to the film.
#pragma once

#include <array>
#include <cstdint>

#include "device/film.h"
#include "device/vulkan/buffer.h"
#include "device/vulkan/pipelines.h"

namespace sundog::vulkan {

/// What a dispatch counted.
struct DispatchCounts {
    std::uint64_t rays = 0;
    std::uint64_t shadow_rays = 0;
    bool cut_loops = false;  ///< The driver ended loops early: what was computed is wrong.
};

/// Buffers for the pixels of one dispatch after the other.
class FilmBuffers {
public:
    /// Pixels of one dispatch at most: what fits into one storage buffer.
    static std::uint64_t most_pixels(const Adapter& adapter, std::uint32_t aovs);

    /// Makes room for so many pixels. Errors: DeviceError.
    void reserve(Gpu& gpu, Pipelines& pipelines, std::uint64_t pixels, std::uint32_t aovs);
    /// Takes the sums that the next dispatch goes on from.
    void fetch(const Gpu& gpu, const Film& film, const PixelRect& rect);
    /// Commands before and after the dispatch: with `continues`, fetched sums go to the GPU first.
    void record_before(const Gpu& gpu, VkCommandBuffer commands, const PixelRect& rect, bool continues) const;
    void record_after(const Gpu& gpu, VkCommandBuffer commands, const PixelRect& rect, bool with_aovs) const;
    /// What the dispatch counted.
    [[nodiscard]] DispatchCounts counts(const Gpu& gpu) const;
    /// Puts the dispatch's result into the film, once it was counted. first_sample is the dispatch's.
    void store(const Gpu& gpu, Film& film, const PixelRect& rect, std::uint32_t first_sample) const;

private:
    std::uint64_t pixels_ = 0, aov_pixels_ = 0;  // room
    Buffer radiance_, aov_values_;
    Buffer host_radiance_, host_aovs_;
};

}  // namespace sundog::vulkan
