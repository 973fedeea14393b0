// SPDX-License-Identifier: Apache-2.0
// Tachyon (John E. Stone's ray tracer, 1994-2013) as a peer: our scene in its format, and its own figure for the time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "device/render_scene.h"

namespace sundog::bench {

/// The scene and frame in the format that Tachyon 0.99 reads. Its camera is left-handed, so X changes sign. Differences
/// that its materials bring: one colour for all lobes, transparency without refraction. Errors: DeviceError for a scene
/// with boxes, planes or moving geometry.
std::string tachyon_scene(const RenderScene& scene, const Frame& frame);

/// The figure in Tachyon's report "Ray Tracing Time: 0.0754 seconds"; nothing where there is no such line.
std::optional<double> tachyon_seconds(std::string_view report);

/// Runs the `tachyon` program on a scene file without saving a picture: its ray tracing time in seconds. Nothing where
/// the program isn't installed or fails.
std::optional<double> run_tachyon(const std::filesystem::path& scene_file, int width, int height, int threads);

}  // namespace sundog::bench
