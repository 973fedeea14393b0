// SPDX-License-Identifier: Apache-2.0
#include "device/device.h"

#include <array>
#include <vector>

#include "base/diagnostics.h"

namespace sundog {

RenderStats Device::render_regions(const Frame& frame, std::span<const PixelRect> regions, RenderWork work, Film& film,
                                   const StopFlag& stop) {
    RenderStats stats;
    const std::span<const std::uint8_t> wanted = work.wanted;
    work.wanted = {};
    std::vector<std::array<float, 4>> before;
    for (const PixelRect& region : regions) {
        work.region = region;
        const auto for_each_unwanted = [&](const auto& visit) {
            if (wanted.empty()) return;
            for (int y = region.y0; y < region.y1; ++y)
                for (int x = region.x0; x < region.x1; ++x)
                    if (wanted[film.index(x, y)] == 0) visit(film.radiance[film.index(x, y)]);
        };
        before.clear();
        for_each_unwanted([&](const std::array<float, 4>& sum) { before.push_back(sum); });
        const RenderStats done = render(frame, work, film, stop);
        auto kept = before.begin();
        for_each_unwanted([&](std::array<float, 4>& sum) { sum = *kept++; });
        stats.rays += done.rays;
        stats.shadow_rays += done.shadow_rays;
        stats.complete = stats.complete && done.complete;
        if (!stats.complete) break;
    }
    return stats;
}

RenderStats Device::refine(const Frame& frame, const RefinedWork&, Film& film, const StopFlag& stop) {
    RenderStats stats = render(frame, {film.bounds, 0, 1}, film, stop);
    stats.points = film.radiance.size();
    return stats;
}

RenderStats Device::trace_places(const Frame&, std::span<const PicturePlace>, std::span<Vec3>, const StopFlag&) {
    throw DeviceError(info().name + " doesn't trace single places of a picture");
}

}  // namespace sundog
