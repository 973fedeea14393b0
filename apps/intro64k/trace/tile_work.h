// SPDX-License-Identifier: Apache-2.0
// The picture, its tiles, and what a thread needs to draw one.
#pragma once

#include "sampling/traced_grid.h"
#include "stage/world.h"

namespace sundog::intro {

/// How much is traced.
struct Quality {
    bool refinement;    ///< false: the corners of all pixels are traced.
    bool shows_traced;  ///< Paints traced points white.
    float tolerance;    ///< As sampling::RefinementQuality has it.
};

/// A picture in memory: 0xRRGGBB, row by row from the top.
struct Picture {
    uint* pixels;
    uint width, height;
    uint pitch;  ///< Pixels from one row to the next.
};

inline constexpr uint kTileSide = sampling::kRefinedTileSide;
inline constexpr uint kPointsAcross = sampling::TracedGrid::kPointsAcross;

/// Numbers of the solids that rays may meet.
struct Candidates {
    uint count;
    unsigned char numbers[kMaxSolids];
};

/// What was traced.
struct Counts {
    unsigned long long rays, points;
};

/// What one thread needs to draw a tile. A pixel is the square between four points. Of each traced point: what
/// sampling::TracedGrid remembers (light: radiance that no texture dims; shade: light on the texture), and
struct TileWork {
    sampling::TracedGrid grid;
    sampling::Float4 tones[kPointsAcross * kPointsAcross];   ///< its colour as the screen gets it, 0 to 255,
    sampling::Float4 places[kPointsAcross * kPointsAcross];  ///< its place in its texture and 1, all over its depth,
    unsigned char small[8][8];                               ///< Squares of 8 in which something small may hide.
    sampling::TilePlace squares[2][kTileSide * kTileSide / 4];
    sampling::TilePlace divided[kTileSide * kTileSide / 4];  ///< Squares of 2 of whose pixels each has its own colour.
    Candidates eye, all;
    Counts counts;
};

}  // namespace sundog::intro
