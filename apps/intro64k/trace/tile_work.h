// SPDX-License-Identifier: Apache-2.0
// The picture, its tiles, and what a thread needs to draw one.
#pragma once

#include "trace/sample.h"

namespace sundog::intro {

/// How much is traced.
struct Quality {
    bool refinement;    ///< false: every pixel's corners are traced.
    bool shows_traced;  ///< Paints traced places white.
    float tolerance;    ///< How far neighbours may differ before what lies between them is traced; about 1.
};

/// A picture in memory: 0xRRGGBB, row by row from the top.
struct Picture {
    uint* pixels;
    uint width, height;
    uint pitch;  ///< Pixels from one row to the next.
};

inline constexpr uint kTileSide = 64;
inline constexpr uint kSpotsAcross = kTileSide + 1;

/// A square whose left upper corner is at a spot.
struct Square {
    Spot at;
};

/// Numbers of the solids that rays may meet.
struct Candidates {
    uint count;
    unsigned char numbers[kMaxSolids];
};

/// What one thread needs to draw a tile.
struct TileWork {
    Sample samples[kSpotsAcross * kSpotsAcross + 32];
    unsigned char known[kSpotsAcross * kSpotsAcross];
    unsigned char small[8][8];  ///< Squares of 8 in which something small may hide.
    Spot wanted[kSpotsAcross * kSpotsAcross + 32];
    Square squares[2][kTileSide * kTileSide];
    Candidates eye, all;
    uint wanted_count;
    Counts counts;
};

}  // namespace sundog::intro
