// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/raster/frame_raster.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace sundog::cpu::raster {
namespace {

/// Triangles that are sorted together: enough to be worth a thread's while.
constexpr std::uint32_t kRunLength = 16384;
/// Finer meshes than one triangle in so many pixels are traced faster (docs/acceleration.md).
constexpr std::size_t kPixelsPerTriangle = 64;
/// More things that are traced are too many to look for in each tile.
constexpr std::size_t kMostTraced = 64;

bool same_view(const Frame& a, const Frame& b) {
    const kernel::FrameParams &p = a.params, &q = b.params;
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): other bits of the same number only cost another sorting
    return std::memcmp(&p.camera, &q.camera, sizeof p.camera) == 0 && p.width == q.width && p.height == q.height &&
           p.far_z == q.far_z && a.instances.size() == b.instances.size() &&
           // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): likewise
           std::memcmp(a.instances.data(), b.instances.data(), a.instances.size() * sizeof(a.instances[0])) == 0;
}

}  // namespace

RasterKernels raster_kernels(int lanes) {
    if (lanes == 16) return {bin_triangles_16, raster_tile_16};
    if (lanes == 8) return {bin_triangles_8, raster_tile_8};
    return {bin_triangles_4, raster_tile_4};
}

FrameRaster::FrameRaster(const RenderScene& scene, RasterKernels kernels)
    : scene_(scene), kernels_(kernels), traced_things_(scene), geometries_(scene.triangles.size(), kernel::NONE) {
    for (std::uint32_t i = 0; i < scene.geometries.size(); ++i) {
        const kernel::Geometry& g = scene.geometries[i];
        if (g.kind != kernel::GEOMETRY_TRIANGLES) continue;
        std::fill_n(geometries_.begin() + g.first_primitive, g.primitive_count, i);
        if (g.instance != kernel::NONE) continue;
        triangle_count_ += g.primitive_count;
        // Neighbours are one run, as long as it isn't long.
        for (std::uint32_t first = g.first_primitive, end = first + g.primitive_count; first < end;) {
            TriangleRun* last = runs_.empty() ? nullptr : &runs_.back();
            if (!last || last->first + last->count != first || last->count >= kRunLength)
                last = &runs_.emplace_back(TriangleRun{first, 0});
            const std::uint32_t count = std::min(end - first, kRunLength - last->count);
            last->count += count;
            first += count;
        }
    }
    bins_.resize(runs_.size());
}

bool FrameRaster::can(const Frame& frame) {
    return frame.camera_rays == nullptr && frame.camera_normal == kernel::NONE && !(frame.params.lens_radius > 0) &&
           frame.params.camera_kind == kernel::CAMERA_PERSPECTIVE &&
           frame.params.sampling.pixel_filter == kernel::FILTER_PIXEL &&
           (frame.params.features & (kernel::FEATURE_CULL | kernel::FEATURE_ONE_SIDED | kernel::FEATURE_HIDDEN)) == 0 &&
           frame.params.width <= 65536 && frame.params.height <= 65536;
}

bool FrameRaster::pays(const Frame& frame) const {
    const std::size_t pixels = std::size_t{frame.params.width} * frame.params.height;
    if (triangle_count_ == 0 || triangle_count_ * kPixelsPerTriangle > pixels || traced_things_.count() > kMostTraced)
        return false;
    std::size_t traced = 0;
    for (const PixelRect& r : traced_things_.rects(frame, eye_view_of(frame.params)))
        traced += static_cast<std::size_t>(r.width()) * static_cast<std::size_t>(r.height());
    return 2 * traced < pixels;
}

void FrameRaster::prepare(const Frame& frame) {
    if (prepared_ && same_view(frame, frame_)) return;
    frame_ = frame;
    view_ = eye_view_of(frame_.params);
    scene_view_ = view_of(scene_, frame_, nullptr);
    tiles_across_ = (static_cast<int>(frame.params.width) + kTileSide - 1) / kTileSide;
    tbb::enumerable_thread_specific<BinScratch> scratch;
    tbb::parallel_for(std::size_t{0}, runs_.size(),
                      [&](std::size_t i) { kernels_.bin(scene_view_, view_, runs_[i], scratch.local(), bins_[i]); });
    traced_ = traced_things_.rects(frame_, view_);
    prepared_ = true;
}

RasterisedTile FrameRaster::tile(const PixelRect& wanted, const kernel::PixelSampling& sampling, std::uint32_t sample,
                                 TileScratch& scratch, std::vector<std::uint32_t>& list) const {
    const int x0 = wanted.x0 / kTileSide * kTileSide, y0 = wanted.y0 / kTileSide * kTileSide;
    const auto number = static_cast<std::size_t>(y0 / kTileSide * tiles_across_ + x0 / kTileSide);
    list.clear();
    for (const Bins& bins : bins_) {
        list.insert(list.end(), bins.unbounded.begin(), bins.unbounded.end());
        const std::uint32_t* const triangles = bins.triangles.data();
        list.insert(list.end(), triangles + bins.begins[number], triangles + bins.begins[number + 1]);
    }
    kernels_.raster({scene_view_, view_, list, x0, y0, wanted, sampling, sample, traced_}, scratch);
    return {x0, y0, kTileSide, scratch.nearest, geometries_.data()};
}

}  // namespace sundog::cpu::raster
