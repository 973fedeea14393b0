// SPDX-License-Identifier: Apache-2.0
// Patterns and what modifies them (POV-Ray reference, section 3.4.7 "Pattern").
#pragma once

#include <memory>
#include <optional>

#include "import/pov/build_items.h"
#include "scene/pigment.h"

namespace sundog::pov {

/// How many entries a pattern that chooses from a list takes (checker 2, …); 0 for fields.
std::size_t choice_count(scene::Pattern::Kind kind);

/// A pattern while its block is read. Transformations are kept apart: they belong to the whole block.
struct PatternParts {
    scene::Pattern pattern;
    bool given = false;  ///< A pattern keyword was among the items.
    Affine3d texture_from_pattern;
};

/// Takes one pattern keyword with its parameters, one modifier (frequency, sine_wave, turbulence, warp, …) or one
/// transformation, if one follows. Kinds and modifiers that aren't drawn yet are kept, with one warning for each.
bool read_pattern_item(ItemReader& items, PatternParts& parts);

}  // namespace sundog::pov
