// SPDX-License-Identifier: Apache-2.0
#include "session/guides.h"

#include <algorithm>
#include <cmath>

#include "denoise/denoise.h"

namespace sundog {
namespace {

constexpr int kFiner = 3;
constexpr int kRows = 32;  ///< Of the picture, at a time: the finer one takes nine times the memory.

/// The same view, finer, of eye rays alone.
Frame finer(const Frame& frame) {
    Frame out = frame;
    out.params.width *= kFiner;
    out.params.height *= kFiner;
    out.params.integrator = kernel::INTEGRATOR_WHITTED;
    out.params.max_depth = 0;
    out.params.light_count = 0;
    out.params.sampling = {};
    out.params.aovs = kernel::AOV_DEPTH | kernel::AOV_NORMAL | kernel::AOV_ALBEDO | kernel::AOV_BEYOND;
    out.params.features &=
        ~(kernel::FEATURE_RADIOSITY | kernel::FEATURE_PHOTONS | kernel::FEATURE_SHADOWS | kernel::FEATURE_SUBSURFACE);
    out.radiosity.reset();
    out.photons.reset();
    return out;
}

/// Means of nine pixels of the finer film each, appended for one row of the picture.
void add_row(const Film& fine, int y, int width, PictureGuides& guides) {
    constexpr float kShare = 1.0F / (kFiner * kFiner);
    for (int x = 0; x < width; ++x) {
        Vec3 albedo{}, normal{};
        float nearness = 0;
        for (int j = 0; j < kFiner; ++j)
            for (int i = 0; i < kFiner; ++i) {
                const std::size_t at = fine.index(x * kFiner + i, y * kFiner + j);
                albedo += denoise::divisor(fine.albedo[at]) * kShare;
                normal += fine.normal[at] * kShare;
                if (fine.depth[at] > 0 && fine.depth[at] < kernel::AOV_FAR / 2) nearness += kShare / fine.depth[at];
            }
        guides.albedo.push_back(albedo);
        guides.normal.push_back(normal);
        guides.depth.push_back(1 / nearness);
    }
}

}  // namespace

PictureGuides trace_guides(Device& device, const Frame& frame, const StopFlag& stop) {
    PictureGuides guides;
    if (frame.camera_rays) return guides;
    const Frame fine_frame = finer(frame);
    const auto width = static_cast<int>(frame.params.width), height = static_cast<int>(frame.params.height);
    for (int y = 0; y < height; y += kRows) {
        const int end = std::min(y + kRows, height);
        Film fine({0, y * kFiner, width * kFiner, end * kFiner}, fine_frame.params.aovs);
        if (!device.render(fine_frame, {fine.bounds, 0, 1}, fine, stop).complete) return {};
        for (int row = y; row < end; ++row) add_row(fine, row, width, guides);
    }
    return guides;
}

}  // namespace sundog
