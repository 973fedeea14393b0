// SPDX-License-Identifier: Apache-2.0
// Where pictures go: decided and checked before anything is rendered.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "arguments.h"
#include "output/image.h"

namespace sundog::app {

/// What `-o` names.
enum class Target { image, standard_output, numbered_images, video };

struct OutputPlan {
    Target target = Target::image;
    std::filesystem::path file;                   ///< As given; for numbered images, the pattern.
    output::Format format = output::Format::png;  ///< Of images.
};

/// Decides from -o, --format and --frames, and sees that the place can be
/// written to. Errors: UsageError (unknown ending, a video without frames,
/// frames to standard output or to a bad pattern, layers in a format without
/// them), OutputError (no such folder, write-protected, a folder in the file's
/// place).
OutputPlan plan_output(const std::string& file, const std::string& format, const std::optional<FrameRange>& frames,
                       bool layers);

/// File of frame `number`: "%d" or "%04d" in the pattern's name is replaced,
/// else "-0001" goes before the ending.
std::filesystem::path numbered_file(const std::filesystem::path& pattern, int number);

}  // namespace sundog::app
