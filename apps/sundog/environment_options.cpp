// SPDX-License-Identifier: Apache-2.0
#include "environment_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <vector>

#include "arguments.h"
#include "output/image.h"
#include "scene/files.h"
#include "scene/sun_sky.h"
#include "usage_error.h"

namespace sundog::app {

SkyArguments parse_sky(const std::string& text) {
    SkyArguments sky;
    if (text.empty()) return sky;
    struct Number {
        float SkyArguments::*value;
        float least, most;
    };
    const std::array<Number, 3> numbers{{{&SkyArguments::elevation_deg, 0, 90},
                                         {&SkyArguments::azimuth_deg, -360, 360},
                                         {&SkyArguments::turbidity, scene::kLeastTurbidity, scene::kMostTurbidity}}};
    std::string_view rest = text;
    for (const Number& number : numbers) {
        const std::size_t comma = rest.find(',');
        try {
            sky.*number.value = parse_float("--sky", rest.substr(0, comma), number.least, number.most);
        } catch (const UsageError& error) {
            throw UsageError(error.what(),
                             "the sun's elevation, azimuth and the air's turbidity in this order: for example "
                             "--sky 30,225,3; the scene goes before --sky");
        }
        if (comma == std::string_view::npos) return sky;
        rest.remove_prefix(comma + 1);
    }
    throw UsageError(fmt::format("--sky '{}': expected three numbers at most", text), "for example --sky 30,225,3");
}

void EnvironmentArguments::check() const {
    if (file && sky)
        throw UsageError("--environment and --sky are both what lies around the scene", "leave one of them out");
    if ((turn_deg || gain) && !file)
        throw UsageError("--environment-turn and --environment-gain are for the picture of --environment",
                         "for example --environment studio.exr");
}

void EnvironmentArguments::apply(scene::Scene& scene) const {
    if (sky) scene::put_under_sky(sky->azimuth_deg, sky->elevation_deg, sky->turbidity, scene);
    if (!file) return;
    output::Image image = output::read_image(*file);
    scene::Environment environment;
    environment.name = *file;
    environment.width = static_cast<std::uint32_t>(image.width);
    environment.height = static_cast<std::uint32_t>(image.height);
    environment.radiance = std::move(image.pixels);
    environment.gain = gain.value_or(environment.gain);
    scene::hang(std::move(environment), turn_deg.value_or(0.0F), scene);
    scene::add_file(scene, *file);
}

void add_environment_options(CLI::App& command, EnvironmentArguments& a) {
    using Text = const std::string&;
    command
        .add_option_function<std::string>(
            "--environment", [&a](Text text) { a.file = text; },
            "A picture of all directions that lights the scene from around: .exr, .hdr or any other, twice as wide as "
            "high")
        ->type_name("FILE");
    command
        .add_option_function<std::string>(
            "--environment-turn", [&a](Text text) { a.turn_deg = parse_float("--environment-turn", text, -360, 360); },
            "Turn it counter-clockwise, seen from above (0)")
        ->type_name("DEG");
    command
        .add_option_function<std::string>(
            "--environment-gain", [&a](Text text) { a.gain = parse_float("--environment-gain", text, 0, 1e6F); },
            "Multiply its light (1)")
        ->type_name("G");
    command
        .add_option_function<std::vector<std::string>>(
            "--sky", [&a](const std::vector<std::string>& words) { a.sky = parse_sky(words.empty() ? "" : words[0]); },
            "A clear sky around the scene and a sun in place of its own: the sun's elevation (40) and azimuth (225, "
            "clockwise from where the environment's middle is), and how hazy the air is (3; 1.7 to 10)")
        ->expected(0, 1)
        ->type_name("[ELEVATION[,AZIMUTH[,TURBIDITY]]]");
}

}  // namespace sundog::app
