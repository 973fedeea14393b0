// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ and MTL (Wavefront Advanced Visualizer manual, appendix B1 and MTL appendix, 1995; PBR extension).
#pragma once

#include <filesystem>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace sundog::import {

/// Reads an OBJ file with its material libraries and textures and appends its objects, materials and textures to
/// `scene` (and every file read to scene.files). Material indices are valid afterwards: faces without usemtl get a
/// default material. Errors: InputError for what can't be understood; missing libraries, materials and textures are
/// warnings with a visible stand-in (magenta and black checker).
void import_obj(const std::filesystem::path& file, scene::Scene& scene, const WarningSink& warn);

/// Reads an MTL file alone and appends its materials (and textures) to `scene`.
void import_mtl(const std::filesystem::path& file, scene::Scene& scene, const WarningSink& warn);

}  // namespace sundog::import
