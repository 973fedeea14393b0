// SPDX-License-Identifier: Apache-2.0
#include "text_streams.h"

#include <utility>

#include "base/diagnostics.h"

namespace sundog::app {

namespace fs = std::filesystem;

FileAccess output_policy(const PovSettings& settings, const fs::path& working_folder) {
    FileAccess policy;
    policy.allow_writing(working_folder);
    for (const fs::path& folder : settings.command_line_folders) policy.allow_writing(folder);
    for (const std::string& folder : settings.allow_write) policy.allow_writing(working_folder / folder);
    return policy;
}

void check_named_output(const NamedOutput& named, const fs::path& file, const FileAccess& policy) {
    if (named.from_command_line) return;
    if (const auto why = policy.why_unwritable(file))
        throw OutputError("an INI file wants to write '" + file.string() + "': " + *why +
                          "; name it on the command line, or its folder with --allow-write");
}

TextStreams::TextStreams(const PovSettings& settings, const FileAccess& policy, Console console)
    : settings_(settings), console_(std::move(console)) {
    for (const PovTextStream& stream : settings.text) {
        if (!stream.file || files_.contains(stream.file->name)) continue;
        const fs::path file = stream.file->name;
        check_named_output(*stream.file, file, policy);
        // A device or pipe could swallow the program; nothing but a file is meant.
        std::error_code ignored;
        if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
            throw OutputError("can't write '" + file.string() + "': it is no regular file");
        std::ofstream out(file, settings.append_text_files ? std::ios::app : std::ios::trunc);
        if (!out) throw OutputError("can't write '" + file.string() + "'");
        files_.emplace(file, std::move(out));
    }
}

void TextStreams::write(PovText stream, std::string_view text) {
    const PovTextStream& target = settings_.text[static_cast<std::size_t>(stream)];
    if (target.console && console_) console_(text);
    if (target.file) files_.at(target.file->name) << text << std::flush;
}

}  // namespace sundog::app
