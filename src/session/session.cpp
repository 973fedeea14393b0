// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "base/diagnostics.h"
#include "sampling/passes.h"

namespace sundog {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBandSeconds = 0.05;  // A band should take about this long: progress shows, overhead doesn't.
constexpr int kRowUnit = 16;           // Bands are made of whole tiles of the devices.

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Chooses how many rows to render next from how fast the last ones went.
class BandSizer {
public:
    [[nodiscard]] int rows(int width, std::uint32_t samples) const {
        if (samples_per_second_ <= 0) return 4 * kRowUnit;
        const double samples_per_row = static_cast<double>(width) * samples;
        const double rows = samples_per_second_ * kBandSeconds / samples_per_row;
        return kRowUnit * static_cast<int>(std::clamp(rows / kRowUnit, 1.0, 4096.0));
    }
    void measured(double samples, double seconds) { samples_per_second_ = samples / std::max(seconds, 1e-6); }

private:
    double samples_per_second_ = 0;
};

double samples_of(const RenderWork& work) {
    return static_cast<double>(work.region.width()) * work.region.height() * work.sample_count;
}

}  // namespace

Session::Session(std::unique_ptr<Device> device) : device_(std::move(device)) {}

void Session::load(std::shared_ptr<const RenderScene> scene) {
    const std::vector<std::string> missing = device_->unsupported(*scene);
    if (!missing.empty()) {
        std::string message = device_->info().name + " can't draw this scene";
        for (const std::string& sentence : missing) message += "\n  " + sentence;
        throw DeviceError(message);
    }
    device_->load(scene);
    scene_ = std::move(scene);
    thin_items_.reset();
}

RenderResult Session::render(const Frame& frame, std::uint32_t samples, const ProgressSink& progress,
                             const StopFlag& stop, const std::optional<PixelRect>& region) {
    const PixelRect picture = picture_of(frame, region);
    RenderResult result{Film(picture, frame.params.aovs), {}, 0, false};
    const Clock::time_point start = Clock::now();
    const double total = static_cast<double>(picture.width()) * picture.height() * samples;
    double done = 0;
    BandSizer sizer;
    RenderWork work{picture, 0, 0};
    while ((work.sample_count = sampling::pass_size(work.first_sample, samples)) > 0) {
        for (int y = picture.y0; y < picture.y1; y = work.region.y1) {
            if (stop.requested()) result.stopped = true;
            if (result.stopped) break;
            work.region.y0 = y;
            work.region.y1 = std::min(picture.y1, y + sizer.rows(picture.width(), work.sample_count));
            const Clock::time_point band_start = Clock::now();
            const RenderStats stats = device_->render(frame, work, result.film, stop);
            sizer.measured(samples_of(work), seconds_since(band_start));
            result.stats.rays += stats.rays;
            result.stats.shadow_rays += stats.shadow_rays;
            if (!stats.complete) {
                result.stopped = true;
                break;
            }
            done += samples_of(work);
            if (progress) progress({done / total, seconds_since(start), result.stats.rays});
        }
        if (result.stopped) break;
        work.first_sample += work.sample_count;
    }
    result.stats.complete = !result.stopped;
    result.seconds = seconds_since(start);
    return result;
}

