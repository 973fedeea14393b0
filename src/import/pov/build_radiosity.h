// SPDX-License-Identifier: Apache-2.0
// `radiosity { }` of global settings (POV-Ray reference, section 3.4.4.3).
#pragma once

#include "import/pov/build_items.h"
#include "scene/scene.h"

namespace sundog::pov {

/// `start` as the block changes it.
scene::Radiosity read_radiosity(BuildContext& context, const Block& block, scene::Radiosity start);

/// Loads and saves what PovOptions::radiosity_file says, if the scene has radiosity. Errors: InputError.
void use_radiosity_file(BuildContext& context);

/// Reads an object's own `radiosity { importance … }`, which says how many of the rays that meet it are worth
/// following: all are.
void read_importance(BuildContext& context, const Block& block);

}  // namespace sundog::pov
