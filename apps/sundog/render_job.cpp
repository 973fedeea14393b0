// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>

#include "console.h"
#include "exit_status.h"
#include "noise.h"
#include "output/progress_line.h"
#include "output/video.h"
#include "picture.h"
#include "render.h"
#include "scene/deformation.h"
#include "session/blocks.h"
#include "shutter.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

void write_picture(const OutputPlan& plan, const std::filesystem::path& file, const output::Image& image,
                   const std::vector<output::Layer>& layers) {
    if (plan.target == Target::standard_output)
        output::write_file_atomically("-", output::encode(image, plan.format, layers));
    else output::write_image(file, image, layers);
}

std::string name_of(const OutputPlan& plan) {
    return plan.target == Target::standard_output ? "standard output" : plan.file.string();
}

/// Where `count` frames from `first` on went: the video, or the first and the last numbered image.
std::string name_of_frames(const OutputPlan& plan, int first, int count) {
    if (plan.target != Target::numbered_images || count == 0) return name_of(plan);
    const std::string name = numbered_file(plan.file, first).string();
    return count == 1 ? name : fmt::format("{} ... {}", name, numbered_file(plan.file, first + count - 1).string());
}

/// "640x480, 4 samples a pixel, 0.21 s, 35.1 million rays/s on NAME"
std::string summary(const RenderResult& result, const std::string& samples, const DeviceInfo& device) {
    const double rays_per_second = static_cast<double>(result.stats.rays) / std::max(result.seconds, 1e-9);
    return fmt::format("{}x{}, {}, {:.2f} s, {:.1f} million rays/s on {}", result.film.bounds.width(),
                       result.film.bounds.height(), samples, result.seconds, rays_per_second / 1e6, device.name);
}

/// Share of the wanted samples that a film of the same number for all pixels has.
double done_fraction(const Film& film, int samples) {
    double sum = 0;
    for (const auto& pixel : film.radiance) sum += pixel[3];
    return sum / (static_cast<double>(film.radiance.size()) * samples);
}

/// The picture as it is to be shown, or, in a file that holds radiance, to be kept.
output::Image shown_image(const Film& film, const RenderArguments& arguments) {
    output::Image image = output::tone_mapped(image_of(film, arguments.exposure_ev), arguments.tone.mapping());
    if (arguments.shown == Shown::rays) paint_traced(film, image);
    return image;
}

/// Writes a video's or numbered images' frames in order.
class FrameWriter {
public:
    FrameWriter(const OutputPlan& plan, Size size, double frames_per_second) : plan_(plan) {
        if (plan.target == Target::video) video_.emplace(plan.file, size.width, size.height, frames_per_second);
    }
    void add(int number, const Film& film, const RenderArguments& arguments) {
        const output::Image image = shown_image(film, arguments);
        if (video_) video_->add(image);
        else write_picture(plan_, numbered_file(plan_.file, number), image, layers_of(film, arguments.aovs));
        ++written_;
    }
    /// Ends the file; a video without frames leaves what was there.
    void finish() {
        if (video_ && written_ > 0) video_->finish();
    }
    [[nodiscard]] int written() const { return written_; }

private:
    const OutputPlan& plan_;
    std::optional<output::VideoWriter> video_;
    int written_ = 0;
};

/// A picture, made the way that was asked for, and what is to be said of its samples.
struct PictureAndSummary {
    RenderResult result;
    std::string samples;
};

/// "4 samples a pixel", "2.3 samples a pixel"
std::string samples_of(const RenderResult& result) {
    const double mean = samples_taken(result) / static_cast<double>(result.film.radiance.size());
    const std::string number = fmt::format("{:.3g}", mean);
    return number + (number == "1" ? " sample a pixel" : " samples a pixel");
}

/// "37.2 samples a pixel, error at most 0.0099"
std::string samples_of(const ErrorDrivenResult& result, const ErrorTarget& target) {
    std::string text = fmt::format("{:.3g} samples a pixel", result.mean_samples);
    if (result.largest_error > 0) text += fmt::format(", largest error {:.2g}", result.largest_error);
    if (target.error > 0) text += fmt::format(", {:.4g} % of pixels within {:g}", 100 * result.met, target.error);
    return text;
}

