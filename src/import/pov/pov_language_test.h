// SPDX-License-Identifier: Apache-2.0
// For tests: small programs in POV-Ray's language, and what they print or make.
#pragma once

#include <algorithm>
#include <string>

#include "import/pov/format_blocks.h"
#include "import/pov/interpreter.h"

namespace sundog::pov {

/// What the scene prints to the debug stream.
inline std::string printed(const std::string& scene, PovOptions options = {}) {
    std::string text, blocks;
    options.print = [&](PovStream stream, std::string_view line) {
        if (stream == PovStream::debug) text += line;
    };
    SourceFiles sources;
    FormattingSink sink(blocks);
    interpret_text("test.pov", scene, ".", options, sources, sink, nullptr, {});
    return text;
}

/// The scene's blocks as normalised text, without its first line, which is the version's.
inline std::string formatted(const std::string& scene, const PovOptions& options = {}, const WarningSink& warn = {}) {
    std::string blocks;
    SourceFiles sources;
    FormattingSink sink(blocks);
    interpret_text("test.pov", scene, ".", options, sources, sink, nullptr, warn);
    return blocks.substr(std::min(blocks.size(), blocks.find('\n') + 1));
}

/// The value of an expression, which stands behind `declarations`.
inline std::string evaluated(const std::string& expression, const std::string& declarations = "") {
    std::string block = formatted(declarations + "\nbackground { " + expression + " }");
    const std::string before = "background { ", after = " }\n";
    if (block.size() < before.size() + after.size()) return block;
    return block.substr(before.size(), block.size() - before.size() - after.size());
}

}  // namespace sundog::pov
