// SPDX-License-Identifier: Apache-2.0
// POV-Ray's pattern `pavement` (its reference, section 3.4.7.1.18): the xz plane paved by tiles of up to six triangles,
// squares or hexagons of unit sides.
#pragma once

#include <string_view>

#include "scene/pattern.h"

namespace sundog::fields {

/// How tiles lie: cells repeat after (width, 0) and (shift, height). `borders` has a digit for each of them, rows of
/// width from z = 0 on: which of its sides are between two tiles.
/// Squares: 1 the left, 2 the lower one. Pairs of triangles, over x and the direction 60 degrees from it: 1 the left,
/// 2 the lower one, 4 the one between both. Hexagons, over the directions 30 and 90 degrees from x: 1, 2, 4 the three
/// lower ones, from the left.
struct Arrangement {
    int sides, tiles, pattern;
    int width, height, shift;
    std::string_view borders;
};
/// Nothing where there is no such pattern.
const Arrangement* find_arrangement(int sides, int tiles, int pattern);
/// A form's own; the first of its kind where it names none that there is.
const Arrangement& arrangement_of(const scene::PavementForm& form);
/// How many there are for tiles of so many cells with so many sides.
int arrangement_count(int sides, int tiles);

class Pavement {
public:
    /// A form that names no arrangement gets the first of its kind.
    explicit Pavement(const scene::PavementForm& form);
    /// 1 at the tiles' borders, falling to 0 within.
    [[nodiscard]] double at(double x, double z) const;
    /// Whether there are two tiles on both sides of the side of squares or triangles from a corner along an axis: 0: x,
    /// 1: z, or 60 degrees from x; 2: 120 degrees from x (triangles). Hexagons are six triangles.
    [[nodiscard]] bool border(int i, int j, int axis) const;

private:
    [[nodiscard]] unsigned borders_of(int i, int j) const;
    [[nodiscard]] bool border_towards(int i, int j, int direction) const;
    [[nodiscard]] bool is_corner(int i, int j) const;
    [[nodiscard]] double in_triangle(double x, double z) const;
    [[nodiscard]] double in_square(double x, double z) const;

    scene::PavementForm form_;
    const Arrangement* tiles_;
};

}  // namespace sundog::fields
