// SPDX-License-Identifier: Apache-2.0
// Density files (POV-Ray reference, section 3.4.7.1.8 "Density File Pattern").
#pragma once

#include <memory>

#include "import/pov/build_items.h"
#include "scene/pattern.h"

namespace sundog::pov {

/// Takes the name of a df3 file and reads it. A missing or damaged file is a warning and null: 0 everywhere.
std::shared_ptr<const scene::DensityGrid> read_density_file(ItemReader& items);

}  // namespace sundog::pov
