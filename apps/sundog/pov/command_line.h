// SPDX-License-Identifier: Apache-2.0
// From the words of a povray command line, and the INI files that it and its surroundings name, to settings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "settings.h"

namespace sundog::app {

/// What a command line means depends on where it is given.
struct PovSurroundings {
    std::filesystem::path working_folder;         ///< Names that aren't absolute start here.
    std::optional<std::filesystem::path> povini;  ///< The environment's POVINI.
    std::filesystem::path home;                   ///< Empty: none.
    /// INI files of the whole system, first found first served.
    std::vector<std::filesystem::path> system_inis;
};

/// Those of this process.
PovSurroundings surroundings_of_process();

/// Settings of `words` (without the program's name). First the default INI file is read: POVINI's, else povray.ini of
/// the working folder, else ~/.povray/3.7/povray.ini, else the system's. Then the words from left to right; a later
/// setting replaces an earlier one. A bare word names an INI file, with or without its .ini and perhaps a [section],
/// looked for in the working folder and then in the library paths named so far; or, if it ends in .pov, the scene.
/// Settings::command_line_folders gets the folders of files that words name.
/// Errors: UsageError about a word; InputError about a line of an INI file.
PovSettings read_command_line(const std::vector<std::string>& words, const PovSurroundings& surroundings,
                              const WarningSink& warn);

}  // namespace sundog::app
