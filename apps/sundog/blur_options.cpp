// SPDX-License-Identifier: Apache-2.0
#include "blur_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "arguments.h"
#include "render.h"
#include "scene/deformation.h"
#include "session/blurred_film.h"
#include "session/eye_hits.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

using postprocess::Spread;

const char* name_of(Spread spread) { return spread == Spread::disc ? "disc" : "gaussian"; }

}  // namespace

void BlurArguments::check(const RenderArguments& arguments) const {
    const LightArguments& light = arguments.light;
    if (lens && !light.aperture)
        throw UsageError("--lens-blur says how a lens blurs, and there is none",
                         "add --aperture RADIUS and --focus DISTANCE");
    if (lens && light.blades)
        throw UsageError("--blades shapes what a traced lens blurs", "leave --lens-blur or --blades out");
    if (lens && arguments.shutter_s > 0 && !velocity)
        throw UsageError(fmt::format("--lens-blur {} takes a picture of one moment", name_of(*lens)),
                         "add --shutter-blur velocity");
    if (velocity && !(arguments.shutter_s > 0))
        throw UsageError("--shutter-blur says how an open shutter blurs", "add --shutter SECONDS");
    if (any() && (arguments.pixel || arguments.shown != Shown::picture))
        throw UsageError("--lens-blur and --shutter-blur make pictures: leave --pixel and --show out");
}

void BlurArguments::check_camera(const Frame& frame) const {
    if (!any() || has_pinhole(frame)) return;
    throw UsageError("--lens-blur and --shutter-blur need a perspective camera without a focal blur of its own",
                     "'traced', which is what happens without them, goes with any camera");
}

void add_blur_options(CLI::App& command, BlurArguments& a) {
    using Text = const std::string&;
    command
        .add_option_function<std::string>(
            "--lens-blur",
            [&a](Text text) {
                const std::string name = parse_choice("--lens-blur", text, {"traced", "gaussian", "disc"});
                a.lens.reset();
                if (name != "traced") a.lens = name == "disc" ? Spread::disc : Spread::gaussian;
            },
            "How --aperture blurs: traced (rays through the lens; default), or a sharp picture is blurred by its "
            "depths: gaussian or disc")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--shutter-blur",
            [&a](Text text) {
                a.velocity = parse_choice("--shutter-blur", text, {"traced", "velocity"}) == "velocity";
            },
            "How --shutter blurs: traced (each sample sees another moment; default), or velocity: a picture of the "
            "moment between is blurred along the way of what it shows")
        ->type_name("NAME");
}

ShutterFrames shutter_frames(const RenderArguments& arguments, FrameOptions options, const Stage& stage) {
    const float opens_s = options.time_s;
    const float open_s = arguments.blur.velocity ? arguments.shutter_s : 0;
    const float middle_s = opens_s + open_s / 2;
    std::shared_ptr<const RenderScene> bent;
    if (open_s > 0 && scene::is_deforming(stage.scene) && !stage.scene.settings.freeze_s) {
        scene::Scene scene = stage.scene;
        scene::deform(scene, middle_s);
        bent = compile(scene, {});
        stage.session.load(bent);
    }
    const auto at = [&](float time_s) {
        options.time_s = time_s;
        return make_frame(stage.scene, bent ? *bent : stage.session.scene(), options);
    };
    return {at(opens_s), at(middle_s), at(opens_s + open_s)};
}

std::string blur_picture(const RenderArguments& arguments, const ShutterFrames& frames, const Stage& stage,
                         const StopFlag& stop, RenderResult& result) {
    const auto start = std::chrono::steady_clock::now();
    const auto take = [&](std::optional<Film> film) {
        if (film) result.film = std::move(*film);
        else result.stopped = true;
    };
    Session& session = stage.session;
    if (arguments.blur.lens)
        take(
            blurred_by_lens(session.device(), frames.middle, session.scene(), result.film, *arguments.blur.lens, stop));
    if (arguments.blur.velocity && !result.stopped)
        take(blurred_by_motion(session.device(), frames.opens, frames.middle, frames.closes, session.scene(),
                               result.film, stop));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return fmt::format(", blurred in {:.2f} s", seconds);
}

}  // namespace sundog::app
