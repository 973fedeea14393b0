// SPDX-License-Identifier: Apache-2.0
// One door to all importers.
#pragma once

#include <filesystem>
#include <string>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace sundog::import {

/// What of a file is read, where it leaves a choice.
struct Choices {
    std::string variant;  ///< Of a glTF file's materials (KHR_materials_variants); empty: the file's own.
};

/// Reads any scene file by its ending: .scene (orbit; a raytracer.conf beside it gives its settings), .obj (with a
/// camera that frames its bounds, orbiting, and a sun), .gltf and .glb (with such a camera and sun where it has none),
/// .pov (POV-Ray, for a picture of 640x480), .conf (its defaultScene). Errors: InputError.
scene::Scene import_scene(const std::filesystem::path& file, const WarningSink& warn, const Choices& choices = {});

}  // namespace sundog::import
