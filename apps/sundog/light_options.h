// SPDX-License-Identifier: Apache-2.0
// `sundog render`: how light is found, and the lens through which it is seen.
#pragma once

#include <optional>
#include <string>

#include "arguments.h"
#include "compile/compile.h"

namespace CLI {
class App;
}

namespace sundog {
class Session;
}

namespace sundog::app {

struct LightArguments {
    std::uint32_t integrator = kernel::INTEGRATOR_WHITTED;
    std::optional<int> seed;
    std::optional<float> clamp, occlusion_distance;
    std::optional<float> aperture, focus;
    std::optional<Pixel> focus_pixel;
    std::optional<int> blades;

    /// Errors: UsageError for options that don't go together.
    void check() const;
    /// Puts the options into those of a frame; where the focus is picked is left to pick_focus().
    void apply(FrameOptions& frame) const;
    /// The distance along the view axis of what the picked pixel sees; nothing where none is picked. Errors: UsageError
    /// for a pixel outside of the picture, or one that sees nothing.
    [[nodiscard]] std::optional<float> pick_focus(const Frame& frame, Session& session) const;
};

/// Gives a command the options; `arguments` must outlive it.
void add_light_options(CLI::App& command, LightArguments& arguments);

}  // namespace sundog::app
