// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/cpu_device.h"

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <fstream>
#include <string>

#include "base/diagnostics.h"
#include "device/cpu/embree_scene.h"
#include "device/cpu/grid_tile.h"
#include "device/cpu/photons.h"
#include "device/cpu/places.h"
#include "device/cpu/radiosity.h"
#include "device/cpu/raster/frame_raster.h"
#include "device/cpu/raster/light_buffers.h"
#include "device/cpu/structure_scene.h"
#include "device/cpu/tile_kernel.h"

namespace sundog {
namespace {

/// Side of the squares that threads take from each other, in pixels; a multiple of every block's side.
constexpr int kTileSide = 32;

/// So many regions are worth a light buffer.
constexpr std::size_t kManyRegions = 64;

int widest_lanes() {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512vl"))
        return 16;
    return __builtin_cpu_supports("avx2") ? 8 : 4;
}

const char* instruction_set(int lanes) { return lanes == 16 ? "AVX-512" : lanes == 8 ? "AVX2" : "SSE4.2"; }

std::string processor_name() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);)
        if (line.starts_with("model name"))
            if (const std::size_t colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "x86-64 processor";
}

class CpuDevice final : public Device {
public:
    explicit CpuDevice(const CpuOptions& options)
        : acceleration_(options.acceleration),
          primary_(options.primary),
          uses_light_buffers_(options.light_buffers),
          lanes_(options.lanes == 0 ? widest_lanes() : options.lanes) {
        if (!__builtin_cpu_supports("sse4.2"))
            throw DeviceError("this processor lacks SSE4.2, which the CPU device needs");
        if (lanes_ != 4 && lanes_ != 8 && lanes_ != 16) throw DeviceError("the CPU device has 4, 8 or 16 lanes");
        if (lanes_ > widest_lanes())
            throw DeviceError("this processor has no " + std::string(instruction_set(lanes_)) + " for " +
                              std::to_string(lanes_) + " lanes");
        if (options.threads > 0) arena_.initialize(options.threads);
        else arena_.initialize();
        kernel_ = lanes_ == 16 ? cpu::render_tile_16 : lanes_ == 8 ? cpu::render_tile_8 : cpu::render_tile_4;
        plain_kernel_ = lanes_ == 16  ? cpu::render_plain_tile_16
                        : lanes_ == 8 ? cpu::render_plain_tile_8
                                      : cpu::render_plain_tile_4;
        path_kernel_ = lanes_ == 16 ? cpu::path_tile_16 : lanes_ == 8 ? cpu::path_tile_8 : cpu::path_tile_4;
        plain_path_kernel_ = lanes_ == 16  ? cpu::plain_path_tile_16
                             : lanes_ == 8 ? cpu::plain_path_tile_8
                                           : cpu::plain_path_tile_4;
        points_ = lanes_ == 16 ? cpu::trace_points_16 : lanes_ == 8 ? cpu::trace_points_8 : cpu::trace_points_4;
        plain_points_ = lanes_ == 16  ? cpu::trace_plain_points_16
                        : lanes_ == 8 ? cpu::trace_plain_points_8
                                      : cpu::trace_plain_points_4;
        looks_ = lanes_ == 16 ? cpu::look_at_points_16 : lanes_ == 8 ? cpu::look_at_points_8 : cpu::look_at_points_4;
        photon_kernel_ = lanes_ == 16  ? cpu::trace_photons_16
                         : lanes_ == 8 ? cpu::trace_photons_8
                                       : cpu::trace_photons_4;
        rays_ = lanes_ == 16 ? cpu::trace_rays_16 : lanes_ == 8 ? cpu::trace_rays_8 : cpu::trace_rays_4;
        shapes_ = lanes_ == 16  ? cpu::ShapeCallbacks{cpu::intersect_shapes_16, cpu::occluded_by_shapes_16,
                                                     cpu::intersect_solid_16, cpu::occluded_by_solid_16}
                  : lanes_ == 8 ? cpu::ShapeCallbacks{cpu::intersect_shapes_8, cpu::occluded_by_shapes_8,
                                                      cpu::intersect_solid_8, cpu::occluded_by_solid_8}
                                : cpu::ShapeCallbacks{cpu::intersect_shapes_4, cpu::occluded_by_shapes_4,
                                                      cpu::intersect_solid_4, cpu::occluded_by_solid_4};
        const int threads = arena_.max_concurrency();
        device_.reset(rtcNewDevice(("threads=" + std::to_string(threads) + ",frequency_level=simd512").c_str()));
        if (!device_) throw DeviceError("Embree can't start on this processor");
        info_.kind = "cpu";
        info_.name = processor_name();
        info_.detail = std::to_string(threads) + (threads == 1 ? " thread, " : " threads, ") + instruction_set(lanes_) +
                       " (" + std::to_string(lanes_) + " rays at a time), " +
                       (acceleration_ == Acceleration::embree ? "Embree " RTC_VERSION_STRING
                                                              : "acceleration: " + std::string(name_of(acceleration_)));
        rtcSetDeviceMemoryMonitorFunction(device_.get(), count_memory, &bytes_);
    }

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] std::vector<std::string> unsupported(const RenderScene&) const override { return {}; }
    [[nodiscard]] std::size_t memory_bytes() const override {
        return structure_ ? structure_->memory_bytes() : static_cast<std::size_t>(bytes_.load());
    }

    void load(std::shared_ptr<const RenderScene> scene) override {
        arena_.execute([&] {
            radiosity_.reset();
            photons_.reset();
            embree_.reset();
            structure_.reset();
            raster_.reset();
            light_buffers_.reset();
            scene_ = std::move(scene);
            if (acceleration_ == Acceleration::embree)
                embree_ = std::make_unique<cpu::EmbreeScene>(device_.get(), *scene_, shapes_);
            else structure_ = std::make_unique<cpu::StructureScene>(device_.get(), acceleration_, *scene_);
        });
    }

    RenderStats render(const Frame& frame, const RenderWork& work, Film& film, const StopFlag& stop) override {
        Totals totals(structure_.get());
        arena_.execute([&] {
            if (!prepare(frame, stop, totals)) return;
            const cpu::raster::FrameRaster* const raster = prepare_raster(frame);
            prepare_light_buffers(frame, work.region.width() >= kTileSide && work.region.height() >= kTileSide / 2);
            for_each_tile(work.region, kTileSide,
                          [&](const PixelRect& tile) { render_tile(frame, tile, work, film, stop, totals, raster); });
        });
        return totals.stats();
    }

    [[nodiscard]] bool can_refine(const Frame& frame) const override {
        return frame.camera_rays == nullptr && frame.camera_normal == kernel::NONE &&
               frame.params.integrator == kernel::INTEGRATOR_WHITTED && !(frame.params.lens_radius > 0);
    }

    RenderStats refine(const Frame& frame, const RefinedWork& work, Film& film, const StopFlag& stop) override {
        if (!can_refine(frame) || !(work.tolerance > 0)) return Device::refine(frame, work, film, stop);
        Totals totals(structure_.get());
        arena_.execute([&] {
            if (!prepare(frame, stop, totals)) return;
            const kernel::SceneView view = prepared_view(frame);
            for_each_tile(film.bounds, sampling::kRefinedTileSide,
                          [&](const PixelRect& tile) { refine_tile(view, tile, work, film, stop, totals); });
        });
        return totals.stats();
    }

    RenderStats render_regions(const Frame& frame, std::span<const PixelRect> regions, RenderWork work, Film& film,
                               const StopFlag& stop) override {
        Totals totals(structure_.get());
        arena_.execute([&] {
            if (!prepare(frame, stop, totals)) return;
            const cpu::raster::FrameRaster* const raster = prepare_raster(frame);
            prepare_light_buffers(frame, regions.size() >= kManyRegions);
            tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t i) {
                for_parts_of(regions[i], [&](const PixelRect& part) {
                    render_tile(frame, part, work, film, stop, totals, raster);
                });
            });
        });
        return totals.stats();
    }

    [[nodiscard]] bool can_trace_places(const Frame& frame) const override { return can_refine(frame); }

    RenderStats trace_places(const Frame& frame, std::span<const PicturePlace> places, std::span<Vec3> radiance,
                             const StopFlag& stop) override {
        Totals totals(structure_.get());
        arena_.execute([&] {
            if (!prepare(frame, stop, totals)) return;
            const kernel::SceneView view = prepared_view(frame);
            constexpr std::size_t kAtOnce = 256;  // A multiple of every packet's size.
            tbb::parallel_for(std::size_t{0}, (places.size() + kAtOnce - 1) / kAtOnce, [&](std::size_t part) {
                if (stop.requested()) {
                    totals.complete = false;
                    return;
                }
                const std::size_t first = part * kAtOnce, count = std::min(kAtOnce, places.size() - first);
                const cpu::BatchRays done =
                    cpu::trace_places(view, rays_, places.subspan(first, count), radiance.subspan(first, count));
                totals.rays += done.rays;
                totals.shadow_rays += done.shadow_rays;
            });
        });
        return totals.stats();
    }

