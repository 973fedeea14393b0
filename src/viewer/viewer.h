// SPDX-License-Identifier: Apache-2.0
// The window: SDL2 with Dear ImGui.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "device/acceleration.h"
#include "viewer/loaded_scene.h"

namespace sundog::viewer {

/// How `sundog view` was called.
struct ViewOptions {
    std::filesystem::path scene_file;
    std::string device = "auto";
    int threads = 0;
    Acceleration acceleration = Acceleration::embree;  ///< On the CPU.
    std::optional<int> width, height;
    std::optional<int> max_depth;
    std::optional<float> min_weight;
    bool fullscreen = false;
    import::Choices choices;
    SceneChange change;  ///< Done to the scene whenever it is read.
};

/// Opens the window and runs until it is closed. Errors: InputError for a scene that can't be read at the start,
/// DeviceError where no window can be opened.
void run(const ViewOptions& options, const WarningSink& warn);

}  // namespace sundog::viewer
