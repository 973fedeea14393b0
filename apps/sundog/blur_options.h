// SPDX-License-Identifier: Apache-2.0
// `sundog render`: how the blur of lens and shutter is made.
#pragma once

#include <optional>
#include <string>

#include "compile/compile.h"
#include "postprocess/lens_blur.h"

namespace CLI {
class App;
}

namespace sundog {
struct RenderResult;
}

namespace sundog::app {

struct RenderArguments;
struct Stage;

struct BlurArguments {
    std::optional<postprocess::Spread> lens;  ///< Else it is traced.
    bool velocity = false;                    ///< Of the shutter; else it is traced.

    [[nodiscard]] bool any() const { return lens || velocity; }
    /// Errors: UsageError for options that don't go together.
    void check(const RenderArguments& arguments) const;
    /// Errors: UsageError for a camera whose pictures can't be blurred afterwards.
    void check_camera(const Frame& frame) const;
};

/// Gives a command the options; `arguments` must outlive it.
void add_blur_options(CLI::App& command, BlurArguments& arguments);

/// The moments when the shutter opens and closes and the one between; all the same without a shutter that is blurred
/// afterwards.
struct ShutterFrames {
    Frame opens, middle, closes;
};

/// Meshes that bend are left in the session as they are in the middle. `options.time_s`: when the shutter opens.
ShutterFrames shutter_frames(const RenderArguments& arguments, FrameOptions options, const Stage& stage);

/// Blurs a whole picture of the middle moment, made without the lens where that is to be blurred. Stopped, it stays as
/// it is and counts as stopped. Returns what is to be said of it: ", blurred in 0.12 s".
std::string blur_picture(const RenderArguments& arguments, const ShutterFrames& frames, const Stage& stage,
                         const StopFlag& stop, RenderResult& result);

}  // namespace sundog::app
