// SPDX-License-Identifier: Apache-2.0
// Orbit scenes: raytracer.conf and .scene files (docs/orbit.md).
#pragma once

#include <filesystem>
#include <string>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace sundog::import {

/// raytracer.conf: which scene, and settings. Settings that a .scene leaves open come from here.
struct OrbitConfig {
    std::string default_scene;  ///< Relative to the folder of the file; empty if not given.
    scene::Settings settings;
};

/// Errors: InputError.
OrbitConfig import_orbit_config(const std::filesystem::path& file, const WarningSink& warn);

/// Reads a .scene and its model(s). Errors: InputError.
scene::Scene import_orbit_scene(const std::filesystem::path& file, const WarningSink& warn);

}  // namespace sundog::import
