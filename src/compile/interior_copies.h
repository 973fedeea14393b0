// SPDX-License-Identifier: Apache-2.0
// Which objects may share an interior's number, and which must not.
//
// Rays keep a list of the interiors that they are in, by number: one that is in the list is left, any other is entered
// (kernel/materials/interior.h). So two objects of one glass that reach into each other need two numbers for it.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"

namespace sundog {

struct InteriorCopies {
    /// For each object of the scene, what is added to the numbers of its interiors (kernel::Geometry::interior_copy);
    /// empty: 0 for all.
    std::vector<std::uint32_t> of_object;
    /// How many numbers in a row an interior needs, by PatternedSurface::interior_number; one where it isn't listed.
    std::unordered_map<std::uint32_t, std::uint32_t> counts;

    [[nodiscard]] std::uint32_t of(std::size_t object) const { return of_object.empty() ? 0 : of_object[object]; }
    [[nodiscard]] std::uint32_t count(std::uint32_t interior_number) const {
        const auto found = counts.find(interior_number);
        return found == counts.end() ? 1 : found->second;
    }
};

/// Objects whose boxes overlap get different copies, unless they have their interior from one `interior_owner`. Small
/// ones that lie apart share copies, so that a million bubbles stay one geometry. Beyond kernel::MAX_INTERIORS in all,
/// copies are dealt out again from the first.
InteriorCopies interior_copies(const scene::Scene& scene);

}  // namespace sundog
