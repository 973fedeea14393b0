// SPDX-License-Identifier: Apache-2.0
#include "bench/shadows.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <thread>
#include <vector>

#include "bench/accel_bench.h"
#include "bench/gallery.h"
#include "compile/compile.h"
#include "device/cpu/cpu_device.h"
#include "statistics.h"

namespace sundog::bench {
namespace {

constexpr int kSizes[][2] = {{640, 480}, {1920, 1080}};

/// Processor seconds of all threads: other programs change them less than time on the clock.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::unique_ptr<Device> device_with(bool light_buffers, int threads, const std::shared_ptr<const RenderScene>& scene) {
    CpuOptions options;
    options.threads = threads;
    options.light_buffers = light_buffers;
    auto device = make_cpu_device(options);
    device->load(scene);
    return device;
}

}  // namespace

void run_shadows(const ShadowOptions& options, const std::function<void(const ShadowTiming&)>& done,
                 const StopFlag& stop) {
    const int threads =
        options.threads > 0 ? options.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    for (const std::string& name : accel_scene_names()) {
        if (!options.scene.empty() && options.scene != name) continue;
        const scene::Scene scene = accel_scene(options.gallery, name);
        const std::shared_ptr<const RenderScene> compiled = compile(scene, {});
        const auto without = device_with(false, threads, compiled), with = device_with(true, threads, compiled);
        for (const auto& size : kSizes) {
            ShadowTiming timing{.scene = name, .width = size[0], .height = size[1]};
            std::vector<double> traced_s, moving_s, resting_s, unused_s;
            Film film({0, 0, size[0], size[1]});
            FrameOptions frame_options;
            frame_options.width = size[0];
            frame_options.height = size[1];
            const Frame frame = make_frame(scene, *compiled, frame_options);
            // The first round warms caches and threads.
            for (int round = -1; round < options.rounds; ++round) {
                if (stop.requested()) return;
                Frame moved = frame;
                for (kernel::Light& light : moved.lights) light.place.x += 1e-4F * static_cast<float>(round + 2);
                RenderStats stats;
                const auto measure = [&](Device& device, const Frame& which, std::vector<double>& times_s) {
                    const double start = processor_seconds();
                    stats = device.render(which, {film.bounds, 0, 1}, film, stop);
                    if (round >= 0) times_s.push_back(processor_seconds() - start);
                };
                measure(*without, frame, traced_s);
                measure(*with, moved, moving_s);
                measure(*with, frame, unused_s);
                measure(*with, frame, resting_s);
                timing.shadow_share = static_cast<double>(stats.shadow_rays) /
                                      static_cast<double>(std::max<std::uint64_t>(stats.rays, 1));
            }
            timing.traced_s = median(traced_s);
            timing.moving_s = median(moving_s);
            timing.resting_s = median(resting_s);
            done(timing);
        }
    }
}

std::string shadows_head() {
    return fmt::format("{:<9} {:>9} {:>8} | {:>9} | {:>9} {:>6} | {:>9} {:>6}\n", "scene", "size", "shadow %",
                       "traced ms", "moving", "ratio", "resting", "ratio");
}

std::string shadows_row(const ShadowTiming& t) {
    return fmt::format("{:<9} {:>9} {:>8.0f} | {:>9.2f} | {:>9.2f} {:>6.3f} | {:>9.2f} {:>6.3f}\n", t.scene,
                       fmt::format("{}x{}", t.width, t.height), 100 * t.shadow_share, t.traced_s * 1e3,
                       t.moving_s * 1e3, t.traced_s / t.moving_s, t.resting_s * 1e3, t.traced_s / t.resting_s);
}

}  // namespace sundog::bench
