// SPDX-License-Identifier: Apache-2.0
#include "indirect_options.h"

#include <CLI/CLI.hpp>

#include "arguments.h"
#include "scene/indirect_light.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

constexpr int kMostPhotons = 100'000'000;
constexpr int kMostRays = 1'000'000;
constexpr int kMostBounces = 20;
constexpr float kLeastError = 0.01F, kMostError = 10;

}  // namespace

void IndirectArguments::check(std::uint32_t integrator, const std::string& device) const {
    if ((radiosity_bounces || radiosity_error) && radiosity.value_or(0) == 0)
        throw UsageError("--radiosity-bounces and --radiosity-error are for radiosity", "add --radiosity 200");
    const bool shoots = photons.value_or(0) > 0, gathers = radiosity.value_or(0) > 0;
    if (!shoots && !gathers) return;
    const std::string option = shoots ? "--photons" : "--radiosity";
    if (integrator == kernel::INTEGRATOR_PATH)
        throw UsageError(shoots ? "--photons is for pictures without paths: those find caustics themselves"
                                : "--radiosity is for pictures without paths: those find what surfaces send each other",
                         "leave " + option + " or --integrator path out");
    if (integrator != kernel::INTEGRATOR_WHITTED)
        throw UsageError(option + " finds light, --integrator occlusion shows none", "leave one of them out");
    if (device == "gpu")
        throw UsageError("photons and radiosity are drawn by the CPU only", "leave " + option + " or --device gpu out");
}

std::string IndirectArguments::device_for(const std::string& device) const {
    return photons.value_or(0) > 0 || radiosity.value_or(0) > 0 ? "cpu" : device;
}

void IndirectArguments::apply(scene::Scene& scene) const {
    if (photons) {
        if (*photons == 0) {
            scene.photons.reset();
        } else {
            if (!scene.photons) scene.photons = scene::photons_for(*photons);
            // Those objects that the scene marks are shot at, if there are any.
            scene.photons->find_targets = true;
            scene.photons->count = *photons;
            scene.photons->spacing = 0;
            scene.photons->loaded.reset();
        }
    }
    if (radiosity) {
        if (*radiosity == 0) {
            scene.radiosity.reset();
        } else {
            if (!scene.radiosity) scene.radiosity = scene::radiosity_for(*radiosity);
            scene.radiosity->count = *radiosity;
        }
    }
    if (radiosity_bounces) scene.radiosity->recursion_limit = *radiosity_bounces;
    if (radiosity_error) scene.radiosity->error_bound = *radiosity_error;
}

void add_photon_options(CLI::App& command, IndirectArguments& a) {
    using Text = const std::string&;
    command
        .add_option_function<std::string>(
            "--photons", [&a](Text text) { a.photons = parse_int("--photons", text, 0, kMostPhotons); },
            "Caustics: the lights shoot about so many photons at what mirrors or refracts, for example 500000; 0: "
            "none, even if the scene asks for them")
        ->type_name("N");
}

void add_radiosity_options(CLI::App& command, IndirectArguments& a) {
    using Text = const std::string&;
    command
        .add_option_function<std::string>(
            "--radiosity", [&a](Text text) { a.radiosity = parse_int("--radiosity", text, 0, kMostRays); },
            "Light that matt surfaces send each other, instead of ambient light: so many rays look for it from each "
            "place where it is gathered, for example 200; 0: none, even if the scene asks for it")
        ->type_name("N");
    command
        .add_option_function<std::string>(
            "--radiosity-bounces",
            [&a](Text text) { a.radiosity_bounces = parse_int("--radiosity-bounces", text, 1, kMostBounces); },
            "From how many surfaces, one after the other (else the scene's, else 4)")
        ->type_name("N");
    command
        .add_option_function<std::string>(
            "--radiosity-error",
            [&a](Text text) { a.radiosity_error = parse_float("--radiosity-error", text, kLeastError, kMostError); },
            "Where less than this is enough, it is gathered in more places (else the scene's, else 0.5)")
        ->type_name("E");
}

}  // namespace sundog::app
