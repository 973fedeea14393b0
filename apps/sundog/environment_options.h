// SPDX-License-Identifier: Apache-2.0
// What lies around a scene: a picture, or a sky with its sun.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace CLI {
class App;
}

namespace sundog::app {

/// Where the sun stands, and how hazy the air is.
struct SkyArguments {
    float elevation_deg = 40;
    float azimuth_deg = 225;  ///< From the environment's middle (north), clockwise from above.
    float turbidity = 3;
};
/// "", "30", "30,90" or "30,90,4". Errors: UsageError.
SkyArguments parse_sky(const std::string& text);

/// What the options say.
struct EnvironmentArguments {
    std::optional<std::string> file;
    std::optional<float> turn_deg, gain;
    std::optional<SkyArguments> sky;

    /// Errors: UsageError for options that don't go together.
    void check() const;
    /// Gives the scene what was asked for in place of its own surroundings. Errors: InputError for a picture that can't
    /// be read.
    void apply(scene::Scene& scene) const;
};

/// Gives a command the options; `arguments` must outlive it.
void add_environment_options(CLI::App& command, EnvironmentArguments& arguments);

}  // namespace sundog::app
