// SPDX-License-Identifier: Apache-2.0
// The tilings of POV-Ray's pattern `tiling` (its reference, section 3.4.7.1.28): periodic ones of the plane by convex
// tiles, as the kernel's OP_TILING reads them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sundog::fields {

/// A point or vector of the plane; its z is the scene's.
struct PlaneVec {
    double x = 0, z = 0;
};

/// A convex tile, its corners counter-clockwise (from x to z).
struct Tile {
    int type = 0;
    std::vector<PlaneVec> corners;
    /// Sides, by the numbers of their first corners, whose border is wider by 1 / cos 30 degrees.
    std::vector<std::size_t> flatter = {};
};

/// A tiling: its tiles, moved by all whole combinations of two periods, fill the plane.
struct Tiling {
    int types = 1;  ///< Of tiles: 0 .. types - 1.
    std::array<PlaneVec, 2> periods;
    double bevel = 0.5;  ///< Width of the border that all tiles have: the inradius of the smallest.
    std::vector<Tile> tiles;
};

constexpr int kPeriodicTilings = 24;
/// Tiling `number` (1 to kPeriodicTilings, as scenes name it), with tiles of unit sides.
Tiling periodic_tiling(int number);

/// The operands of OP_TILING, without the count of words that precedes them.
std::vector<std::uint32_t> tiling_words(const Tiling& tiling);

}  // namespace sundog::fields
