// SPDX-License-Identifier: Apache-2.0
// `sundog render`, `sundog view`: light that comes by way of mirrors, glass and other surfaces, in pictures that aren't
// made of paths.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace CLI {
class App;
}

namespace sundog::app {

/// What the options say. Where they say nothing a scene keeps what it says itself.
struct IndirectArguments {
    std::optional<int> photons;    ///< How many are shot; 0: none.
    std::optional<int> radiosity;  ///< Rays for each value; 0: none are gathered.
    std::optional<int> radiosity_bounces;
    std::optional<float> radiosity_error;

    /// Errors: UsageError for options that don't go together, or with the integrator (INTEGRATOR_*) or `device`
    /// ("auto", "cpu" or "gpu") that were asked for.
    void check(std::uint32_t integrator, const std::string& device) const;
    /// The device that is to be asked for in place of `device`.
    [[nodiscard]] std::string device_for(const std::string& device) const;
    /// Turns on, or off, what was asked for.
    void apply(scene::Scene& scene) const;
};

/// Gives a command `--photons`; `arguments` must outlive it.
void add_photon_options(CLI::App& command, IndirectArguments& arguments);
/// And those of radiosity.
void add_radiosity_options(CLI::App& command, IndirectArguments& arguments);

}  // namespace sundog::app
