// SPDX-License-Identifier: Apache-2.0
#include "viewer/picture_maker.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <utility>

namespace sundog::viewer {
namespace {

constexpr std::uint32_t kFewestSamplesSaved = 4;
constexpr std::uint32_t kFewestSamplesCleaned = 4;
/// Of grid refinement while things move (RefinedWork::tolerance).
constexpr float kMovingTolerance = 0.1F;

bool same(kernel::vec3 a, kernel::vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

bool same(const std::optional<kernel::Camera>& a, const std::optional<kernel::Camera>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return same(a->eye, b->eye) && same(a->center, b->center) && same(a->right, b->right) && same(a->up, b->up);
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

bool same_radiance(const ViewRequest& a, const ViewRequest& b) {
    const FrameOptions& p = a.options;
    const FrameOptions& q = b.options;
    return a.scene == b.scene && a.device == b.device && a.show_rays == b.show_rays && a.denoise == b.denoise &&
           p.width == q.width && p.height == q.height && p.time_s == q.time_s && p.max_depth == q.max_depth &&
           p.min_weight == q.min_weight && p.shadows == q.shadows && p.far_z == q.far_z &&
           p.integrator == q.integrator && p.lens_radius == q.lens_radius && p.focus_distance == q.focus_distance &&
           same(p.camera, q.camera);
}

PictureMaker::PictureMaker(DeviceOpener open_device, double target_frame_s, std::uint32_t max_samples,
                           denoise::Method denoiser)
    : open_device_(std::move(open_device)), max_samples_(max_samples), budget_(target_frame_s), clean_(denoiser) {}

std::optional<DeviceInfo> PictureMaker::set_request(ViewRequest request) {
    if (!same_radiance(request, request_)) film_is_current_ = false;
    request_ = std::move(request);

    const bool other_device = !session_ || request_.device != device_choice_;
    if (!other_device && request_.scene == loaded_) return std::nullopt;
    auto session = other_device ? std::make_unique<Session>(open_device_(request_.device)) : std::move(session_);
    session->load(request_.scene->compiled);
    session_ = std::move(session);
    device_choice_ = request_.device;
    loaded_ = request_.scene;
    budget_.forget();
    faster_way_.forget();
    return session_->device().info();
}

bool PictureMaker::render_quickly(const StopFlag& stop) {
    const PixelSize size = budget_.size_for(full_size());
    const PixelRect bounds{0, 0, size.width, size.height};
    const auto begin = std::chrono::steady_clock::now();
    Frame frame = frame_of(size);
    refinable_ = session_->device().can_refine(frame);
    // To be seen, rays have to be fewer than pixels even where that takes longer.
    const bool refines = refinable_ && (request_.show_rays || faster_way_.refine_next());
    frame.params.aovs = refines ? refined_aovs() : 0;
    if (film_.bounds != bounds || film_.aovs != frame.params.aovs) film_ = Film(bounds, frame.params.aovs);
    film_is_current_ = false;
    clean_.forget();
    film_is_traced_ = !refines;
    last_pass_ = refines ? session_->refine_into(frame, kMovingTolerance, std::exp2(request_.exposure.ev), film_, stop)
                         : session_->render_into(frame, 0, 1, film_, stop);
    if (!last_pass_.complete) return false;
    last_pass_s_ = seconds_since(begin);
    budget_.report(size, last_pass_s_);
    const auto pixels = static_cast<double>(size.pixels());
    if (refines) faster_way_.report_refined(last_pass_s_ / pixels, static_cast<double>(last_pass_.points) / pixels);
    else if (refinable_) faster_way_.report_traced(last_pass_s_ / pixels);
    samples_ = 1;
    film_is_current_ = true;
    if (request_.denoise && holds_full_size()) clean_.add_pass(film_);
    return true;
}

bool PictureMaker::refine(const StopFlag& stop) {
    if (request_.show_rays && refinable_) return show_rays_at_full_size(stop);
    return cleaning_is_due() ? clean(stop) : trace_sample(stop);
}

bool PictureMaker::cleaning_is_due() const {
    if (!request_.denoise || !holds_full_size() || clean_.samples() == samples_) return false;
    // It takes as long as a few samples do: so after 4, 8, 16, … of them, and the last.
    return samples_ >= kFewestSamplesCleaned && (std::has_single_bit(samples_) || samples_ >= most_samples());
}

bool PictureMaker::clean(const StopFlag& stop) {
    return clean_.clean(session_->device(), frame_of(full_size()), film_, samples_, stop);
}

bool PictureMaker::trace_sample(const StopFlag& stop) {
    const auto begin = std::chrono::steady_clock::now();
    const Frame frame = frame_of(full_size());
    if (holds_full_size()) {
        const RenderStats stats = session_->render_into(frame, samples_, 1, film_, stop);
        if (!stats.complete) {
            film_is_current_ = false;  // some pixels have the new sample, others don't
            clean_.forget();
            return false;
        }
        last_pass_ = stats;
        ++samples_;
        if (request_.denoise) clean_.add_pass(film_);
    } else {
        // Beside the reduced picture, which goes on showing if this is stopped.
        Film film(PixelRect{0, 0, full_size().width, full_size().height});
        const RenderStats stats = session_->render_into(frame, 0, 1, film, stop);
        if (!stats.complete) return false;
        last_pass_ = stats;
        film_ = std::move(film);
        samples_ = 1;
        film_is_current_ = film_is_traced_ = true;
        clean_.forget();
        if (request_.denoise) clean_.add_pass(film_);
    }
    last_pass_s_ = seconds_since(begin);
    return true;
}

bool PictureMaker::show_rays_at_full_size(const StopFlag& stop) {
    const auto begin = std::chrono::steady_clock::now();
    Film film(PixelRect{0, 0, full_size().width, full_size().height}, refined_aovs());
    const RenderStats stats = session_->refine_into(frame_of(full_size(), refined_aovs()), kMovingTolerance,
                                                    std::exp2(request_.exposure.ev), film, stop);
    if (!stats.complete) return false;
    last_pass_ = stats;
    last_pass_s_ = seconds_since(begin);
    film_ = std::move(film);
    clean_.forget();
    samples_ = 1;
    film_is_current_ = true;
    film_is_traced_ = false;
    return true;
}

std::uint32_t PictureMaker::most_samples() const {
    // Noise takes more of them to fade than edges to smooth.
    constexpr std::uint32_t kForNoise = 64;
    return request_.options.integrator == kernel::INTEGRATOR_WHITTED ? max_samples_ : max_samples_ * kForNoise;
}

bool PictureMaker::can_refine() const {
    if (!ready()) return false;
    if (request_.show_rays && refinable_) return !holds_rays_at_full_size();
    return !holds_full_size() || samples_ < most_samples() || cleaning_is_due();
}

PixelInfo PictureMaker::pick(int x, int y) { return session_->pick(frame_of(full_size()), x, y); }

std::optional<output::Image> PictureMaker::full_image(const StopFlag& stop) {
    while (!holds_full_size() || samples_ < std::min(kFewestSamplesSaved, max_samples_))
        if (!trace_sample(stop)) return std::nullopt;
    const bool denoise = request_.denoise && samples_ >= kFewestSamplesCleaned;
    if (denoise && clean_.samples() != samples_ && !clean(stop)) return std::nullopt;
    return to_image(denoise ? *clean_.film() : film_, request_.exposure);
}

void PictureMaker::show(Picture& picture) const {
    picture.size = {film_.bounds.width(), film_.bounds.height()};
    picture.argb.resize(film_.radiance.size());
    // While further samples come in, the clean picture of those before is the better one.
    to_display(clean_.film() ? *clean_.film() : film_, request_.exposure, picture.argb);
    if ((film_.aovs & kernel::AOV_COST) != 0) paint_traced(film_, picture.argb);
    picture.time_s = request_.options.time_s;
    picture.samples = samples_;
    picture.seconds = last_pass_s_;
    picture.rays = last_pass_.rays;
}

PixelSize PictureMaker::full_size() const { return {request_.options.width.value(), request_.options.height.value()}; }

Frame PictureMaker::frame_of(PixelSize size, std::uint32_t aovs) const {
    FrameOptions options = request_.options;
    options.width = size.width;
    options.height = size.height;
    options.aovs = aovs;
    return make_frame(loaded_->scene, *loaded_->compiled, options);
}

bool PictureMaker::fills_the_window() const {
    return film_is_current_ && PixelSize{film_.bounds.width(), film_.bounds.height()} == full_size();
}

bool PictureMaker::holds_full_size() const { return fills_the_window() && film_is_traced_; }

bool PictureMaker::holds_rays_at_full_size() const {
    return fills_the_window() && (film_.aovs & kernel::AOV_COST) != 0;
}

}  // namespace sundog::viewer
