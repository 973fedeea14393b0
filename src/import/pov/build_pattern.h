// SPDX-License-Identifier: Apache-2.0
// Patterns and what modifies them (POV-Ray reference, section 3.4.7 "Pattern").
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "import/pov/build_items.h"
#include "scene/pigment.h"

namespace sundog::pov {

/// How many entries a pattern that chooses from a list takes (checker 2, …); 0 for fields.
std::size_t choice_count(scene::Pattern::Kind kind);

/// A warp where its block was read, and the transformations since the one before.
struct WrittenWarp {
    Affine3d moved_before;
    scene::Warp warp;
};

/// A pattern while its block is read. Transformations and warps are kept apart: they belong to the whole block.
struct PatternParts {
    scene::Pattern pattern;
    bool given = false;                 ///< A pattern keyword was among the items.
    std::shared_ptr<const Block> list;  ///< object: what its block says behind the object: the entries.
    std::vector<WrittenWarp> warps;     ///< In the order of the file.
    Affine3d texture_from_pattern;      ///< After the last warp.
};

/// Takes one pattern keyword with its parameters, one modifier (frequency, sine_wave, turbulence, warp, …) or one
/// transformation, if one follows. Kinds that aren't drawn yet are kept, with one warning for each.
bool read_pattern_item(ItemReader& items, PatternParts& parts);

/// Calls move(old_from_new) and bend(warp) in the order in which they were written.
template <class Move, class Bend>
void place(const PatternParts& parts, Move move, Bend bend) {
    for (const WrittenWarp& written : parts.warps) {
        move(inverse(written.moved_before));
        bend(written.warp);
    }
    move(inverse(parts.texture_from_pattern));
}

}  // namespace sundog::pov
