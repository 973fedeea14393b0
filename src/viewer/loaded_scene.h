// SPDX-License-Identifier: Apache-2.0
// A scene as written together with what is rendered of it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "base/diagnostics.h"
#include "device/render_scene.h"
#include "import/import.h"
#include "scene/scene.h"

namespace sundog::viewer {

/// Immutable once loaded; the window and the render thread share it.
struct LoadedScene {
    scene::Scene scene;
    std::shared_ptr<const RenderScene> compiled;
    std::vector<Diagnostic> warnings;
    bool animated = false;   ///< Something moves, and no `freeze` holds it.
    bool deforming = false;  ///< Meshes are bent over time, too.
};

/// What is done to a scene once it was read, such as giving it surroundings. Errors: InputError.
using SceneChange = std::function<void(scene::Scene&)>;

/// Imports, changes (where there is a change to make) and compiles. Errors: InputError.
std::shared_ptr<const LoadedScene> load_scene(const std::filesystem::path& file, const SceneChange& change = {},
                                              const import::Choices& choices = {});

/// The same scene with its meshes as they are bent at a moment.
std::shared_ptr<const LoadedScene> bent_at(const LoadedScene& loaded, float time_s);

}  // namespace sundog::viewer
