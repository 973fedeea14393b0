// SPDX-License-Identifier: Apache-2.0
#include "output_name.h"

#include <cmath>
#include <string>

#include "../usage_error.h"

namespace sundog::app {
namespace {

namespace fs = std::filesystem;

std::string with_number(std::string name, const PovAnimation& animation, int frame) {
    if (!animation.animated) return name;
    const std::string number = std::to_string(frame);
    const auto digits = static_cast<std::size_t>(animation.digits());
    if (number.size() < digits) name.append(digits - number.size(), '0');
    return name + number;
}

struct Span {
    int begin = 0, end = 0;
};

/// `start` and `end` as given, of `size` columns or rows.
Span span_of(std::optional<double> start, std::optional<double> end, int size, const char* what) {
    Span span{0, size};
    if (start) {
        const double at = *start < 1 ? std::floor(*start * size) : std::floor(*start) - 1;
        if (at >= size)
            throw UsageError(std::string("Start_") + what + " lies outside the picture",
                             "expected a number from 1 to " + std::to_string(size) + ", or a fraction under 1");
        span.begin = static_cast<int>(at);
    }
    if (end) {
        // 1 is all of it here, not the first one.
        const double at = *end <= 1 ? std::floor(*end * size) : std::floor(*end);
        if (at > size || at < 1)
            throw UsageError(std::string("End_") + what + " lies outside the picture",
                             "expected a number from 2 to " + std::to_string(size) + ", or a fraction up to 1");
        span.end = static_cast<int>(at);
    }
    if (span.begin >= span.end)
        throw UsageError(std::string("Start_") + what + " lies behind End_" + what, "nothing would be drawn");
    return span;
}

}  // namespace

const char* ending_of(PovFileType type) {
    switch (type) {
        case PovFileType::bmp:
            return ".bmp";
        case PovFileType::targa_rle:
        case PovFileType::targa:
            return ".tga";
        case PovFileType::exr:
            return ".exr";
        case PovFileType::hdr:
            return ".hdr";
        case PovFileType::jpeg:
            return ".jpg";
        case PovFileType::png:
            break;
        case PovFileType::ppm:
            return ".ppm";
    }
    return ".png";
}

fs::path picture_file(const PovSettings& settings, const PovAnimation& animation, int frame) {
    const fs::path scene = settings.input_file;
    const std::string ending = ending_of(settings.file_type);
    std::string name = settings.input_file == "-" ? "stdin" : (scene.parent_path() / scene.stem()).string();
    if (settings.output_file && !settings.output_file->name.empty()) {
        const std::string& given = settings.output_file->name;
        if (given == "-") return given;
        if (given.ends_with('/')) name = given + fs::path(name).filename().string();
        else if (given.ends_with(ending)) name = given.substr(0, given.size() - ending.size());
        else name = given;
    }
    return with_number(std::move(name), animation, frame) + ending;
}

PovRegion region_of(const PovSettings& settings) {
    const Span columns = span_of(settings.start_column, settings.end_column, settings.width, "Column");
    const Span rows = span_of(settings.start_row, settings.end_row, settings.height, "Row");
    return {columns.begin, rows.begin, columns.end, rows.end};
}

}  // namespace sundog::app
