// SPDX-License-Identifier: Apache-2.0
#include "accel_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>
#include <numeric>
#include <random>
#include <thread>

#include "compile/compile.h"
#include "device/choose/choose.h"
#include "gallery.h"
#include "import/import.h"
#include "machine.h"
#include "spd/spd.h"
#include "statistics.h"

namespace sundog::bench {
namespace {

constexpr int kWidth = 320, kHeight = 240, kBlock = 8;
/// A structure is measured for about so many processor seconds in a round.
constexpr double kRoundSeconds = 0.1;
/// Pixels whose steps are counted.
constexpr std::size_t kCountedPixels = 600;

struct Generated {
    const char* name;
    scene::Scene (*make)();
};
constexpr std::array<Generated, 7> kGenerated{{{"balls", spd_balls},
                                               {"gears", spd_gears},
                                               {"mount", spd_mount},
                                               {"rings", spd_rings},
                                               {"tetra", spd_tetra},
                                               {"tree", spd_tree},
                                               {"scan", [] { return scanned_knot(200, 500); }}}};

/// Processor seconds of all threads: other programs change them less than time on the clock.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// All blocks of the picture in a shuffled order, so that any number of them from the first on is spread over it.
std::vector<PixelRect> blocks() {
    std::vector<PixelRect> all;
    for (int y = 0; y < kHeight; y += kBlock)
        for (int x = 0; x < kWidth; x += kBlock) all.push_back({x, y, x + kBlock, y + kBlock});
    std::mt19937 random(1);
    for (std::size_t i = all.size() - 1; i > 0; --i) std::swap(all[i], all[random() % (i + 1)]);
    return all;
}

/// One structure with a scene in it, and what was measured so far.
class Contestant {
public:
    Contestant(Acceleration structure, const std::string& name, std::shared_ptr<const RenderScene> scene, int threads)
        : device_(open_device("cpu", threads, structure)), blocks_(blocks()), film_({0, 0, kWidth, kHeight}) {
        timing_.scene = name;
        timing_.structure = structure;
        for (const kernel::Geometry& g : scene->geometries) timing_.primitives += g.primitive_count;
        const double start = processor_seconds();
        device_->load(std::move(scene));
        timing_.build_s = processor_seconds() - start;
        timing_.bytes = device_->memory_bytes();
    }

    /// Traces blocks for about kRoundSeconds: at least one, and never the same ones in a batch.
    void measure(const Frame& frame) {
        double rays = 0;
        const double start = processor_seconds();
        double seconds = 0;
        do {
            const std::size_t count = std::min(batch_, blocks_.size() - next_);
            const RenderStats stats = device_->render_regions(frame, std::span(blocks_).subspan(next_, count),
                                                              {film_.bounds, 0, 1}, film_, StopFlag());
            next_ = (next_ + count) % blocks_.size();
            rays += static_cast<double>(stats.rays);
            seconds = processor_seconds() - start;
            if (seconds < kRoundSeconds / 8) batch_ = std::min(2 * batch_, blocks_.size());
        } while (seconds < kRoundSeconds);
        rates_.push_back(rays / seconds);
    }
    /// Counts the steps of some pixels' rays, the same pixels for all. Caches, threads and pages are warm after this.
    void warm_up(const Frame& frame) {
        if (timing_.structure == Acceleration::embree) {
            measure(frame);
            rates_.clear();
            return;
        }
        std::vector<PixelRect> pixels;
        for (std::size_t i = 0; i < kCountedPixels; ++i) {
            const PixelRect& block = blocks_[i % blocks_.size()];
            const int x = block.x0 + static_cast<int>(i * 5 % kBlock), y = block.y0 + static_cast<int>(i * 3 % kBlock);
            pixels.push_back({x, y, x + 1, y + 1});
        }
        std::vector<std::uint64_t> steps(film_.radiance.size(), 0);
        const RenderStats stats =
            device_->render_regions(frame, pixels, {film_.bounds, 0, 1, {}, steps}, film_, StopFlag());
        const auto rays = static_cast<double>(std::max<std::uint64_t>(stats.rays, 1));
        timing_.visits = static_cast<double>(stats.visits) / rays;
        timing_.tests = static_cast<double>(stats.tests) / rays;
    }

