// SPDX-License-Identifier: Apache-2.0
// Grids of densities over the unit cube (POV-Ray's reference, section 3.4.7.1.8 "Density File"), for shaders: the CPU
// asks the host, which computes them in double precision (fields/host_fields.cpp).
#ifndef SUNDOG_KERNEL_PATTERNS_DENSITY_GRID_H
#define SUNDOG_KERNEL_PATTERNS_DENSITY_GRID_H

#include "kernel/patterns/code.h"

KERNEL_BEGIN

/// i modulo n, for whole numbers.
FN real wrapped_number(real i, real n) { return i - floor(i / n) * n; }

/// How much the k-th of the voxels that count along an axis has of the value at t (0..1) between two of them: one
/// voxel, two, or four, through the middle two of which a cubic goes with slopes between their neighbours.
FN real voxel_share(uint interpolation, uint k, real t) {
    if (interpolation == 0u) return real(1.0f);
    if (interpolation == 1u) return k == 0u ? 1.0f - t : t;
    if (k == 0u) return ((2.0f - t) * t - 1.0f) * t * 0.5f;
    if (k == 1u) return ((3.0f * t - 5.0f) * t * t + 2.0f) * 0.5f;
    if (k == 2u) return ((4.0f - 3.0f * t) * t + 1.0f) * t * 0.5f;
    return (t - 1.0f) * t * t * 0.5f;
}

/// The density at p. Words of `code` from `at` on: the interpolation (0, 1 or 2), the numbers of voxels along x, y and
/// z (0: there is no grid), and where in `code` they are: two a word, from 0 to 65535, x running fastest.
FN real density_at(SCENE uint at, real3 p) {
    uint interpolation = AT(code, at);
    uint size_x = AT(code, at + 1u);
    uint size_y = AT(code, at + 2u);
    real3 size = real3(real(float(size_x)), real(float(size_y)), real(float(AT(code, at + 3u))));
    real3 zero = real3(real(0.0f));
    real3 one = real3(real(1.0f));
    mask inside = mask_and(mask_and(mask_and(p.x >= zero.x, p.x < one.x), mask_and(p.y >= zero.y, p.y < one.y)),
                           mask_and(mask_and(p.z >= zero.z, p.z < one.z), size.x * size.y * size.z > zero.x));
    if (!any_lane(inside)) return real(0.0f);
    real3 place = select(inside, p, zero) * size;
    real3 cell = real3(floor(place.x), floor(place.y), floor(place.z));
    real3 t = place - cell;
    uint count = interpolation == 2u ? 4u : interpolation + 1u;
    float first = interpolation == 2u ? -1.0f : 0.0f;
    real sum = real(0.0f);
    for (uint k = 0u; k < count * count * count; k = k + 1u) {
        uint x = k % count;
        uint y = k / count % count;
        uint z = k / (count * count);
        word voxel_x = word_from_real(wrapped_number(cell.x + (first + float(x)), size.x));
        word voxel_y = word_from_real(wrapped_number(cell.y + (first + float(y)), size.y));
        word voxel_z = word_from_real(wrapped_number(cell.z + (first + float(z)), size.z));
        word index = valid_index(inside, voxel_x + (voxel_y + voxel_z * word(size_y)) * word(size_x));
        word both = GET(code, word(AT(code, at + 4u)) + (index >> 1u));
        word value = select((index & word(1u)) == word(0u), both & word(65535u), both >> 16u);
        real share = voxel_share(interpolation, x, t.x) * voxel_share(interpolation, y, t.y) *
                     voxel_share(interpolation, z, t.z);
        sum = sum + share * (real_from_word(value) * (1.0f / 65535.0f));
    }
    return select(inside, clamp(sum, real(0.0f), real(1.0f)), real(0.0f));
}

KERNEL_END

#endif
