// SPDX-License-Identifier: Apache-2.0
// POV-Ray scenes (POV-Ray 3.7 reference, section 3.3 "Scene Description Language").
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "import/pov/pov_options.h"
#include "scene/scene.h"

namespace sundog::pov {

/// Reads a POV-Ray scene with all that it includes. Scene::files lists every file that was read. What Sundog doesn't
/// draw yet is left out with one warning for each feature. Errors: InputError at the statement at fault, also for
/// limits and files that `options` doesn't allow.
scene::Scene import_pov(const std::filesystem::path& file, const PovOptions& options, const WarningSink& warn);

/// The same scene in normalised POV-Ray language: no directives but #version, #default and the functions used, every
/// identifier replaced by what it stands for. Errors: as import_pov's, but for what only building the scene finds.
std::string format_pov(const std::filesystem::path& file, const PovOptions& options, const WarningSink& warn);

/// Where POV-Ray's include files (colors.inc and the rest) are installed on this machine.
std::vector<std::filesystem::path> installed_library_paths();

}  // namespace sundog::pov
