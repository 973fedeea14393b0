// SPDX-License-Identifier: Apache-2.0
// The command line that computes again what the window showed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "compile/compile.h"
#include "kernel/shared.h"

namespace sundog::viewer {

/// The value of `--camera`: twelve numbers, separated by commas: eye, center, right, up (see kernel::Camera), each
/// x,y,z. Written so that reading them back gives the same bits.
std::string camera_argument(const kernel::Camera& camera);

/// Reads what camera_argument() writes; empty where it isn't twelve finite numbers that span a view.
std::optional<kernel::Camera> parse_camera_argument(std::string_view text);

/// Quotes a word for a POSIX shell where it needs it.
std::string shell_quoted(std::string_view word);

/// "sundog render FILE --time … --camera … --size WxH --pixel X,Y" with the limits that `options` sets. Width, height
/// and camera must be set in `options`.
std::string replay_command(const std::filesystem::path& scene_file, std::string_view device,
                           const FrameOptions& options, int pixel_x, int pixel_y);

}  // namespace sundog::viewer
