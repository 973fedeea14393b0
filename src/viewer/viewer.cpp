// SPDX-License-Identifier: Apache-2.0
#include "viewer/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <utility>

#include "device/choose/choose.h"
#include "viewer/input.h"
#include "viewer/panels.h"
#include "viewer/rate_meter.h"
#include "viewer/render_thread.h"
#include "viewer/replay.h"
#include "viewer/scene_reloader.h"
#include "viewer/window.h"

namespace sundog::viewer {
namespace {

constexpr float kFont_px = 16;
constexpr float kTimeStep_s = 1.0F / 25;
constexpr double kNoteShown_s = 3;
constexpr int kIdleWait_ms = 50;  // how often an idle window looks at its files and its future scene

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The limits and size that the scene itself asks for.
kernel::FrameParams scene_defaults(const LoadedScene& loaded) {
    return make_frame(loaded.scene, *loaded.compiled, FrameOptions{}).params;
}

PixelSize first_window_size(const ViewOptions& options, const LoadedScene& loaded) {
    const kernel::FrameParams scene = scene_defaults(loaded);
    return {options.width.value_or(static_cast<int>(scene.width)),
            options.height.value_or(static_cast<int>(scene.height))};
}

/// What the window is called after: the scene's file, or the scene that a raytracer.conf names.
std::string shown_name(const ViewOptions& options, const LoadedScene& loaded) {
    return options.scene_file.extension() == ".conf" ? loaded.scene.name : options.scene_file.filename().string();
}

/// The device opened at the start is handed out first; those chosen in the window later are opened then.
DeviceOpener device_opener(std::unique_ptr<Device> first, const ViewOptions& how) {
    auto waiting = std::make_shared<std::unique_ptr<Device>>(std::move(first));
    return [waiting, threads = how.threads, acceleration = how.acceleration](const std::string& choice) {
        return *waiting ? std::move(*waiting) : open_device(choice, threads, acceleration);
    };
}

std::vector<DeviceChoice> device_choices() {
    std::vector<DeviceChoice> choices;
    for (const DeviceListing& listing : list_devices()) {
        // open_device() goes by the kind, so one line for each kind is all that can be chosen.
        const bool usable = listing.why_unusable.empty();
        const auto same_kind = std::find_if(choices.begin(), choices.end(),
                                            [&](const DeviceChoice& c) { return c.choice == listing.info.kind; });
        if (same_kind == choices.end()) {
            choices.push_back({listing.info.kind, listing.info.name, listing.why_unusable});
        } else if (usable && !same_kind->why_unusable.empty()) {
            *same_kind = {listing.info.kind, listing.info.name, {}};
        }
    }
    return choices;
}

/// The window with all that belongs to it; each step() is one turn of its loop.
class Viewer {
public:
    Viewer(const ViewOptions& options, std::shared_ptr<const LoadedScene> scene, std::unique_ptr<Device> device);
    /// False once the user has quit.
    bool step();

private:
    void apply(const Input& input, double passed_s);
    void pick_at(Vec2 window_position);
    void use_scene(std::shared_ptr<const LoadedScene> scene);
    void submit();
    bool take_results();
    void take(const SceneReady& ready);
    void take(const RenderFailed& failure);
    void take(const PixelSeen& seen);
    void take(const PictureSaved& saved);
    void take(const SaveFailed& failure);
    void note(std::string words);
    void update_status();
    void draw();
    [[nodiscard]] int wait_ms() const;
    /// The scene as it is at a moment.
    std::shared_ptr<const LoadedScene> scene_at(float time_s);
    [[nodiscard]] bool plays() const { return scene_->animated && playback_.playing(); }

