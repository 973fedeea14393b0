// SPDX-License-Identifier: Apache-2.0
// What the builder's tests share: from text to a scene.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "import/pov/build_scene.h"
#include "import/pov/interpreter.h"

namespace sundog::pov {

/// A scene made of text, and the messages of the warnings that came with it.
struct BuiltScene {
    scene::Scene scene;
    std::vector<std::string> warnings;
};

inline BuiltScene build(std::string_view text, const PovOptions& options = {}) {
    BuiltScene result;
    SourceFiles sources;
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    const FileFinder files(folder, options);
    const WarningSink warn = [&](const Diagnostic& d) { result.warnings.push_back(d.message); };
    SceneBuilder builder(result.scene, sources, files, options, warn);
    interpret_text("test.pov", text, folder, options, sources, builder, nullptr, warn);
    builder.finish();
    return result;
}

/// The message of the InputError that a scene raises; empty if it raises none.
inline std::string error_of(std::string_view text) {
    try {
        build(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace sundog::pov
