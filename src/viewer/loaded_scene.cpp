// SPDX-License-Identifier: Apache-2.0
#include "viewer/loaded_scene.h"

#include <utility>

#include "compile/compile.h"
#include "import/import.h"
#include "scene/deformation.h"

namespace sundog::viewer {

std::shared_ptr<const LoadedScene> load_scene(const std::filesystem::path& file, const SceneChange& change,
                                              const import::Choices& choices) {
    auto loaded = std::make_shared<LoadedScene>();
    const WarningSink keep = [&](const Diagnostic& warning) { loaded->warnings.push_back(warning); };
    loaded->scene = import::import_scene(file, keep, choices);
    if (change) change(loaded->scene);
    loaded->compiled = compile(loaded->scene, keep);
    loaded->animated = is_animated(loaded->scene) && !loaded->scene.settings.freeze_s;
    loaded->deforming = loaded->animated && scene::is_deforming(loaded->scene);
    return loaded;
}

std::shared_ptr<const LoadedScene> bent_at(const LoadedScene& loaded, float time_s) {
    auto bent = std::make_shared<LoadedScene>(loaded);
    scene::deform(bent->scene, time_s);
    bent->compiled = compile(bent->scene, {});
    return bent;
}

}  // namespace sundog::viewer
