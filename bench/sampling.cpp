// SPDX-License-Identifier: Apache-2.0
#include "bench/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

#include "compile/compile.h"
#include "device/choose/choose.h"
#include "film_image.h"
#include "gallery.h"
#include "import/import.h"
#include "output/compare.h"
#include "session/session.h"
#include "statistics.h"

namespace sundog::bench {
namespace {

/// A way to make a picture.
struct Way {
    std::string name;
    kernel::PixelSampling sampling;
    std::function<RenderResult(Session&, const Frame&, const StopFlag&)> render;
};

std::function<RenderResult(Session&, const Frame&, const StopFlag&)> fixed(std::uint32_t samples) {
    return [samples](Session& session, const Frame& frame, const StopFlag& stop) {
        return session.render(frame, samples, {}, stop);
    };
}

struct NamedFilter {
    const char* name;
    std::uint32_t filter;
    float radius;
};
constexpr std::array<NamedFilter, 5> kFilters{{{"tent", kernel::FILTER_TENT, 1},
                                               {"gaussian", kernel::FILTER_GAUSSIAN, 1.5F},
                                               {"mitchell", kernel::FILTER_MITCHELL, 2},
                                               {"blackman-harris", kernel::FILTER_BLACKMAN_HARRIS, 1.5F},
                                               {"box of radius 1", kernel::FILTER_BOX, 1}}};

/// Those with the pixel's own square as their filter.
std::vector<Way> ways_of_squares() {
    std::vector<Way> ways;
    constexpr std::array<const char*, 4> kPatterns{"r2", "regular", "jittered", "sobol"};
    for (std::uint32_t pattern = 0; pattern < kPatterns.size(); ++pattern)
        for (const std::uint32_t side : {1U, 2U, 4U, 8U})
            ways.push_back({fmt::format("{} {}", kPatterns[pattern], side * side),
                            {pattern, pattern == kernel::SAMPLES_SOBOL ? 0 : side, kernel::FILTER_PIXEL, 0},
                            fixed(side * side)});
    for (const auto& [threshold, samples] : {std::pair{0.3, 9U}, {0.1, 9U}, {0.1, 25U}, {0.03, 64U}})
        ways.push_back(
            {fmt::format("adaptive {:g}, {}", threshold, samples),
             {},
             [threshold = threshold, samples = samples](Session& session, const Frame& frame, const StopFlag& stop) {
                 return session.render_adaptive(frame, {.threshold = threshold, .samples = samples}, {}, stop);
             }});
    for (const auto& [threshold, samples] : {std::pair{0.3, 9U}, {0.1, 25U}})
        ways.push_back(
            {fmt::format("preview 0.1, adaptive {:g}, {}", threshold, samples),
             {},
             [threshold = threshold, samples = samples](Session& session, const Frame& frame, const StopFlag& stop) {
                 return session.render_adaptive(frame, {.threshold = threshold, .samples = samples, .preview = 0.1F},
                                                {}, stop);
             }});
    for (const auto& [threshold, depth] : {std::pair{0.3, 2}, {0.1, 3}, {0.03, 4}})
        ways.push_back(
            {fmt::format("recursive {:g}, depth {}", threshold, depth),
             {},
             [threshold = threshold, depth = depth](Session& session, const Frame& frame, const StopFlag& stop) {
                 return session.render_recursive(frame, {.threshold = threshold, .depth = depth}, {}, stop);
             }});
    for (const double error : {0.1, 0.03, 0.01})
        ways.push_back({fmt::format("target error {:g}", error),
                        {},
                        [error](Session& session, const Frame& frame, const StopFlag& stop) {
                            ErrorDrivenResult result = session.render_to_error(frame, {.error = error}, {}, stop);
                            return RenderResult{std::move(result.film), result.stats, result.seconds, result.stopped};
                        }});
    return ways;
}

/// One scene's pictures.
class SceneRun {
public:
    SceneRun(std::string name, const SamplingOptions& options, const std::function<void(const SamplingTiming&)>& done,
             const StopFlag& stop)
        : name_(std::move(name)),
          options_(options),
          done_(done),
          stop_(stop),
          scene_(
              import::import_scene((options.gallery.empty() ? std::filesystem::path(SUNDOG_GALLERY) : options.gallery) /
                                       name_ / (name_ + ".scene"),
                                   {})),
          compiled_(compile(scene_, {})),
          session_(open_device("cpu", options.threads > 0
                                          ? options.threads
                                          : static_cast<int>(std::max(1U, std::thread::hardware_concurrency())))) {
        session_.load(compiled_);
    }

    void run() {
        const output::Image squares = reference({});
        for (const Way& way : ways_of_squares()) measure(way, squares);
        for (const NamedFilter& filter : kFilters) {
            const kernel::PixelSampling sampling{kernel::SAMPLES_SOBOL, 0, filter.filter, filter.radius};
            const output::Image filtered = reference(sampling);
            measure({fmt::format("{}, sobol 16", filter.name), sampling, fixed(16)}, filtered);
        }
    }

private:
    [[nodiscard]] Frame frame(const kernel::PixelSampling& sampling) const {
        FrameOptions options;
        options.width = options_.width;
        options.height = options_.height;
        options.sampling = sampling;
        return make_frame(scene_, *compiled_, options);
    }
    output::Image reference(kernel::PixelSampling sampling) {
        sampling.pattern = kernel::SAMPLES_SOBOL;
        return image_of(
            session_.render(frame(sampling), static_cast<std::uint32_t>(options_.reference_samples), {}, stop_).film);
    }
    void measure(const Way& way, const output::Image& reference) {
        std::vector<double> seconds;
        SamplingTiming timing{.scene = name_, .way = way.name};
        for (int round = 0; round < options_.rounds && !stop_.requested(); ++round) {
            const RenderResult result = way.render(session_, frame(way.sampling), stop_);
            seconds.push_back(result.seconds);
            if (round > 0) continue;
            const output::Comparison c = output::compare(image_of(result.film), reference);
            timing.rmse = c.rmse;
            timing.psnr_db = c.psnr_db;
            timing.samples = samples_taken(result) / static_cast<double>(result.film.radiance.size());
        }
        if (stop_.requested()) return;
        timing.seconds = median(seconds);
        done_(timing);
    }

    std::string name_;
    const SamplingOptions& options_;
    const std::function<void(const SamplingTiming&)>& done_;
    const StopFlag& stop_;
    scene::Scene scene_;
    std::shared_ptr<const RenderScene> compiled_;
    Session session_;
};

}  // namespace

void run_sampling(const SamplingOptions& options, const std::function<void(const SamplingTiming&)>& done,
                  const StopFlag& stop) {
    for (const std::string name : kGalleryScenes) {
        if (!options.scene.empty() && options.scene != name) continue;
        if (stop.requested()) return;
        SceneRun(name, options, done, stop).run();
    }
}

std::string sampling_head() {
    return fmt::format("{:<9} {:<32} | {:>7} {:>9} | {:>8} {:>7}\n", "scene", "way", "samples", "ms", "RMSE",
                       "PSNR dB");
}

std::string sampling_row(const SamplingTiming& t) {
    return fmt::format("{:<9} {:<32} | {:>7.2f} {:>9.1f} | {:>8.5f} {:>7.2f}\n", t.scene, t.way, t.samples,
                       t.seconds * 1e3, t.rmse, t.psnr_db);
}

}  // namespace sundog::bench
