// SPDX-License-Identifier: Apache-2.0
#include "session/blocks.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "session/pixel_errors.h"

namespace sundog {
namespace {

/// Rows at a time: often enough to answer a stop, enough to keep all threads busy.
constexpr int kRows = 64;

}  // namespace

SampleBlocks blocks_of(std::uint32_t samples) {
    SampleBlocks blocks{2, 0};
    while (4 * blocks.count * blocks.count <= samples) blocks.count *= 2;
    blocks.size = (std::max(samples, 2U) + blocks.count - 1) / blocks.count;
    return blocks;
}

RenderResult render_in_blocks(Device& device, const Frame& frame, std::uint32_t samples, const ProgressSink& progress,
                              const StopFlag& stop) {
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const PixelRect picture = picture_of(frame, {});
    const SampleBlocks blocks = blocks_of(samples);
    Frame in_blocks = frame;
    in_blocks.params.sampling.pattern = kernel::SAMPLES_SOBOL;
    in_blocks.params.sampling.cells = 0;
    RenderResult result{Film(picture, frame.params.aovs), {}, 0, false};
    PixelErrors errors(picture, 1);
    std::vector<std::uint32_t> all(result.film.radiance.size());
    std::iota(all.begin(), all.end(), 0U);
    for (std::uint32_t block = 0; block < blocks.count && !result.stopped; ++block) {
        for (int y = picture.y0; y < picture.y1 && !result.stopped; y += kRows) {
            const PixelRect band{picture.x0, y, picture.x1, std::min(y + kRows, picture.y1)};
            const RenderStats stats =
                device.render(in_blocks, {band, block * blocks.size, blocks.size}, result.film, stop);
            result.stats.rays += stats.rays;
            result.stats.shadow_rays += stats.shadow_rays;
            result.stopped = !stats.complete;
            const double rows_done = static_cast<double>(band.y1 - picture.y0) / picture.height();
            if (progress) progress({(block + rows_done) / blocks.count, seconds(), result.stats.rays});
        }
        errors.add_blocks(result.film, all);
    }
    result.variance = errors.variances();
    result.stats.complete = !result.stopped;
    result.seconds = seconds();
    return result;
}

}  // namespace sundog
