// SPDX-License-Identifier: Apache-2.0
// Draws a tile by grid refinement (sampling/traced_grid.h): squares of 8x8 pixels whose corners agree are filled,
// others are divided in four, down to pixels.
#pragma once

#include "trace/prepare.h"
#include "trace/tile.h"

namespace sundog::intro {

inline void paint_traced(const Picture& picture, const TileWork& work, uint tile_x, uint tile_y) {
    for (uint y = 0; y < kTileSide && tile_y + y < picture.height; ++y)
        for (uint x = 0; x < kTileSide && tile_x + x < picture.width; ++x)
            if (work.grid.is_wanted(static_cast<int>(x), static_cast<int>(y)))
                picture.pixels[(tile_y + y) * static_cast<std::size_t>(picture.pitch) + tile_x + x] = 0xffffff;
}

/// Asks for nine points: the corners of a square, the middles of its sides, and its own.
[[gnu::noinline]] inline void want_points(TileWork& work, uint x, uint y, uint half) {
    for (uint i = 0; i < 9; ++i) work.grid.want(static_cast<int>(x + i % 3 * half), static_cast<int>(y + i / 3 * half));
}

inline void draw_squares(const World& world, const Tables& tables, const Quality& quality, const Picture& picture,
                         TileWork& work, uint tile_x, uint tile_y) {
    // Numbers too small for a float's usual form are noughts: they can't be seen, and cost a hundred times as much.
    _mm_setcsr(_mm_getcsr() | 0x8040U);
    const View view{&world, &tables, static_cast<float>(picture.width), static_cast<float>(picture.height)};
    find_visible(world, picture, work, tile_x, tile_y);
    work.grid.clear();
    // Points' colours are kept in tones: no pixels are asked for.
    const sampling::TilePixels no_pixels{nullptr, 0, 0, 0};
    const sampling::RefinementQuality alike{quality.tolerance, 1};
    const PointTracer tracer{view, work, tile_x, tile_y};
    const uint across = min(kTileSide, picture.width - tile_x);
    const uint down = min(kTileSide, picture.height - tile_y);
    uint size = quality.refinement ? static_cast<uint>(sampling::kSquareSide) : 2u;
    uint count = 0;
    uint divided = 0;
    uint now = 0;
    for (uint y = 0; y < down; y += size)
        for (uint x = 0; x < across; x += size) {
            work.squares[now][count++] = {static_cast<unsigned char>(x), static_cast<unsigned char>(y)};
            for (uint i = 0; i < 4; ++i)
                work.grid.want(static_cast<int>(x + i % 2 * size), static_cast<int>(y + i / 2 * size));
        }
    for (; size > 1; size /= 2) {
        work.grid.trace_wanted(tracer, alike, no_pixels);
        uint next = 0;
        for (uint i = 0; i < count; ++i) {
            const sampling::TilePlace at = work.squares[now][i];
            const bool hides = work.small[at.y / 8][at.x / 8] != 0 && size > 2;
            const bool agrees = size > 2 ? work.grid.agree(at.x, at.y, static_cast<int>(size), alike)
                                         : quality.refinement && work.grid.same_outline(at.x, at.y, 2);
            if (agrees && !hides) {
                fill_square(view, picture, work, tile_x, tile_y, at, size);
                continue;
            }
            const uint half = size / 2;
            want_points(work, at.x, at.y, half);
            if (half == 1) {
                work.divided[divided++] = at;
                continue;
            }
            for (uint child = 0; child < 4; ++child)
                work.squares[1 - now][next++] = {static_cast<unsigned char>(at.x + (child & 1) * half),
                                                 static_cast<unsigned char>(at.y + child / 2 * half)};
        }
        now = 1 - now;
        count = next;
    }
    work.grid.trace_wanted(tracer, alike, no_pixels);
    for (uint i = 0; i < divided; ++i) fill_divided(picture, work, tile_x, tile_y, work.divided[i]);
    work.counts.points += static_cast<uint>(work.grid.traced_count());
    if (quality.shows_traced) paint_traced(picture, work, tile_x, tile_y);
}

}  // namespace sundog::intro
