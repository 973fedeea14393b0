// SPDX-License-Identifier: Apache-2.0
// What surrounds the objects, and global_settings (POV-Ray reference, sections 3.4.1 and 3.4.3).
#pragma once

#include "import/pov/build_items.h"

namespace sundog::pov {

void read_background(BuildContext& context, const Block& block);
void read_fog(BuildContext& context, const Block& block);
void read_rainbow(BuildContext& context, const Block& block);
void read_sky_sphere(BuildContext& context, const Block& block);
void read_global_settings(BuildContext& context, const Block& block);

}  // namespace sundog::pov
