// SPDX-License-Identifier: Apache-2.0
#include "import/pov/pov_import.h"

#include "import/pov/build_queries.h"
#include "import/pov/build_scene.h"
#include "import/pov/format_blocks.h"
#include "import/pov/interpreter.h"
#include "scene/files.h"

namespace sundog::pov {

std::vector<std::filesystem::path> installed_library_paths() {
    std::vector<std::filesystem::path> folders;
    for (const char* folder : {"/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include",
                               "/usr/share/povray/include", "/opt/homebrew/share/povray-3.7/include"}) {
        std::error_code error;
        if (std::filesystem::is_directory(folder, error)) folders.emplace_back(folder);
    }
    return folders;
}

scene::Scene import_pov(const std::filesystem::path& file, const PovOptions& options, const WarningSink& warn) {
    scene::Scene scene;
    scene.name = file.stem().string();
    scene.ambient = {1, 1, 1};  // global_settings' ambient_light
    scene.sky_alpha = 0;        // POV-Ray's own background can't be seen where a picture has alpha.
    SourceFiles sources;
    const FileFinder files(file.parent_path(), options);
    SceneBuilder builder(scene, sources, files, options, warn);
    ObjectQueries queries(sources, files, options);
    builder.ask(queries);
    interpret(file, options, sources, builder, &queries, warn);
    builder.finish();
    std::vector<std::string> read = std::move(scene.files);
    scene.files.clear();
    for (const std::filesystem::path& path : sources.paths()) scene::add_file(scene, path);
    for (const std::string& path : read) scene::add_file(scene, path);
    return scene;
}

std::string format_pov(const std::filesystem::path& file, const PovOptions& options, const WarningSink& warn) {
    SourceFiles sources;
    const FileFinder files(file.parent_path(), options);
    ObjectQueries queries(sources, files, options);
    std::string text;
    FormattingSink sink(text);
    interpret(file, options, sources, sink, &queries, warn);
    return text;
}

}  // namespace sundog::pov
