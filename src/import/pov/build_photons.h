// SPDX-License-Identifier: Apache-2.0
// The photons blocks of global_settings, objects and lights (POV-Ray reference, section 3.4.4.4 "Photons").
#pragma once

#include "import/pov/build_items.h"
#include "scene/photons.h"

namespace sundog::pov {

/// Reads `photons { }` of global_settings; what it doesn't say stays as in `start`. Errors: InputError, also for files
/// of photons that can't be read or may not be written.
scene::Photons read_photons(BuildContext& context, const Block& block, scene::Photons start);

/// Reads `photons { }` of an object; what it doesn't say stays as in `start`.
scene::ObjectPhotons read_object_photons(BuildContext& context, const Block& block, scene::ObjectPhotons start);

/// Reads `photons { }` of a light; what it doesn't say stays as in `start`.
scene::LightPhotons read_light_photons(BuildContext& context, const Block& block, scene::LightPhotons start);

}  // namespace sundog::pov
