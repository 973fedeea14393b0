// SPDX-License-Identifier: Apache-2.0
// The texts of a run, sorted into POV-Ray's streams: to the console, to files, or nowhere (POV-Ray 3.7 reference,
// section 3.2.7 "Text Output Options").
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string_view>

#include "base/file_access.h"
#include "settings.h"

namespace sundog::app {

/// Where files that INI files name may be written: below the working folder, the folders of the files that the command
/// line names, and those of --allow-write.
FileAccess output_policy(const PovSettings& settings, const std::filesystem::path& working_folder);

/// Errors: OutputError if an INI file names `file` and `policy` doesn't allow it.
void check_named_output(const NamedOutput& named, const std::filesystem::path& file, const FileAccess& policy);

class TextStreams {
public:
    using Console = std::function<void(std::string_view)>;
    /// Opens the streams' files. A file of several streams is opened once. Errors: OutputError.
    TextStreams(const PovSettings& settings, const FileAccess& policy, Console console);
    /// Writes `text` as it is, wherever the stream goes.
    void write(PovText stream, std::string_view text);

private:
    const PovSettings& settings_;
    Console console_;
    std::map<std::filesystem::path, std::ofstream> files_;
};

}  // namespace sundog::app