PictureAndSummary picture_of(const Frame& frame, const RenderArguments& arguments, Session& session,
                             const ProgressSink& progress, const StopFlag& stop) {
    using Way = SamplingArguments::Way;
    const SamplingArguments& sampling = arguments.sampling;
    const float gain = std::exp2(arguments.exposure_ev);
    if (sampling.way() == Way::to_error) {
        const ErrorTarget target = sampling.error_target(gain);
        ErrorDrivenResult result = session.render_to_error(frame, target, progress, stop);
        std::string samples = samples_of(result, target);
        return {std::move(result), std::move(samples)};
    }
    PictureAndSummary picture{{Film(PixelRect{}), {}, 0, false}, {}};
    RenderResult& result = picture.result;
    switch (sampling.way()) {
        case Way::preview: {
            const auto start = std::chrono::steady_clock::now();
            result.film = Film({0, 0, static_cast<int>(frame.params.width), static_cast<int>(frame.params.height)},
                               frame.params.aovs);
            result.stats = session.refine_into(frame, *sampling.preview, gain, result.film, stop,
                                               sampling.preview_method.value_or(RefinementMethod::grid));
            result.stopped = !result.stats.complete;
            result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            break;
        }
        case Way::adaptive:
            result = session.render_adaptive(frame, sampling.adaptive_sampling(gain), progress, stop);
            break;
        case Way::recursive:
            result = session.render_recursive(frame, sampling.recursive_sampling(), progress, stop);
            break;
        default: {
            const auto samples = static_cast<std::uint32_t>(sampling.most_samples());
            result = arguments.denoise ? render_in_blocks(session.device(), frame, samples, progress, stop)
                                       : session.render(frame, samples, progress, stop);
            break;
        }
    }
    picture.samples = samples_of(result);
    return picture;
}

/// picture_of(), without its noise where that was asked for.
PictureAndSummary clean_picture_of(const Frame& frame, const RenderArguments& arguments, const Stage& stage,
                                   const ProgressSink& progress, const StopFlag& stop) {
    PictureAndSummary picture = picture_of(frame, arguments, stage.session, progress, stop);
    // Where it was interrupted, some pixels have too few samples to tell their noise.
    if (!stage.denoiser || picture.result.stopped) return picture;
    picture.samples += ", " + remove_noise(*stage.denoiser, stage.session.device(), frame, stop, picture.result);
    return picture;
}

/// The picture that was asked for: of one moment or of an open shutter.
PictureAndSummary shot_of(const Frame& frame, const FrameOptions& options, const RenderArguments& arguments,
                          const Stage& stage, const ProgressSink& progress, const StopFlag& stop) {
    if (arguments.blur.any()) {
        const ShutterFrames frames = shutter_frames(arguments, options, stage);
        Frame sharp = frames.middle;
        if (arguments.blur.lens) sharp.params.lens_radius = 0;
        PictureAndSummary picture = clean_picture_of(sharp, arguments, stage, progress, stop);
        if (!picture.result.stopped) picture.samples += blur_picture(arguments, frames, stage, stop, picture.result);
        return picture;
    }
    if (!(arguments.shutter_s > 0)) return clean_picture_of(frame, arguments, stage, progress, stop);
    PictureAndSummary picture{render_open_shutter(arguments, options, stage, progress, stop), {}};
    picture.samples = samples_of(picture.result);
    return picture;
}

}  // namespace

int render_image(const RenderArguments& arguments, const OutputPlan& plan, const Stage& stage) {
    const Frame frame = make_frame(stage.scene, stage.compiled, arguments.frame);
    const InterruptGuard interrupt;
    output::ProgressLine line(std::cerr, !arguments.quiet && isatty(STDERR_FILENO) == 1);
    const auto [result, samples] = shot_of(frame, arguments.frame, arguments, stage, std::ref(line), interrupt.flag());
    line.clear();
    write_picture(plan, plan.file, shown_image(result.film, arguments), layers_of(result.film, arguments.aovs));
    if (result.stopped) {
        const SamplingArguments& sampling = arguments.sampling;
        const std::string done =
            sampling.way() == SamplingArguments::Way::fixed
                ? fmt::format("{:.0f} %", 100 * done_fraction(result.film, sampling.most_samples()))
                : samples;
        print_note(fmt::format("interrupted: wrote what was done ({}) to {}", done, name_of(plan)));
        return kInterrupted;
    }
    if (!arguments.quiet)
        print_note(
            fmt::format("wrote {} ({})", name_of(plan), summary(result, samples, stage.session.device().info())));
    return 0;
}

