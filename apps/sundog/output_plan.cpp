// SPDX-License-Identifier: Apache-2.0
#include "output_plan.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

#include "base/diagnostics.h"
#include "output/file.h"
#include "output/video.h"
#include "usage_error.h"

namespace sundog::app {
namespace {

/// The place of "%d" or "%0Nd" in a file's name.
struct NumberField {
    std::size_t begin = 0, end = 0;
    int digits = 1;
};

/// Nothing where the name has no '%'. Errors: UsageError where it has, but not
/// exactly one valid field.
std::optional<NumberField> number_field(const std::string& name) {
    const std::size_t begin = name.find('%');
    if (begin == std::string::npos) return std::nullopt;
    NumberField field{begin, begin + 1, 1};
    if (field.end + 1 < name.size() && name[field.end] == '0' && name[field.end + 1] >= '1' &&
        name[field.end + 1] <= '9') {
        field.digits = name[field.end + 1] - '0';
        field.end += 2;
    }
    if (field.end >= name.size() || name[field.end] != 'd' || name.find('%', field.end) != std::string::npos)
        throw UsageError(fmt::format("-o '{}': the frame number must stand once, as %d or %04d", name),
                         "for example -o turn-%04d.png");
    ++field.end;
    return field;
}

output::Format format_by_name(const std::string& name) {
    struct Named {
        std::string_view name;
        output::Format format;
    };
    constexpr std::array<Named, 7> kFormats{{{"png", output::Format::png},
                                             {"jpg", output::Format::jpg},
                                             {"exr", output::Format::exr},
                                             {"hdr", output::Format::hdr},
                                             {"ppm", output::Format::ppm},
                                             {"tga", output::Format::tga},
                                             {"bmp", output::Format::bmp}}};
    std::vector<std::string_view> names;
    for (const Named& f : kFormats) names.push_back(f.name);
    const std::string chosen = parse_choice("--format", name, names);
    for (const Named& f : kFormats)
        if (f.name == chosen) return f.format;
    return output::Format::png;
}

output::Format format_by_ending(const std::filesystem::path& file) {
    try {
        return output::format_of(file);
    } catch (const OutputError& error) {
        throw UsageError(error.what(), "with --frames also .mp4 .webm .gif");
    }
}

/// A replacement that is dropped at once shows whether one could be made.
void check_writable(const std::filesystem::path& file) {
    if (output::is_special_file(file)) return;
    const output::Replacement trial(file);
}

}  // namespace

OutputPlan plan_output(const std::string& file, const std::string& format, const std::optional<FrameRange>& frames,
                       bool layers) {
    OutputPlan plan;
    plan.file = file;
    if (file == "-") {
        plan.target = Target::standard_output;
        if (frames && frames->first != frames->last)
            throw UsageError("-o -: only one picture goes to standard output", "name a file for the frames");
        if (isatty(STDOUT_FILENO))
            throw UsageError("-o -: a picture can't be shown on a terminal",
                             "redirect standard output to a file or pipe");
        if (!format.empty()) plan.format = format_by_name(format);
    } else if (output::is_video(plan.file)) {
        plan.target = Target::video;
        if (!frames)
            throw UsageError(fmt::format("-o '{}': a video needs --frames", file),
                             "for example --frames 0..249, or --turntable 100");
        check_writable(plan.file);
    } else {
        plan.target = frames ? Target::numbered_images : Target::image;
        plan.format = format_by_ending(plan.file);
        check_writable(frames ? numbered_file(plan.file, frames->first) : plan.file);
    }
    if (!format.empty() && plan.target != Target::standard_output)
        throw UsageError("--format is only for -o -; the file's ending says it elsewhere");
    if (layers && (plan.target == Target::video || plan.format != output::Format::exr))
        throw UsageError("--aov needs a format with layers", "write an .exr file");
    return plan;
}

std::filesystem::path numbered_file(const std::filesystem::path& pattern, int number) {
    const std::string name = pattern.filename().string();
    if (const auto field = number_field(name))
        return pattern.parent_path() /
               (name.substr(0, field->begin) + fmt::format("{:0{}}", number, field->digits) + name.substr(field->end));
    return pattern.parent_path() /
           fmt::format("{}-{:04}{}", pattern.stem().string(), number, pattern.extension().string());
}

}  // namespace sundog::app
