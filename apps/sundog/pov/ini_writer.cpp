// SPDX-License-Identifier: Apache-2.0
#include "ini_writer.h"

#include <charconv>

#include "option_table.h"

namespace sundog::app {
namespace {

/// Values with blanks, comment signs or quotes stand in quotes of the kind that they don't hold.
std::string quoted(const std::string& value) {
    std::string bare(without_quotes(trimmed(value)));
    if (bare.find_first_of(" \t;'\"#") == std::string::npos) return bare;
    const char quote = bare.find('"') == std::string::npos ? '"' : '\'';
    return quote + bare + quote;
}

std::string shortest(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::string ini_text(const PovSettings& settings) {
    std::string text;
    for (const auto& [name, value] : settings.given)
        if (name != "Create_Ini") text += name + "=" + quoted(value) + "\n";
    for (const std::string& path : settings.library_paths) text += "Library_Path=" + quoted(path) + "\n";
    for (const PovSettings::Declaration& declared : settings.declarations)
        text += "Declare=" + declared.name + "=" + shortest(declared.value) + "\n";
    return text;
}

}  // namespace sundog::app
