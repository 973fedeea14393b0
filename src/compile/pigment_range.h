// SPDX-License-Identifier: Apache-2.0
// Bounds of what pigments show over boxes: for media, whose densities they are.
#pragma once

#include <map>
#include <memory>
#include <span>

#include "compile/noise_range.h"
#include "scene/scene.h"

namespace sundog {

namespace fields {
class FunctionEvaluator;
}

/// Of red, green and blue.
using ColorRange = std::array<Range, 3>;

/// A pigment made ready. Immutable: any number of threads may ask at once.
class PigmentRange {
public:
    /// The pigment must outlive it; images are copied from `textures` where functions ask for them.
    PigmentRange(const scene::Pigment& pigment, std::span<const scene::Texture> textures);

    /// What its colours are within at all points of a box, as the kernel computes them. It is tight where the pattern
    /// is one that can be bounded there (by distances, noise, functions, grids), with its turbulence; over large boxes
    /// and for others it is what all entries of the map are within.
    [[nodiscard]] ColorRange over(const RangeBox& box) const { return colors_over(pigment_, box); }
    /// About how many sums of noise a point takes; 1 for patterns without any.
    [[nodiscard]] int cost() const { return cost_of(pigment_); }

private:
    void prepare(const scene::Pigment& pigment, std::span<const scene::Texture> textures);
    [[nodiscard]] ColorRange colors_over(const scene::Pigment& pigment, const RangeBox& box) const;
    [[nodiscard]] ColorRange entries_over(const scene::Pigment& pigment, const RangeBox& box) const;
    [[nodiscard]] Range value_over(const scene::Pattern& pattern, const RangeBox& box) const;
    [[nodiscard]] Range field_over(const scene::Pattern& pattern, const RangeBox& at) const;
    [[nodiscard]] Range function_over(const scene::Pattern& pattern, const RangeBox& at) const;
    [[nodiscard]] static int cost_of(const scene::Pigment& pigment);

    const scene::Pigment& pigment_;
    std::map<const scene::Function*, std::shared_ptr<const fields::FunctionEvaluator>> functions_;
};

}  // namespace sundog
