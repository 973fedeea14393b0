// SPDX-License-Identifier: Apache-2.0
#include "bench.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "compile/compile.h"
#include "device/choose/choose.h"
#include "import/import.h"
#include "machine.h"
#include "output/image.h"
#include "raw_embree.h"
#include "statistics.h"
#include "tachyon.h"

namespace sundog::bench {

namespace {

using Clock = std::chrono::steady_clock;

/// Frames are repeated for about this long in a round, so that short ones are measured well too.
constexpr double kRoundSeconds = 0.12;
constexpr int kTachyonRounds = 3;  // It takes seconds where we take milliseconds.

struct Case {
    const char* scene;
    int width, height;
    std::uint32_t depth;
};
constexpr Case kCases[] = {{"table", 640, 480, 1}, {"table", 1920, 1080, 1}, {"cornell", 512, 512, 2}};

/// A scene ready to be traced.
struct Prepared {
    scene::Scene scene;
    std::shared_ptr<const RenderScene> compiled;
    FrameOptions options;
    [[nodiscard]] Frame frame() const { return make_frame(scene, *compiled, options); }
};

Prepared prepare(const std::filesystem::path& gallery, const Case& c) {
    Prepared prepared;
    const std::string name = c.scene;
    prepared.scene = import::import_scene(gallery / name / (name + ".scene"), {});
    prepared.compiled = compile(prepared.scene, {});
    prepared.options.width = c.width;
    prepared.options.height = c.height;
    prepared.options.max_depth = static_cast<int>(c.depth);
    prepared.options.min_weight = 0.0F;  // So that both sides follow every ray.
    prepared.options.shadows = true;
    return prepared;
}

/// Seconds a call of `work`, which is repeated for about kRoundSeconds.
template <class Work>
double seconds_a_call(const Work& work) {
    const auto start = Clock::now();
    double elapsed = 0;
    int calls = 0;
    do {
        work();
        ++calls;
        elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    } while (elapsed < kRoundSeconds);
    return elapsed / calls;
}

/// A folder of our own that goes when this does.
class TemporaryFolder {
public:
    TemporaryFolder()
        : path_(std::filesystem::temp_directory_path() / fmt::format("sundog-bench-{}", static_cast<long>(getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

FrameTiming time_frames(const Case& c, const Prepared& prepared, Device& device, const BenchOptions& options,
                        const StopFlag& stop) {
    FrameTiming timing{.scene = c.scene,
                       .width = c.width,
                       .height = c.height,
                       .depth = c.depth,
                       .device = device.info().kind == "cpu" ? "cpu" : device.info().name,
                       .raw_s = {},
                       .ratio = {},
                       .tachyon_s = {}};
    const bool cpu = device.info().kind == "cpu";
    std::unique_ptr<RawEmbree> raw;
    if (cpu) raw = std::make_unique<RawEmbree>(prepared.compiled, options.threads);
    device.load(prepared.compiled);
    Film film({0, 0, c.width, c.height});
    const auto ours = [&] {
        timing.rays = static_cast<double>(device.render(prepared.frame(), {film.bounds, 0, 1}, film, StopFlag()).rays);
    };
    const auto theirs = [&] { timing.raw_rays = static_cast<double>(raw->trace(prepared.frame()).rays); };
    ours();  // Caches, threads and pages are warm from here on.
    if (raw) theirs();
    std::vector<double> our_times, raw_times, ratios;
    for (int round = 0; round < options.rounds && !stop.requested(); ++round) {
        our_times.push_back(seconds_a_call(ours));
        if (!raw) continue;
        raw_times.push_back(seconds_a_call(theirs));
        ratios.push_back(our_times.back() / raw_times.back());
    }
    timing.frame_s = median(our_times);
    if (raw) timing.raw_s = median(raw_times), timing.ratio = median(ratios);
    return timing;
}

std::optional<double> time_tachyon(const Case& c, const Prepared& prepared, const std::filesystem::path& folder,
                                   int threads, const StopFlag& stop) {
    const std::filesystem::path file = folder / fmt::format("{}_{}.dat", c.scene, c.width);
    output::write_file_atomically(file, tachyon_scene(*prepared.compiled, prepared.frame()));
    std::vector<double> times;
    for (int round = 0; round < kTachyonRounds && !stop.requested(); ++round) {
        const std::optional<double> seconds = run_tachyon(file, c.width, c.height, threads);
        if (!seconds) return std::nullopt;
        times.push_back(*seconds);
    }
    return times.empty() ? std::nullopt : std::optional(median(times));
}

std::string milliseconds(const std::optional<double>& seconds) {
    return seconds ? fmt::format("{:.2f}", *seconds * 1e3) : "-";
}

}  // namespace

BenchReport run_bench(const BenchOptions& options_, const std::function<void(std::string_view)>& note,
                      const StopFlag& stop) {
    BenchOptions options = options_;
    if (options.threads <= 0) options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const std::filesystem::path gallery = options.gallery.empty() ? SUNDOG_GALLERY : options.gallery;
    const TemporaryFolder folder;
    BenchReport report;
    report.machine = machine_name();
    report.threads = options.threads;
    report.rounds = options.rounds;
    bool tachyon = options.tachyon;
    for (const std::string& choice : options.devices) {
        const std::unique_ptr<Device> device = open_device(choice, options.threads);
        const bool cpu = device->info().kind == "cpu";
        for (const Case& c : kCases) {
            if (stop.requested()) return report;
            note(fmt::format("{} {}x{} on {}", c.scene, c.width, c.height, device->info().name));
            const Prepared prepared = prepare(gallery, c);
            FrameTiming timing = time_frames(c, prepared, *device, options, stop);
            if (cpu) report.raw_name = RawEmbree(prepared.compiled, options.threads).name();
            if (cpu && tachyon && !stop.requested()) {
                timing.tachyon_s = time_tachyon(c, prepared, folder.path(), options.threads, stop);
                if (!timing.tachyon_s && !stop.requested()) {
                    tachyon = false;
                    report.notes.emplace_back(
                        "Tachyon is not installed (Debian: apt install tachyon): its times are left out");
                }
            }
            report.frames.push_back(std::move(timing));
        }
    }
    if (options.load && !stop.requested()) {
        note("a model of 1,000,000 triangles");
        const std::filesystem::path model = folder.path() / "million.obj";
        output::write_file_atomically(model, bumpy_sphere_obj(501));
        for (const std::string& device : options.devices)
            report.loads.emplace_back(device, time_first_picture(model, device, options.threads));
    }
    return report;
}

std::string format_report(const BenchReport& report) {
    std::string text =
        fmt::format("{}; {} threads used; medians of {} rounds\n\n", report.machine, report.threads, report.rounds);
    text += fmt::format("{:<8} {:>9} {:>5}  {:<22} {:>8} {:>8} {:>8} | {:>8} {:>8} {:>6} | {:>10} {:>7}\n", "scene",
                        "size", "depth", "device", "ms/frame", "frames/s", "Mrays/s", "raw ms", "Mrays/s", "ratio",
                        "Tachyon ms", "to ours");
    for (const FrameTiming& t : report.frames) {
        text += fmt::format("{:<8} {:>9} {:>5}  {:<22.22} {:>8} {:>8.1f} {:>8.1f} | {:>8} {:>8} {:>6} | {:>10} {:>7}\n",
                            t.scene, fmt::format("{}x{}", t.width, t.height), t.depth, t.device,
                            milliseconds(t.frame_s), 1 / t.frame_s, t.rays / t.frame_s * 1e-6, milliseconds(t.raw_s),
                            t.raw_s ? fmt::format("{:.1f}", t.raw_rays / *t.raw_s * 1e-6) : "-",
                            t.ratio ? fmt::format("{:.2f}", *t.ratio) : "-", milliseconds(t.tachyon_s),
                            t.tachyon_s ? fmt::format("{:.1f}", *t.tachyon_s / t.frame_s) : "-");
    }
    if (!report.raw_name.empty())
        text += fmt::format("raw: {}, the same rays without any shading; ratio: our frame to it\n", report.raw_name);
    for (const auto& [device, times] : report.loads) {
        text += fmt::format(
            "\n{} triangles from a {:.0f} MiB OBJ file to the first 640x480 picture on {}: {:.2f} s\n"
            "  read {:.2f}, compile {:.2f}, build and upload {:.2f}, render {:.3f}\n",
            times.triangles, times.file_mib, device, times.total_s(), times.import_s, times.compile_s, times.load_s,
            times.render_s);
    }
    for (const std::string& line : report.notes) text += "\n" + line + "\n";
    return text;
}

}  // namespace sundog::bench
