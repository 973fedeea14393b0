// SPDX-License-Identifier: Apache-2.0
// The files that a scene is read from, and messages about places in them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/text_file.h"
#include "import/pov/entity.h"

namespace sundog::pov {

/// The texts of a scene file and of its include files, by Place::file. They stay in memory so that messages can show
/// their lines as long as places are in use.
class SourceFiles {
public:
    /// Takes a text in and returns its number.
    std::uint32_t add(std::filesystem::path path, SourceText text);

    /// All files read so far, the scene first (what a hot reload watches).
    [[nodiscard]] const std::vector<std::filesystem::path>& paths() const { return paths_; }
    [[nodiscard]] const SourceText& text(std::uint32_t file) const { return texts_.at(file); }

    /// A message about a place, with the line it names.
    [[nodiscard]] Diagnostic diagnose(Severity severity, Place where, std::string message, std::string hint = {}) const;
    /// Throws an InputError about a place.
    [[noreturn]] void fail(Place where, std::string message, std::string hint = {}) const;

private:
    std::vector<std::filesystem::path> paths_;
    std::vector<SourceText> texts_;
};

}  // namespace sundog::pov