    [[nodiscard]] AccelTiming result() const {
        AccelTiming timing = timing_;
        timing.rays_per_second = median(rates_);
        return timing;
    }

private:
    std::unique_ptr<Device> device_;
    std::vector<PixelRect> blocks_;
    Film film_;
    AccelTiming timing_;
    std::size_t next_ = 0, batch_ = 2;
    std::vector<double> rates_;
};

void measure_scene(const std::string& name, const AccelOptions& options, const StopFlag& stop, AccelReport& report) {
    const scene::Scene scene = accel_scene(options.gallery, name);
    const auto compiled = compile(scene, {});
    FrameOptions frame_options;
    frame_options.width = kWidth;
    frame_options.height = kHeight;
    const Frame frame = make_frame(scene, *compiled, frame_options);
    std::vector<std::unique_ptr<Contestant>> contestants;
    for (std::size_t i = 0; i < kAccelerationNames.size() && !stop.requested(); ++i) {
        contestants.push_back(
            std::make_unique<Contestant>(static_cast<Acceleration>(i), name, compiled, options.threads));
        contestants.back()->warm_up(frame);
    }
    for (int round = 0; round < options.rounds && !stop.requested(); ++round)
        for (const auto& contestant : contestants) contestant->measure(frame);
    if (stop.requested()) return;
    for (const auto& contestant : contestants) report.timings.push_back(contestant->result());
}

}  // namespace

std::vector<std::string> accel_scene_names() {
    std::vector<std::string> names(kGalleryScenes.begin(), kGalleryScenes.end());
    for (const Generated& generated : kGenerated) names.emplace_back(generated.name);
    return names;
}

scene::Scene accel_scene(const std::filesystem::path& gallery, std::string_view name) {
    for (const Generated& generated : kGenerated)
        if (name == generated.name) return generated.make();
    const std::string file(name);
    const std::filesystem::path folder = gallery.empty() ? SUNDOG_GALLERY : gallery;
    return import::import_scene(folder / file / (file + ".scene"), {});
}

AccelReport run_accel_bench(const AccelOptions& options_, const std::function<void(std::string_view)>& note,
                            const StopFlag& stop) {
    AccelOptions options = options_;
    if (options.threads <= 0) options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    AccelReport report{machine_name(), options.threads, options.rounds, {}};
    for (const std::string& name : accel_scene_names()) {
        if (stop.requested() || (!options.only.empty() && options.only != name)) continue;
        if (note) note(name);
        measure_scene(name, options, stop, report);
    }
    return report;
}

std::string format_report(const AccelReport& report) {
    std::string text =
        fmt::format("{}; {} threads used; medians of {} rounds\n\n", report.machine, report.threads, report.rounds);
    text += fmt::format("{:<9} {:>10}  {:<9} {:>9} {:>9} {:>10} {:>11} {:>8} {:>9}\n", "scene", "primitives",
                        "structure", "build ms", "MiB", "visits/ray", "tests/ray", "Mrays/s", "to embree");
    double embree = 0;
    std::string last;
    for (const AccelTiming& t : report.timings) {
        const bool counts = t.structure != Acceleration::embree;
        if (!counts) embree = t.rays_per_second;
        const bool first = t.scene != last;
        last = t.scene;
        text +=
            fmt::format("{:<9} {:>10}  {:<9} {:>9.2f} {:>9.2f} {:>10} {:>11} {:>8.3f} {:>9}\n", first ? t.scene : "",
                        first ? fmt::format("{}", t.primitives) : "", name_of(t.structure), t.build_s * 1e3,
                        static_cast<double>(t.bytes) / (1024.0 * 1024.0),
                        counts ? fmt::format("{:.1f}", t.visits) : "-", counts ? fmt::format("{:.1f}", t.tests) : "-",
                        t.rays_per_second * 1e-6, embree > 0 ? fmt::format("{:.3f}", t.rays_per_second / embree) : "-");
    }
    text +=
        "\nvisits: nodes, cells or boxes; tests: primitives; rays of all kinds, shading included; times are processor "
        "seconds\n";
    return text;
}

}  // namespace sundog::bench