private:
    /// What the threads of one call did together.
    struct Totals {
        explicit Totals(const cpu::StructureScene* structure_) : structure(structure_) {
            if (structure) before = structure->all_steps();
        }
        [[nodiscard]] RenderStats stats() const {
            RenderStats stats{.rays = rays, .shadow_rays = shadow_rays, .points = points, .complete = complete};
            if (structure) {
                const accel::Steps now = structure->all_steps();
                stats.visits = now.visits - before.visits;
                stats.tests = now.tests - before.tests;
            }
            return stats;
        }

        const cpu::StructureScene* structure;  ///< Null: Embree.
        accel::Steps before;
        std::atomic<std::uint64_t> rays{0}, shadow_rays{0}, points{0};
        std::atomic<bool> complete{true};
    };

    /// The irradiance of one frame, kept for the further works on its picture.
    struct PreparedRadiosity {
        Frame frame;
        std::unique_ptr<cpu::Radiosity> radiosity;
    };

    /// The photons of one frame, kept for as long as they fly the same ways.
    struct PreparedPhotons {
        Frame frame;
        std::unique_ptr<cpu::Photons> photons;
    };

    template <class T>
    static bool same_bytes(const std::vector<T>& x, const std::vector<T>& y) {
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): other bits of the same number ask for another round
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
    }

    /// True if two frames' photons are the same: wherever their cameras are.
    static bool same_photons(const Frame& a, const Frame& b) {
        return a.params.features == b.params.features && same_bytes(a.lights, b.lights) &&
               same_bytes(a.instances, b.instances) && a.photons == b.photons;
    }

    /// True if two frames' surfaces get the same light from each other and their pictures see the same of them.
    static bool same_light(const Frame& a, const Frame& b) {
        kernel::FrameParams p = a.params;
        p.aovs = b.params.aovs;
        p.sampling = b.params.sampling;
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): other bits of the same number ask for another round
        return std::memcmp(&p, &b.params, sizeof p) == 0 && same_bytes(a.lights, b.lights) &&
               same_bytes(a.instances, b.instances) && a.radiosity == b.radiosity && a.photons == b.photons &&
               a.camera_rays == b.camera_rays;
    }

    /// Makes the scene, its photons and its radiosity those of the frame; false if it was stopped.
    bool prepare(const Frame& frame, const StopFlag& stop, Totals& totals) {
        traversal().update(frame);
        return prepare_photons(frame, stop, totals) && prepare_radiosity(frame, stop, totals);
    }

    /// What the kernel sees of a frame for which all that is prepared.
    [[nodiscard]] kernel::SceneView prepared_view(const Frame& frame) const {
        kernel::SceneView view = cpu::view_of(*scene_, frame, traversal().handle());
        view.indirect = radiosity_ ? &radiosity_->radiosity->light() : nullptr;
        view.photons = photons_ ? photons_->photons.get() : nullptr;
        return view;
    }

    /// Shoots what the frame needs, if it hasn't been; false if it was stopped.
    bool prepare_photons(const Frame& frame, const StopFlag& stop, Totals& totals) {
        if ((frame.params.features & kernel::FEATURE_PHOTONS) == 0) {
            photons_.reset();
            return true;
        }
        if (photons_ && same_photons(photons_->frame, frame)) return true;
        radiosity_.reset();
        photons_ = std::make_unique<PreparedPhotons>(PreparedPhotons{frame, nullptr});
        const Frame& kept = photons_->frame;
        photons_->photons = std::make_unique<cpu::Photons>(
            *scene_, kept, cpu::view_of(*scene_, kept, traversal().handle()), photon_kernel_);
        bool done = false;
        try {
            done = photons_->photons->prepare(stop);
        } catch (...) {
            photons_.reset();
            throw;
        }
        if (!done) {
            photons_.reset();
            totals.complete = false;
            return false;
        }
        totals.rays += photons_->photons->rays().rays;
        return true;
    }

    /// Gathers what the frame needs, if it hasn't been; false if it was stopped.
    bool prepare_radiosity(const Frame& frame, const StopFlag& stop, Totals& totals) {
        if ((frame.params.features & kernel::FEATURE_RADIOSITY) == 0) return true;
        if (radiosity_ && same_light(radiosity_->frame, frame)) return true;
        radiosity_ = std::make_unique<PreparedRadiosity>(PreparedRadiosity{frame, nullptr});
        const Frame& kept = radiosity_->frame;
        kernel::SceneView view = cpu::view_of(*scene_, kept, traversal().handle());
        if (photons_) view.photons = photons_->photons.get();
        radiosity_->radiosity = std::make_unique<cpu::Radiosity>(kept, view, rays_);
        bool done = false;
        try {
            done = radiosity_->radiosity->prepare(stop);
        } catch (...) {
            radiosity_.reset();
            throw;
        }
        if (!done) {
            radiosity_.reset();
            totals.complete = false;
            return false;
        }
        totals.rays += radiosity_->radiosity->rays().rays;
        totals.shadow_rays += radiosity_->radiosity->rays().shadow_rays;
        return true;
    }

    /// Calls visit(tile) from all threads, for the parts of `r` in tiles that are aligned to the picture.
    template <class Visit>
    static void for_each_tile(const PixelRect& r, int side, const Visit& visit) {
        const auto tiles_to = [&](int pixel) { return (pixel + side - 1) / side; };
        const tbb::blocked_range2d<int> tiles(r.y0 / side, tiles_to(r.y1), 1, r.x0 / side, tiles_to(r.x1), 1);
        tbb::parallel_for(tiles, [&](const tbb::blocked_range2d<int>& range) {
            for (int ty = range.rows().begin(); ty != range.rows().end(); ++ty)
                for (int tx = range.cols().begin(); tx != range.cols().end(); ++tx)
                    visit(PixelRect{std::max(r.x0, tx * side), std::max(r.y0, ty * side),
                                    std::min(r.x1, (tx + 1) * side), std::min(r.y1, (ty + 1) * side)});
        });
    }

    /// Calls visit(part) for the parts of a small region in tiles.
    template <class Visit>
    static void for_parts_of(const PixelRect& r, const Visit& visit) {
        for (int y = r.y0; y < r.y1; y = (y / kTileSide + 1) * kTileSide)
            for (int x = r.x0; x < r.x1; x = (x / kTileSide + 1) * kTileSide)
                visit(PixelRect{x, y, std::min(r.x1, (x / kTileSide + 1) * kTileSide),
                                std::min(r.y1, (y / kTileSide + 1) * kTileSide)});
    }

    void refine_tile(const kernel::SceneView& view, const PixelRect& tile, const RefinedWork& work, Film& film,
                     const StopFlag& stop, Totals& totals) {
        if (stop.requested()) {
            totals.complete = false;
            return;
        }
        const std::ptrdiff_t squares_across = (film.bounds.width() + sampling::kSquareSide - 1) / sampling::kSquareSide;
        const std::ptrdiff_t first_square =
            tile.y0 / sampling::kSquareSide * squares_across + tile.x0 / sampling::kSquareSide;
        const bool plain = (view.frame.features & ~kernel::FEATURES_PLAIN) == 0;
        const cpu::GridRays done = cpu::refine_tile({view,
                                                     plain ? plain_points_ : points_,
                                                     looks_,
                                                     tile,
                                                     {work.tolerance, work.gain},
                                                     work.finest.empty() ? nullptr : work.finest.data() + first_square,
                                                     squares_across,
                                                     work.method,
                                                     refinements_.local(),
                                                     film});
        totals.rays += done.rays;
        totals.shadow_rays += done.shadow_rays;
        totals.points += done.points;
    }

    void render_tile(const Frame& frame, const PixelRect& tile, const RenderWork& work, Film& film,
                     const StopFlag& stop, Totals& totals, const cpu::raster::FrameRaster* raster) const {
        if (stop.requested()) {
            totals.complete = false;
            return;
        }
        if (structure_ && !work.steps.empty()) count_steps(frame, tile, work, film, totals);
        else if (raster) render_rasterised(frame, tile, work, film, totals, *raster);
        else run_kernel(frame, tile, work, film, totals);
    }

    /// Pixel by pixel, with all others of a packet left out. The picture is the same.
    void count_steps(const Frame& frame, const PixelRect& tile, RenderWork work, Film& film, Totals& totals) const {
        std::vector<std::uint8_t> wanted(film.radiance.size(), 0);
        const std::span<const std::uint8_t> asked = work.wanted;
        work.wanted = wanted;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                const std::size_t pixel = film.index(x, y);
                if (!asked.empty() && asked[pixel] == 0) continue;
                wanted[pixel] = 1;
                const accel::Steps before = structure_->steps_of_this_thread();
                run_kernel(frame, {x, y, x + 1, y + 1}, work, film, totals);
                const accel::Steps now = structure_->steps_of_this_thread();
                work.steps[pixel] += now.visits - before.visits + now.tests - before.tests;
                wanted[pixel] = 0;
            }
    }

    /// Null where the frame's eye rays are traced.
    const cpu::raster::FrameRaster* prepare_raster(const Frame& frame) {
        if (frame.params.integrator != kernel::INTEGRATOR_WHITTED) return nullptr;
        if (primary_ == PrimaryHits::trace || !embree_ || !cpu::raster::FrameRaster::can(frame)) return nullptr;
        if (!raster_)
            raster_ = std::make_unique<cpu::raster::FrameRaster>(*scene_, cpu::raster::raster_kernels(lanes_));
        if (primary_ == PrimaryHits::automatic && !raster_->pays(frame)) return nullptr;
        raster_->prepare(frame);
        return raster_.get();
    }

    /// Sets light_cells_: null where all shadow rays are traced.
    void prepare_light_buffers(const Frame& frame, bool many_pixels) {
        light_cells_ = nullptr;
        if (!uses_light_buffers_ || !embree_ || !many_pixels || frame.params.integrator != kernel::INTEGRATOR_WHITTED)
            return;
        if (!light_buffers_)
            light_buffers_ = std::make_unique<cpu::raster::LightBuffers>(*scene_, cpu::raster::cell_kernel(lanes_));
        if (!light_buffers_->pays(frame)) return;
        light_buffers_->prepare(frame);
        light_cells_ = light_buffers_->cells();
    }

    /// For a region that lies in one of the tiles.
    void render_rasterised(const Frame& frame, const PixelRect& tile, RenderWork work, Film& film, Totals& totals,
                           const cpu::raster::FrameRaster& raster) const {
        static_assert(kTileSide == cpu::raster::kTileSide);
        RasterScratch& scratch = raster_scratch_.local();
        if (!scratch.tile) scratch.tile = std::make_unique<cpu::raster::TileScratch>();
        const std::uint32_t end = work.first_sample + work.sample_count;
        for (work.sample_count = 1; work.first_sample < end; ++work.first_sample) {
            const cpu::RasterisedTile known =
                raster.tile(tile, frame.params.sampling, work.first_sample, *scratch.tile, scratch.list);
            run_kernel(frame, tile, work, film, totals, &known);
        }
    }

    void run_kernel(const Frame& frame, const PixelRect& tile, const RenderWork& work, Film& film, Totals& totals,
                    const cpu::RasterisedTile* rasterised = nullptr) const {
        const bool paths = frame.params.integrator != kernel::INTEGRATOR_WHITTED;
        const std::uint32_t plain_features = paths ? kernel::FEATURES_PLAIN_PATHS : kernel::FEATURES_PLAIN;
        const bool plain = (frame.params.features & ~plain_features) == 0;
        const cpu::TileKernel run =
            paths ? (plain ? plain_path_kernel_ : path_kernel_) : (plain ? plain_kernel_ : kernel_);
        const cpu::TileRays done =
            run({*scene_, frame, traversal().handle(), tile, work.first_sample, work.sample_count, film, work.wanted,
                 radiosity_ ? &radiosity_->radiosity->light() : nullptr, photons_ ? photons_->photons.get() : nullptr,
                 light_cells_, rasterised});
        totals.rays += done.rays;
        totals.shadow_rays += done.shadow_rays;
    }

    static bool count_memory(void* total, ssize_t bytes, bool) {
        *static_cast<std::atomic<std::int64_t>*>(total) += bytes;
        return true;
    }

    [[nodiscard]] cpu::Traversal& traversal() const {
        return embree_ ? static_cast<cpu::Traversal&>(*embree_) : *structure_;
    }

    /// A thread's memory for rasterising.
    struct RasterScratch {
        std::unique_ptr<cpu::raster::TileScratch> tile;
        std::vector<std::uint32_t> list;
    };

    Acceleration acceleration_;
    PrimaryHits primary_;
    bool uses_light_buffers_;
    int lanes_;
    DeviceInfo info_;
    cpu::TileKernel kernel_ = nullptr;
    cpu::TileKernel plain_kernel_ = nullptr;
    cpu::TileKernel path_kernel_ = nullptr;
    cpu::TileKernel plain_path_kernel_ = nullptr;
    cpu::PointKernel points_ = nullptr, plain_points_ = nullptr;
    cpu::LookKernel looks_ = nullptr;
    cpu::RayKernel rays_ = nullptr;
    cpu::PhotonKernel photon_kernel_ = nullptr;
    cpu::ShapeCallbacks shapes_{};
    tbb::task_arena arena_;
    std::atomic<std::int64_t> bytes_{0};  // outlives the Embree objects that count themselves off
    embree::Device device_;
    std::shared_ptr<const RenderScene> scene_;
    std::unique_ptr<cpu::EmbreeScene> embree_;  // one of these two
    std::unique_ptr<cpu::StructureScene> structure_;
    std::unique_ptr<PreparedPhotons> photons_;
    std::unique_ptr<PreparedRadiosity> radiosity_;
    std::unique_ptr<cpu::raster::FrameRaster> raster_;          ///< Made when a frame is first rasterised.
    std::unique_ptr<cpu::raster::LightBuffers> light_buffers_;  ///< Likewise.
    const kernel::LightCells* light_cells_ = nullptr;           ///< Of the picture under way.
    mutable tbb::enumerable_thread_specific<RasterScratch> raster_scratch_;
    tbb::enumerable_thread_specific<cpu::RefinementMemory> refinements_;
};

}  // namespace

std::unique_ptr<Device> make_cpu_device(const CpuOptions& options) { return std::make_unique<CpuDevice>(options); }

}  // namespace sundog
