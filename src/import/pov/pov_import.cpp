// SPDX-License-Identifier: Apache-2.0
#include "import/pov/pov_import.h"

#include "import/pov/build_scene.h"
#include "import/pov/interpreter.h"
#include "scene/files.h"

namespace sundog::pov {

scene::Scene import_pov(const std::filesystem::path& file, const PovOptions& options, const WarningSink& warn) {
    scene::Scene scene;
    scene.name = file.stem().string();
    scene.ambient = {1, 1, 1};  // global_settings' ambient_light
    SourceFiles sources;
    const FileFinder files(file.parent_path(), options);
    SceneBuilder builder(scene, sources, files, options, warn);
    interpret(file, options, sources, builder, nullptr, warn);
    builder.finish();
    std::vector<std::string> read = std::move(scene.files);
    scene.files.clear();
    for (const std::filesystem::path& path : sources.paths()) scene::add_file(scene, path);
    for (const std::string& path : read) scene::add_file(scene, path);
    return scene;
}

}  // namespace sundog::pov
