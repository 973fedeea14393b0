// SPDX-License-Identifier: Apache-2.0
#include "device/device.h"

namespace sundog {

RenderStats Device::render_regions(const Frame& frame, std::span<const PixelRect> regions, RenderWork work, Film& film,
                                   const StopFlag& stop) {
    RenderStats stats;
    for (const PixelRect& region : regions) {
        work.region = region;
        const RenderStats done = render(frame, work, film, stop);
        stats.rays += done.rays;
        stats.shadow_rays += done.shadow_rays;
        stats.complete = stats.complete && done.complete;
        if (!stats.complete) break;
    }
    return stats;
}

}  // namespace sundog
