// SPDX-License-Identifier: Apache-2.0
#include "light_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "session/session.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr float kFarthest = 1e6F;
constexpr float kSmallest = 1e-4F;
constexpr int kMostBlades = 64;
constexpr int kMostSeed = 1'000'000'000;

}  // namespace

void LightArguments::check() const {
    if (integrator == kernel::INTEGRATOR_WHITTED && (seed || clamp))
        throw UsageError("--seed and --clamp are for paths", "add --integrator path");
    if (integrator != kernel::INTEGRATOR_OCCLUSION && occlusion_distance)
        throw UsageError("--occlusion-distance is for ambient occlusion", "add --integrator occlusion");
    if (focus && focus_pixel) throw UsageError("--focus and --focus-pixel say the same thing: leave one of them out");
    if (aperture && !focus && !focus_pixel)
        throw UsageError("--aperture blurs what is not in focus: nothing says what is",
                         "add --focus DISTANCE or --focus-pixel X,Y");
    if (!aperture && (focus || focus_pixel || blades))
        throw UsageError("--focus, --focus-pixel and --blades are for a lens", "add --aperture RADIUS");
}

void LightArguments::apply(FrameOptions& frame) const {
    frame.integrator = integrator;
    frame.seed = static_cast<std::uint32_t>(seed.value_or(0));
    frame.most_radiance = clamp.value_or(0);
    frame.occlusion_distance = occlusion_distance.value_or(0);
    frame.lens_radius = aperture.value_or(0);
    frame.focus_distance = focus.value_or(1);
    frame.lens_blades = static_cast<std::uint32_t>(blades.value_or(0));
}

std::optional<float> LightArguments::pick_focus(const Frame& frame, Session& session) const {
    if (!focus_pixel) return std::nullopt;
    const auto width = static_cast<int>(frame.params.width), height = static_cast<int>(frame.params.height);
    if (focus_pixel->x >= width || focus_pixel->y >= height)
        throw UsageError(fmt::format("--focus-pixel {},{} lies outside the picture of {}x{}", focus_pixel->x,
                                     focus_pixel->y, width, height));
    Frame sharp = frame;
    sharp.params.lens_radius = 0;
    const PixelInfo seen = session.pick(sharp, focus_pixel->x, focus_pixel->y);
    if (seen.geometry == kernel::NONE)
        throw UsageError(fmt::format("--focus-pixel {},{} sees nothing", focus_pixel->x, focus_pixel->y),
                         "pick a pixel that shows what is to be sharp");
    return seen.axis_depth;
}

void add_light_options(CLI::App& command, LightArguments& a) {
    using Text = const std::string&;
    command
        .add_option_function<std::string>(
            "--integrator",
            [&a](Text text) {
                const std::string name = parse_choice("--integrator", text, {"whitted", "path", "occlusion"});
                a.integrator = name == "path"        ? kernel::INTEGRATOR_PATH
                               : name == "occlusion" ? kernel::INTEGRATOR_OCCLUSION
                                                     : kernel::INTEGRATOR_WHITTED;
            },
            "whitted (mirrors, glass, sharp shadows; default), path (all light there is, with noise that fades) or "
            "occlusion (how open each place is)")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--seed", [&a](Text text) { a.seed = parse_int("--seed", text, 0, kMostSeed); },
            "Another number, another noise, for paths (0)")
        ->type_name("N");
    command
        .add_option_function<std::string>(
            "--clamp", [&a](Text text) { a.clamp = parse_float("--clamp", text, kSmallest, kFarthest); },
            "No path brings more radiance than this: fewer bright dots, and some light is lost")
        ->type_name("L");
    command
        .add_option_function<std::string>(
            "--occlusion-distance",
            [&a](Text text) { a.occlusion_distance = parse_float("--occlusion-distance", text, kSmallest, kFarthest); },
            "How far ambient occlusion looks (half the scene's size)")
        ->type_name("D");
    command
        .add_option_function<std::string>(
            "--aperture", [&a](Text text) { a.aperture = parse_float("--aperture", text, kSmallest, kFarthest); },
            "Radius of a lens, in the scene's units: what is out of focus is blurred")
        ->type_name("R");
    command
        .add_option_function<std::string>(
            "--focus", [&a](Text text) { a.focus = parse_float("--focus", text, kSmallest, kFarthest); },
            "Distance to what is sharp, along the view axis")
        ->type_name("D");
    command
        .add_option_function<std::string>(
            "--focus-pixel", [&a](Text text) { a.focus_pixel = parse_pixel(text, "--focus-pixel"); },
            "What this pixel sees is sharp")
        ->type_name("X,Y");
    command
        .add_option_function<std::string>(
            "--blades", [&a](Text text) { a.blades = parse_int("--blades", text, 3, kMostBlades); },
            "Sides of the lens's opening (else it is round)")
        ->type_name("N");
}

}  // namespace sundog::app
