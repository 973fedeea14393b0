// SPDX-License-Identifier: Apache-2.0
// Tilings of the xz plane by convex tiles.
#ifndef SUNDOG_KERNEL_PATTERNS_TILING_H
#define SUNDOG_KERNEL_PATTERNS_TILING_H

#include "kernel/patterns/code.h"

KERNEL_BEGIN

/// (type + share of the bevel) / types for the tile that a point lies in: the share is 0 from the bevel inwards, 1 at
/// the tile's sides. Words of `code` from `at` on: the periods' coordinates of the plane (2 rows of 2), the periods (x,
/// z of each), the number of types, one over the bevel's width, how many tiles reach into the cell that the periods
/// span, and of each its type, its number of sides, and their outward normals (x, z) and distances from the origin.
FN real tiling_value(SCENE uint at, real3 p) {
    real u = fraction(p.x * code_float(SCENE_ at) + p.z * code_float(SCENE_ at + 1u));
    real v = fraction(p.x * code_float(SCENE_ at + 2u) + p.z * code_float(SCENE_ at + 3u));
    real x = u * code_float(SCENE_ at + 4u) + v * code_float(SCENE_ at + 6u);
    real z = u * code_float(SCENE_ at + 5u) + v * code_float(SCENE_ at + 7u);
    float per_type = 1.0f / code_float(SCENE_ at + 8u);
    float per_bevel = code_float(SCENE_ at + 9u);
    uint count = AT(code, at + 10u);
    uint tile = at + 11u;
    // Tiles don't overlap: the one that the point lies deepest in is its own, whatever is rounded.
    real depth = real(-1.0e9f);
    real type = real(0.0f);
    for (uint i = 0u; i < count; i = i + 1u) {
        uint sides = AT(code, tile + 1u);
        real inside = real(1.0e9f);
        for (uint side = 0u; side < sides; side = side + 1u) {
            uint line = tile + 2u + side * 3u;
            real along = x * code_float(SCENE_ line) + z * code_float(SCENE_ line + 1u);
            inside = min(inside, code_float(SCENE_ line + 2u) - along);
        }
        type = select(inside > depth, real(float(AT(code, tile))), type);
        depth = max(depth, inside);
        tile = tile + 2u + sides * 3u;
    }
    return (type + 1.0f - clamp(depth * per_bevel, real(0.0f), real(1.0f))) * per_type;
}

KERNEL_END

#endif
