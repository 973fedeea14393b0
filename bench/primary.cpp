// SPDX-License-Identifier: Apache-2.0
#include "bench/primary.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <thread>
#include <vector>

#include "compile/compile.h"
#include "device/choose/choose.h"
#include "device/cpu/raster/frame_raster.h"
#include "gallery.h"
#include "import/import.h"
#include "spd/spd.h"
#include "statistics.h"

namespace sundog::bench {
namespace {

constexpr int kSizes[][2] = {{640, 480}, {1920, 1080}};
/// Around and along the knot.
constexpr int kKnots[][2] = {{20, 25}, {50, 100}, {200, 250}, {500, 1000}};

/// Processor seconds of all threads: other programs change them less than time on the clock.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One way of finding what the eye sees.
struct Contestant {
    std::unique_ptr<Device> device;
    std::vector<double> whole_s, eye_s;

    Contestant(PrimaryHits how, int threads, const std::shared_ptr<const RenderScene>& scene)
        : device(open_device("cpu", threads, Acceleration::embree, how)) {
        device->load(scene);
    }
    void measure(const Frame& frame, std::vector<double>& times_s, Film& film, const StopFlag& stop) const {
        const double start = processor_seconds();
        device->render(frame, {film.bounds, 0, 1}, film, stop);
        times_s.push_back(processor_seconds() - start);
    }
};

void measure_scene(const std::string& name, const scene::Scene& scene, const PrimaryOptions& options, int threads,
                   const std::function<void(const PrimaryTiming&)>& done, const StopFlag& stop) {
    const std::shared_ptr<const RenderScene> compiled = compile(scene, {});
    Contestant traced(PrimaryHits::trace, threads, compiled), rastered(PrimaryHits::raster, threads, compiled);
    const cpu::raster::FrameRaster chooser(*compiled, cpu::raster::raster_kernels(4));
    for (const auto& size : kSizes) {
        for (Contestant* c : {&traced, &rastered}) c->whole_s.clear(), c->eye_s.clear();
        Film film({0, 0, size[0], size[1]});
        PrimaryTiming timing{.scene = name, .width = size[0], .height = size[1]};
        // The first round warms caches and threads.
        for (int round = -1; round < options.rounds; ++round) {
            for (const bool whole : {true, false}) {
                if (stop.requested()) return;
                FrameOptions frame_options;
                frame_options.width = size[0];
                frame_options.height = size[1];
                if (!whole) frame_options.shadows = false, frame_options.max_depth = 0;
                Frame frame = make_frame(scene, *compiled, frame_options);
                frame.params.camera.eye.x += 1e-4F * static_cast<float>(2 * round + (whole ? 1 : 0));
                timing.chosen = cpu::raster::FrameRaster::can(frame) && chooser.pays(frame);
                std::vector<double> warm_s;
                for (Contestant* c : {&traced, &rastered})
                    c->measure(frame, round < 0 ? warm_s : whole ? c->whole_s : c->eye_s, film, stop);
            }
        }
        timing.triangles = chooser.triangle_count();
        timing.traced_s = median(traced.whole_s);
        timing.rastered_s = median(rastered.whole_s);
        timing.eye_traced_s = median(traced.eye_s);
        timing.eye_rastered_s = median(rastered.eye_s);
        done(timing);
    }
}

}  // namespace

void run_primary(const PrimaryOptions& options, const std::function<void(const PrimaryTiming&)>& done,
                 const StopFlag& stop) {
    const std::filesystem::path gallery = options.gallery.empty() ? SUNDOG_GALLERY : options.gallery;
    const int threads =
        options.threads > 0 ? options.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    for (const std::string name : kGalleryScenes)
        if (options.scene.empty() || options.scene == name)
            measure_scene(name, import::import_scene(gallery / name / (name + ".scene"), {}), options, threads, done,
                          stop);
    if (!options.scene.empty() && options.scene != "knot") return;
    for (const auto& knot : kKnots)
        if (!stop.requested()) measure_scene("knot", scanned_knot(knot[0], knot[1]), options, threads, done, stop);
}

std::string primary_head() {
    return fmt::format("{:<9} {:>9} {:>9} | {:>9} {:>9} {:>6} | {:>9} {:>9} {:>6} | {}\n", "scene", "triangles", "size",
                       "traced ms", "raster", "ratio", "eye alone", "raster", "ratio", "auto");
}

std::string primary_row(const PrimaryTiming& t) {
    return fmt::format("{:<9} {:>9} {:>9} | {:>9.2f} {:>9.2f} {:>6.2f} | {:>9.2f} {:>9.2f} {:>6.2f} | {}\n", t.scene,
                       t.triangles, fmt::format("{}x{}", t.width, t.height), t.traced_s * 1e3, t.rastered_s * 1e3,
                       t.traced_s / t.rastered_s, t.eye_traced_s * 1e3, t.eye_rastered_s * 1e3,
                       t.eye_traced_s / t.eye_rastered_s, t.chosen ? "raster" : "trace");
}

}  // namespace sundog::bench
