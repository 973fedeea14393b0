// SPDX-License-Identifier: Apache-2.0
// POV-Ray's INI files, line by line (POV-Ray 3.7 tutorial, section 2.2.8.2 "Using INI Files").
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_file.h"

namespace sundog::app {

/// What stands on a line of an INI file.
struct IniLine {
    enum class Kind : std::uint8_t {
        option,    ///< name=value
        switches,  ///< +W320 +H200
        file,      ///< The name of another INI file or of a scene, alone on its line.
    } kind = Kind::option;
    std::string name, value;         ///< option; a file's name is in `name`.
    std::vector<std::string> words;  ///< switches
};

/// Called for each line that counts; `cursor` stands at its start and can tell its place. What it throws passes on.
using IniVisitor = std::function<void(const IniLine& line, LineCursor& cursor)>;

/// Visits the lines of the unlabelled area at the top and of all sections labelled `label` (any case); an empty label
/// stands for the area at the top alone. The tutorial says that a label leaves the top out, but povray reads it.
/// Returns false where there is a label and no such section. Errors: what read_text_file throws; InputError for a
/// section label without its bracket.
bool visit_ini_file(const std::filesystem::path& file, std::string_view label, const IniVisitor& visit);

/// The words of a line, separated by blanks; quotes keep blanks in a word and stay part of it.
std::vector<std::string> words_of(std::string_view line);

}  // namespace sundog::app