RenderResult Session::render_adaptive(const Frame& frame, const AdaptiveSampling& sampling,
                                      const ProgressSink& progress, const StopFlag& stop,
                                      const std::optional<PixelRect>& region) {
    // Until the contrast is known, the first pass counts as half of the work.
    const ProgressSink first_half = [&](const Progress& p) {
        if (progress) progress({p.fraction / 2, p.seconds, p.rays});
    };
    RenderResult result{Film(picture_of(frame, region), frame.params.aovs), {}, 0, false};
    if (sampling.preview > 0) {
        const Clock::time_point first_pass = Clock::now();
        result.stats = refine_into(frame, sampling.preview, sampling.gain, result.film, stop, sampling.preview_method);
        result.stopped = !result.stats.complete;
        result.seconds = seconds_since(first_pass);
    } else {
        result = render(frame, 1, first_half, stop, region);
    }
    if (result.stopped || sampling.samples < 2) return result;
    const Clock::time_point start = Clock::now();
    const double seconds_before = result.seconds;
    const Contrast contrast = contrast_of(result.film, sampling);
    // A grid with a middle keeps the first pass's sample; otherwise all are taken anew.
    Frame further = frame;
    const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(sampling.samples))));
    const bool is_grid = side * side == sampling.samples;
    further.params.sampling.pattern = is_grid ? kernel::SAMPLES_REGULAR : kernel::SAMPLES_SOBOL;
    further.params.sampling.cells = is_grid ? side : 0;
    const std::uint32_t kept = is_grid && side % 2 == 1 ? 1 : 0;
    const std::vector<PixelRect>& regions = contrast.regions;
    const auto marked_in = [&](std::span<const PixelRect> some) {
        std::uint64_t count = 0;
        for (const PixelRect& r : some)
            for (int y = r.y0; y < r.y1; ++y)
                for (int x = r.x0; x < r.x1; ++x) count += contrast.pixels[result.film.index(x, y)];
        return count;
    };
    // Few enough that a stop is answered soon, enough to keep all threads busy.
    constexpr std::size_t kAtOnce = 256;
    for (std::size_t done = 0; done < regions.size() && !result.stopped; done += kAtOnce) {
        const auto some = std::span(regions).subspan(done, std::min(kAtOnce, regions.size() - done));
        const RenderStats stats = device_->render_regions(
            further, some, {{}, kept, sampling.samples - kept, contrast.pixels}, result.film, stop);
        result.stats.rays += stats.rays;
        result.stats.shadow_rays += stats.shadow_rays;
        if (sampling.preview > 0) result.stats.points += marked_in(some) * (sampling.samples - kept);
        result.stopped = !stats.complete;
        result.seconds = seconds_before + seconds_since(start);
        const double refined = static_cast<double>(done + some.size()) / static_cast<double>(regions.size());
        if (progress) progress({0.5 + refined / 2, result.seconds, result.stats.rays});
    }
    result.stats.complete = !result.stopped;
    return result;
}

RenderResult Session::render_recursive(const Frame& frame, const RecursiveSampling& sampling,
                                       const ProgressSink& progress, const StopFlag& stop,
                                       const std::optional<PixelRect>& region) {
    if (device_->can_trace_places(frame)) return render_recursively(*device_, frame, sampling, progress, stop, region);
    const auto side = static_cast<std::uint32_t>(std::clamp(sampling.depth, 0, kMostRecursion)) + 1;
    return render_adaptive(frame, {.threshold = sampling.threshold, .gamma = sampling.gamma, .samples = side * side},
                           progress, stop, region);
}

ErrorDrivenResult Session::render_to_error(const Frame& frame, const ErrorTarget& target, const ProgressSink& progress,
                                           const StopFlag& stop, const std::optional<PixelRect>& region) {
    return sundog::render_to_error(*device_, frame, target, progress, stop, region);
}

RenderStats Session::refine_into(const Frame& frame, float tolerance, float gain, Film& film, const StopFlag& stop,
                                 RefinementMethod method) {
    std::vector<std::uint8_t> finest;
    if (tolerance > 0 && device_->can_refine(frame)) {
        if (!thin_items_) thin_items_ = thin_items(*scene_);
        finest = finest_squares(*thin_items_, frame);
    }
    return device_->refine(frame, {tolerance, gain, finest, method}, film, stop);
}

RenderStats Session::render_into(const Frame& frame, std::uint32_t first_sample, std::uint32_t count, Film& film,
                                 const StopFlag& stop) {
    return device_->render(frame, {film.bounds, first_sample, count}, film, stop);
}

namespace {

/// The cosine between the view axis and the pinhole's ray through the middle of pixel (x, y).
float axis_cosine(const kernel::FrameParams& params, int x, int y) {
    const auto vec = [](const kernel::vec3& v) { return Vec3{v.x, v.y, v.z}; };
    const float across = 2 * (static_cast<float>(x) + 0.5F) / static_cast<float>(params.width) - 1;
    const float up = 1 - 2 * (static_cast<float>(y) + 0.5F) / static_cast<float>(params.height);
    const Vec3 center = vec(params.camera.center);
    const Vec3 through = center + vec(params.camera.right) * across + vec(params.camera.up) * up;
    return dot(center, through) / (length(center) * length(through));
}

}  // namespace

PixelInfo Session::pick(const Frame& frame, int x, int y) {
    Frame all = frame;
    all.params.sampling = {};
    all.params.aovs = kernel::AOV_DEPTH | kernel::AOV_NORMAL | kernel::AOV_OBJECT;
    Film film({x, y, x + 1, y + 1}, all.params.aovs);
    device_->render(all, {film.bounds, 0, 1}, film, StopFlag{});
    return {film.mean(x, y),
            film.depth[0],
            film.normal[0],
            film.object[0],
            film.primitive[0],
            film.material[0],
            film.depth[0] * axis_cosine(frame.params, x, y)};
}

}  // namespace sundog
