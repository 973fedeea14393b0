// SPDX-License-Identifier: Apache-2.0
// Finishes and interiors (POV-Ray reference, sections 3.4.6.3 "Finish" and 3.4.8.1 "Interior").
#pragma once

#include <string>

#include "import/pov/build_items.h"
#include "scene/pigment.h"

namespace sundog::pov {

/// A finish, with what finishes of before version 3.1 say of the interior.
struct FinishParts {
    scene::Finish finish;
    scene::Interior interior;
    bool has_interior = false;
};

/// The finish of a `finish { }`, changed from `start` as its items say.
FinishParts read_finish(BuildContext& context, const Block& block, FinishParts start);

/// A key for finishes: equal for equal ones.
std::string bytes_of(const scene::Finish& finish);

/// The interior of an `interior { }`.
scene::Interior read_interior(BuildContext& context, const Block& block);

}  // namespace sundog::pov
