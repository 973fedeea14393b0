// SPDX-License-Identifier: Apache-2.0
#include "pov_target.h"

#include "base/diagnostics.h"
#include "import/pov/build_scene.h"
#include "import/pov/interpreter.h"
#include "scene/validate.h"

namespace sundog::fuzz {

std::optional<std::string> refusal_of_pov_scene(std::string_view text) {
    // A folder that isn't there, and no other: nothing on this machine is read.
    const std::filesystem::path nowhere = "/nonexistent-folder-of-the-fuzzer";
    pov::PovOptions options;
    options.width = 16;
    options.height = 12;
    options.limits.steps = 20'000;
    options.limits.depth = 50;
    options.limits.memory_bytes = std::uint64_t{64} << 20U;
    options.access.sandbox = true;
    try {
        scene::Scene scene;
        pov::SourceFiles sources;
        const WarningSink ignore = [](const Diagnostic& warning) { (void)format(warning); };
        const pov::FileFinder files(nowhere, options);
        pov::SceneBuilder builder(scene, sources, files, options, ignore);
        pov::interpret_text("fuzz.pov", text, nowhere, options, sources, builder, nullptr, ignore);
        builder.finish();
        return std::nullopt;
    } catch (const InputError& error) {
        return error.what();
    }
}

}  // namespace sundog::fuzz
