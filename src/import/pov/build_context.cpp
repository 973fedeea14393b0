// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_context.h"

namespace sundog::pov {

SourceLocation BuildContext::location(Place place) const {
    if (place.file >= sources_.paths().size()) return {};
    return {sources_.text(place.file).name, place.line, place.column};
}

std::filesystem::path BuildContext::find_file(std::string_view name, Place where) const {
    const bool known = where.file < sources_.paths().size();
    return files.find(name, known ? sources_.paths()[where.file] : std::filesystem::path{});
}

std::string BuildContext::why_not_found(std::string_view name, Place where) const {
    const bool known = where.file < sources_.paths().size();
    return files.why_not_found(name, known ? sources_.paths()[where.file] : std::filesystem::path{});
}

void BuildContext::fail(Place place, std::string message, std::string hint) const {
    sources_.fail(place, std::move(message), std::move(hint));
}

void BuildContext::warn(Place place, std::string message, std::string hint) const {
    if (warn_) warn_(sources_.diagnose(Severity::warning, place, std::move(message), std::move(hint)));
}

void BuildContext::warn_once(std::string_view feature, Place place, std::string message, std::string hint) {
    if (warned_.emplace(feature).second) warn(place, std::move(message), std::move(hint));
}

bool BuildContext::stored_colors(std::uint16_t version) const {
    // Between powers of 2.2 and sRGB there is less than what 8 bits show, and between 1.8 and 2.2 scenes don't care.
    return color_space.assumed_gamma ? *color_space.assumed_gamma > 1.5 : version < 370;
}

}  // namespace sundog::pov