int render_frames(const RenderArguments& arguments, const OutputPlan& plan, const Stage& stage) {
    const FrameRange range = *arguments.frames;
    const int count = range.last - range.first + 1;
    FrameOptions options = arguments.frame;
    const Frame first = make_frame(stage.scene, stage.compiled, options);
    const scene::Compass compass = scene::compass_of(stage.scene);
    const Vec3 pivot = stage.compiled.bounds.empty() ? Vec3{} : stage.compiled.bounds.center();
    FrameWriter writer(plan, {static_cast<int>(first.params.width), static_cast<int>(first.params.height)},
                       arguments.frames_per_second);
    const InterruptGuard interrupt;
    output::ProgressLine line(std::cerr, !arguments.quiet && isatty(STDERR_FILENO) == 1);
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    // Meshes that are bent over time are made anew for each frame, and all else with them.
    std::optional<scene::Scene> bent;
    if (scene::is_deforming(stage.scene) && !stage.scene.settings.freeze_s) bent = stage.scene;
    std::shared_ptr<const RenderScene> bent_compiled;
    std::uint64_t rays = 0;
    bool stopped = false;
    for (int number = range.first; number <= range.last && !stopped; ++number) {
        if (arguments.turntable) {
            const float angle_deg = 360 * static_cast<float>(number) / static_cast<float>(count);
            options.camera = turned(first.params.camera, compass, pivot, angle_deg);
        } else {
            options.time_s = arguments.time_s + static_cast<float>(number) / arguments.frames_per_second;
        }
        if (bent) {
            scene::deform(*bent, options.time_s);
            bent_compiled = compile(*bent, {});
            stage.session.load(bent_compiled);
        }
        const Frame frame = make_frame(stage.scene, bent ? *bent_compiled : stage.compiled, options);
        const auto report = [&](const Progress& p) {
            line({(number - range.first + p.fraction) / count, seconds(), rays + p.rays});
        };
        const RenderResult result = shot_of(frame, options, arguments, stage, report, interrupt.flag()).result;
        rays += result.stats.rays;
        stopped = result.stopped;
        if (!stopped) writer.add(number, result.film, arguments);
    }
    writer.finish();
    line.clear();
    if (stopped) {
        print_note(fmt::format("interrupted: wrote {} of {} frames to {}", writer.written(), count,
                               name_of_frames(plan, range.first, writer.written())));
        return kInterrupted;
    }
    if (!arguments.quiet)
        print_note(fmt::format("wrote {} frame{} to {} ({}{:.1f} s, {:.1f} frames/s on {})", count,
                               count == 1 ? "" : "s", name_of_frames(plan, range.first, count),
                               stage.denoiser ? "denoised by " + stage.denoiser->name() + ", " : "", seconds(),
                               count / std::max(seconds(), 1e-9), stage.session.device().info().name));
    return 0;
}

int print_pixel(const RenderArguments& arguments, const Stage& stage) {
    const Frame frame = make_frame(stage.scene, stage.compiled, arguments.frame);
    const Pixel pixel = *arguments.pixel;
    const auto width = static_cast<int>(frame.params.width);
    const auto height = static_cast<int>(frame.params.height);
    if (pixel.x >= width || pixel.y >= height)
        throw UsageError(
            fmt::format("--pixel {},{} lies outside the picture of {}x{}", pixel.x, pixel.y, width, height));
    const PixelInfo seen = stage.session.pick(frame, pixel.x, pixel.y);
    fmt::print("pixel     {},{} of {}x{}\n", pixel.x, pixel.y, width, height);
    fmt::print("radiance  {} {} {} (linear RGB)\n", seen.radiance.x, seen.radiance.y, seen.radiance.z);
    if (seen.geometry == kernel::NONE) {
        fmt::print("sees      nothing\n");
        return 0;
    }
    const scene::Object& object = stage.scene.objects[stage.compiled.geometry_objects[seen.geometry]];
    fmt::print("depth     {}\n", seen.depth);
    fmt::print("normal    {} {} {}\n", seen.normal.x, seen.normal.y, seen.normal.z);
    fmt::print("object    {} (primitive {})", object.name, seen.primitive);
    if (object.where.file) fmt::print(" from {}:{}", *object.where.file, object.where.line);
    const scene::Material& material = stage.scene.materials[seen.material];
    fmt::print("\nmaterial  {}", material.name);
    if (material.where.file) fmt::print(" from {}:{}", *material.where.file, material.where.line);
    fmt::print("\n");
    return 0;
}

}  // namespace sundog::app