    ViewOptions options_;
    std::shared_ptr<const LoadedScene> scene_;
    std::shared_ptr<const LoadedScene> bent_;  ///< scene_ with its meshes bent, as of bent_time_s_.
    float bent_time_s_ = 0;
    Window window_;
    ImguiRenderer imgui_;
    InputReader reader_;
    CameraControl camera_;
    Playback playback_;
    Controls controls_;
    Status status_;
    SceneReloader reloader_;
    RateMeter rate_;
    Picture picture_;
    std::string device_in_use_, device_error_;
    std::future<std::vector<DeviceChoice>> devices_;
    double step_began_s_, next_submit_s_ = 0, next_draw_s_ = 0, note_ends_s_ = 0;
    bool flying_ = false;
    int draws_due_ = 3;      // ImGui needs a second and third drawing to settle sizes and hovers
    RenderThread renderer_;  // last: it stops before what it wakes goes
};

RenderThreadOptions render_options(std::unique_ptr<Device> device, const ViewOptions& how, double refresh_hz) {
    const Uint32 wake_event = SDL_RegisterEvents(1);
    RenderThreadOptions options;
    options.target_frame_s = 1 / refresh_hz;
    options.open_device = device_opener(std::move(device), how);
    options.wake = [wake_event] {
        SDL_Event event{};
        event.type = wake_event;
        SDL_PushEvent(&event);
    };
    return options;
}

Viewer::Viewer(const ViewOptions& options, std::shared_ptr<const LoadedScene> scene, std::unique_ptr<Device> device)
    : options_(options),
      scene_(std::move(scene)),
      window_(shown_name(options, *scene_) + " - Sundog", first_window_size(options, *scene_),
              options.fullscreen || scene_->scene.settings.fullscreen.value_or(false)),
      imgui_(window_.sdl_window(), window_.sdl_renderer(), kFont_px),
      reloader_(options.scene_file, scene_, options.change, options.choices),
      device_in_use_(device->info().kind),
      devices_(std::async(std::launch::async, device_choices)),
      step_began_s_(seconds_now()),
      renderer_(render_options(std::move(device), options, std::clamp(window_.refresh_hz(), 30.0, 60.0))) {
    set_style(kFont_px);
    controls_.device = device_in_use_;
    controls_.max_depth = options.max_depth;
    status_.scene_name = shown_name(options, *scene_);
    use_scene(scene_);
}

bool Viewer::step() {
    const Input input = reader_.read(wait_ms());
    if (input.quit) return false;
    const double now_s = seconds_now();
    const double passed_s = now_s - std::exchange(step_began_s_, now_s);
    if (scene_->animated) playback_.advance(passed_s);
    apply(input, passed_s);

    if (auto changed = reloader_.poll()) use_scene(std::move(changed));
    submit();
    const bool new_picture = take_results();
    update_status();
    if (input.any) draws_due_ = 3;
    // Without a new picture, the panels alone needn't be drawn more often than the screen shows them.
    if (new_picture || (draws_due_ > 0 && now_s >= next_draw_s_)) draw();
    return true;
}

int Viewer::wait_ms() const {
    const bool busy = draws_due_ > 0 || plays() || flying_;
    if (!busy) return kIdleWait_ms;
    const double left_s = next_submit_s_ - seconds_now();
    return std::clamp(static_cast<int>(std::ceil(left_s * 1000)), 0, kIdleWait_ms);
}

void Viewer::apply(const Input& input, double passed_s) {
    if (input.toggle_play) playback_.toggle();
    if (input.steps_in_time != 0) {
        playback_.set_playing(false);
        playback_.scrub(playback_.time_s() + static_cast<float>(input.steps_in_time) * kTimeStep_s);
    }
    controls_.show_help ^= input.toggle_help;
    controls_.show_panels ^= input.toggle_panels;
    controls_.show_rays ^= input.toggle_rays;
    if (input.toggle_light)
        controls_.integrator =
            controls_.integrator == kernel::INTEGRATOR_PATH ? kernel::INTEGRATOR_WHITTED : kernel::INTEGRATOR_PATH;
    if (input.toggle_fullscreen) window_.toggle_fullscreen();
    if (input.go_home) camera_.go_home();

    const auto height = static_cast<float>(window_.size().height);
    const auto moved = [](const MouseMove& move) { return move.dx_px != 0 || move.dy_px != 0; };
    if (moved(input.orbit)) camera_.orbit(input.orbit, height);
    if (moved(input.look)) camera_.look(input.look, height);
    if (moved(input.pan)) camera_.pan(input.pan, height);
    if (input.zoom != 0) camera_.zoom(input.zoom);
    flying_ = input.fly != FlyDirection{};
    if (flying_) camera_.fly(input.fly, static_cast<float>(std::min(passed_s, 0.1)) * input.fly_speed);

    if (input.pick_at) pick_at(*input.pick_at);
    if (input.save) renderer_.save(std::filesystem::current_path(), options_.scene_file.stem().string());
}

void Viewer::pick_at(Vec2 window_position) {
    const PixelSize window = window_.size();
    const PixelSize full = window_.size_px();
    const auto pixel = [](float position, int window_length, int pixels) {
        const float scaled = position * static_cast<float>(pixels) / static_cast<float>(window_length);
        return std::clamp(static_cast<int>(scaled), 0, pixels - 1);
    };
    renderer_.pick(pixel(window_position.x, window.width, full.width),
                   pixel(window_position.y, window.height, full.height));
}

void Viewer::use_scene(std::shared_ptr<const LoadedScene> scene) {
    scene_ = std::move(scene);
    bent_.reset();
    camera_.set_bounds(scene_->compiled->bounds);
    const Bounds3& bounds = scene_->compiled->bounds;
    const float across = bounds.empty() ? 1.0F : length(bounds.upper - bounds.lower);
    status_.scene_size = across > 0 && std::isfinite(across) ? across : 1.0F;
    if (scene_->scene.projection_camera) camera_.set_up(to_float(scene_->scene.projection_camera->sky));
    else camera_.set_up({0, 0, 1});
    const kernel::FrameParams defaults = scene_defaults(*scene_);
    status_.scene_max_depth = static_cast<int>(defaults.max_depth);
    status_.scene_shadows = (defaults.features & kernel::FEATURE_SHADOWS) != 0;
    draws_due_ = 3;
}

std::shared_ptr<const LoadedScene> Viewer::scene_at(float time_s) {
    if (!scene_->deforming) return scene_;
    if (!bent_ || bent_time_s_ != time_s) {
        bent_ = bent_at(*scene_, time_s);
        bent_time_s_ = time_s;
    }
    return bent_;
}

void Viewer::submit() {
    const double now_s = seconds_now();
    if (now_s < next_submit_s_) return;
    next_submit_s_ = now_s + 1 / window_.refresh_hz();

    const PixelSize size = window_.size_px();
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    const float time_s = scene_->scene.settings.freeze_s.value_or(playback_.time_s());
    ViewRequest request{scene_at(time_s),   controls_.device,  {},
                        controls_.exposure, controls_.denoise, controls_.show_rays};
    FrameOptions& frame = request.options;
    frame.width = size.width;
    frame.height = size.height;
    frame.time_s = time_s;
    frame.max_depth = controls_.max_depth;
    frame.min_weight = options_.min_weight;
    frame.shadows = controls_.shadows;
    frame.integrator = controls_.integrator;
    frame.lens_radius = controls_.lens_radius;
    frame.focus_distance = controls_.focus_distance > 0 ? controls_.focus_distance : status_.scene_size;
    frame.radiosity = false;  // Gathering it takes far longer than a frame may.
    if (const auto& own = scene_->scene.projection_camera) {
        using Kind = scene::ProjectionCamera::Kind;
        camera_.follow(camera_at(scene::placed_at(*own, frame.time_s), aspect), own->kind == Kind::orthographic);
        // Until the user takes over, other kinds than a pinhole are the scene's business.
        if (camera_.is_free() || own->kind == Kind::perspective) frame.camera = camera_.camera(aspect);
    } else {
        camera_.follow(camera_at(scene_->scene.camera, frame.time_s, aspect));
        frame.camera = camera_.camera(aspect);
    }
    renderer_.submit(std::move(request));
}

bool Viewer::take_results() {
    for (const RenderEvent& event : renderer_.take_events()) {
        std::visit([this](const auto& what) { take(what); }, event);
        draws_due_ = 3;
    }
    const bool new_picture = renderer_.take_picture(picture_);
    if (new_picture) {
        window_.set_picture(picture_);
        rate_.add(step_began_s_, picture_.rays, picture_.seconds);
    }
    if (devices_.valid() && devices_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        status_.devices = devices_.get();
    }
    return new_picture;
}

void Viewer::take(const SceneReady& ready) {
    device_in_use_ = controls_.device = ready.device.kind;
    status_.device_name = ready.device.name;
    device_error_.clear();
    status_.warnings.clear();
    for (const Diagnostic& warning : ready.scene->warnings) status_.warnings.push_back(format(warning));
}

void Viewer::take(const RenderFailed& failure) {
    device_error_ = failure.message;
    controls_.device = device_in_use_;
}

void Viewer::take(const PixelSeen& seen) {
    status_.picked = describe_pixel(*seen.request.scene, seen.info, seen.x, seen.y);
    status_.picked->replay =
        replay_command(options_.scene_file, seen.request.device, seen.request.options, seen.x, seen.y);
}

void Viewer::take(const PictureSaved& saved) { note("Saved " + saved.file.filename().string()); }

void Viewer::take(const SaveFailed& failure) { note(failure.message); }

void Viewer::note(std::string words) {
    status_.note = std::move(words);
    note_ends_s_ = seconds_now() + kNoteShown_s;
}

void Viewer::update_status() {
    const double now_s = seconds_now();
    status_.size = picture_.size;
    status_.full_size = window_.size_px();
    status_.samples = picture_.samples;
    status_.pictures_per_s = picture_.samples == 1 ? rate_.pictures_per_s(now_s) : 0;
    status_.rays_per_s = rate_.rays_per_s();
    status_.own_camera = !camera_.is_free();
    status_.animated = scene_->animated;
    status_.error = reloader_.error().empty() ? device_error_ : reloader_.error();
    if (status_.loading != reloader_.loading()) {
        status_.loading = reloader_.loading();
        draws_due_ = 3;
    }
    if (controls_.copied) {
        controls_.copied = false;
        note("Copied");
    }
    if (!status_.note.empty() && now_s > note_ends_s_) {
        status_.note.clear();
        draws_due_ = 3;
    }
}

void Viewer::draw() {
    draws_due_ = std::max(draws_due_ - 1, 0);
    next_draw_s_ = seconds_now() + 1 / window_.refresh_hz();
    window_.draw_picture();
    imgui_.begin();
    draw_panels(status_, controls_, playback_);
    imgui_.end();
    window_.present();
}

}  // namespace

void run(const ViewOptions& options, const WarningSink& warn) {
    auto device = open_device(options.device, options.threads, options.acceleration);
    auto scene = load_scene(options.scene_file, options.change, options.choices);
    if (warn) {
        for (const Diagnostic& warning : scene->warnings) warn(warning);
    }
    Viewer viewer(options, std::move(scene), std::move(device));
    while (viewer.step()) continue;
}

}  // namespace sundog::viewer
