// SPDX-License-Identifier: Apache-2.0
// Draws a tile: squares of 8x8 pixels whose corners agree are filled, others are divided in four, down to pixels.
#pragma once

#include "trace/prepare.h"
#include "trace/tile.h"

INTRO_LANES_BEGIN

inline void paint_traced(const Picture& picture, const TileWork& work, uint tile_x, uint tile_y) {
    for (uint y = 0; y < kTileSide && tile_y + y < picture.height; ++y)
        for (uint x = 0; x < kTileSide && tile_x + x < picture.width; ++x)
            if (work.known[spot_index(x, y)] != 0) picture.pixels[(tile_y + y) * picture.pitch + tile_x + x] = 0xffffff;
}

inline void draw_squares(const World& world, const Tables& tables, const Quality& quality, const Picture& picture,
                         TileWork& work, uint tile_x, uint tile_y) {
    // Numbers too small for a float's usual form are noughts: they can't be seen, and cost a hundred times as much.
    _mm_setcsr(_mm_getcsr() | 0x8040U);
    const View view{&world, &tables, static_cast<float>(picture.width), static_cast<float>(picture.height)};
    find_visible(world, picture, work, tile_x, tile_y);
    for (unsigned char& known : work.known) known = 0;
    work.wanted_count = 0;
    // Squares beyond the picture's edge are left out; those that reach over it are whole.
    const uint across = min(kTileSide, picture.width - tile_x);
    const uint down = min(kTileSide, picture.height - tile_y);
    uint size = quality.refinement ? 8u : 1u;
    uint count = 0;
    uint now = 0;
    for (uint y = 0; y < down; y += size)
        for (uint x = 0; x < across; x += size) {
            work.squares[now][count++] = {{static_cast<unsigned char>(x), static_cast<unsigned char>(y)}};
            want(work, x, y);
            want(work, x + size, y);
            want(work, x, y + size);
            want(work, x + size, y + size);
        }
    for (;; size /= 2) {
        trace_wanted(view, work, tile_x, tile_y);
        uint next = 0;
        for (uint i = 0; i < count; ++i) {
            const Spot at = work.squares[now][i].at;
            const Corners corners = corners_of(work, at, size);
            const bool hides = size > 2 && work.small[at.y / 8][at.x / 8] != 0;
            if (!hides && corners_agree(corners, size, quality.tolerance)) {
                fill_square(view, picture, corners, tile_x + at.x, tile_y + at.y, size);
                continue;
            }
            if (size == 1) {
                work.squares[1 - now][next++] = {at};
                continue;
            }
            const uint half = size / 2;
            want(work, at.x + half, at.y);
            want(work, at.x, at.y + half);
            want(work, at.x + half, at.y + half);
            want(work, at.x + size, at.y + half);
            want(work, at.x + half, at.y + size);
            for (uint child = 0; child < 4; ++child)
                work.squares[1 - now][next++] = {{static_cast<unsigned char>(at.x + (child & 1) * half),
                                                  static_cast<unsigned char>(at.y + child / 2 * half)}};
        }
        now = 1 - now;
        count = next;
        if (size == 1) break;
    }
    fill_pixels(view, picture, work, work.squares[now], count, tile_x, tile_y);
    if (quality.shows_traced) paint_traced(picture, work, tile_x, tile_y);
}

INTRO_LANES_END
