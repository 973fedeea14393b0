// SPDX-License-Identifier: Apache-2.0
#include "import/pov/source_files.h"

namespace sundog::pov {

std::uint32_t SourceFiles::add(std::filesystem::path path, SourceText text) {
    paths_.push_back(std::move(path));
    texts_.push_back(std::move(text));
    return static_cast<std::uint32_t>(texts_.size() - 1);
}

Diagnostic SourceFiles::diagnose(Severity severity, Place where, std::string message, std::string hint) const {
    Diagnostic diagnostic{severity, {}, std::move(message), {}, std::move(hint)};
    if (where.file >= texts_.size()) return diagnostic;
    const SourceText& source = texts_[where.file];
    diagnostic.where = {source.name, where.line, where.column};
    LineReader lines(source);
    std::string_view line;
    while (where.line > 0 && lines.next(line)) {
        if (lines.number() != where.line) continue;
        diagnostic.source_line = std::string(line);
        break;
    }
    return diagnostic;
}

void SourceFiles::fail(Place where, std::string message, std::string hint) const {
    throw InputError(diagnose(Severity::error, where, std::move(message), std::move(hint)));
}

}  // namespace sundog::pov
