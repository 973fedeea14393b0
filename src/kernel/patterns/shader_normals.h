// SPDX-License-Identifier: Apache-2.0
// What the normals quilted and facets add, for shaders: the CPU asks the host (fields/host_normals.cpp).
#ifndef SUNDOG_KERNEL_PATTERNS_SHADER_NORMALS_H
#define SUNDOG_KERNEL_PATTERNS_SHADER_NORMALS_H

#include "kernel/patterns/shader_fields.h"

KERNEL_BEGIN

/// Seams whose slopes grow towards the corners of cells.
FN real3 quilted_offset(real3 p, float control0, float control1) {
    real3 d = from_cell_middle(p);
    return d * (1.73205081f * quilted_curve(control0, control1, length(d)));
}

/// Flat pieces: of the normal's direction itself if they have a size, else of the point p.
FN real3 facets_offset(real3 p, real3 normal, float coords, float size) {
    real3 from = p * 10.0f;  // cells in a unit
    if (size > 0.0f) from = normal * (1.0f / size);
    // The nearest of points that are strewn one a cell.
    real3 home = real3(floor(from.x), floor(from.y), floor(from.z));
    real nearest = 1.0e9f;
    real3 place = from;
    word nearest_hash = 0u;
    for (uint i = 0u; i < 27u; i = i + 1u) {
        real3 cell = home + real3(float(i % 3u) - 1.0f, float(i / 3u % 3u) - 1.0f, float(i / 9u) - 1.0f);
        word hash = cell_hash(cell, 0x17u);
        real3 strewn = cell + random_vector(hash) * 0.5f + real3(0.5f);
        real3 offset = strewn - from;
        real measure = dot(offset, offset);
        if (measure < nearest) {
            nearest = measure;
            place = strewn;
            nearest_hash = hash;
        }
    }
    if (size > 0.0f) return normalize(place) - normal;
    return random_vector(hash_word(nearest_hash)) * (0.42f * coords);
}

KERNEL_END

#endif
