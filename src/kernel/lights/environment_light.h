// SPDX-License-Identifier: Apache-2.0
// Directions towards the environment, drawn by its light.
#ifndef SUNDOG_KERNEL_LIGHTS_ENVIRONMENT_LIGHT_H
#define SUNDOG_KERNEL_LIGHTS_ENVIRONMENT_LIGHT_H

#include "kernel/atmosphere/environment.h"

KERNEL_BEGIN

/// Number `which` of cell `cell`, as Environment::first_cell has them.
FN real environment_cell(SCENE word cell, uint which) {
    return GET(tables, word(FRAME.environment.first_cell + which) + cell * word(3u));
}

/// Density over solid angle with which environment_direction() gives a direction.
FN real environment_density(SCENE real3 direction) {
    real sin_axis;
    real2 place = environment_place(SCENE_ direction, sin_axis);
    float w = float(FRAME.environment.cells_wide);
    float h = float(FRAME.environment.cells_high);
    word x = word_from_real(clamp(place.x * w, real(0.0f), real(w - 1.0f)));
    word y = word_from_real(clamp(place.y * h, real(0.0f), real(h - 1.0f)));
    real density = environment_cell(SCENE_ y * word(FRAME.environment.cells_wide) + x, 2u);
    return density / max(sin_axis, real(1e-6f));
}

/// A direction towards a cell that is drawn by its light, and any place in it.
FN real3 environment_direction(SCENE real2 u, OUT(real) density) {
    uint w = FRAME.environment.cells_wide;
    uint h = FRAME.environment.cells_high;
    float count = float(w) * float(h);
    real scaled = u.x * count;
    real whole = min(floor(scaled), real(count - 1.0f));
    word slot = word_from_real(whole);
    real rest = scaled - whole;
    real keep = environment_cell(SCENE_ slot, 0u);
    mask keeps = rest < keep;
    word chosen = select(keeps, slot, as_word(environment_cell(SCENE_ slot, 1u)));
    // What is left of the number says where across the cell.
    real across = select(keeps, rest / max(keep, real(1e-10f)), (rest - keep) / max(1.0f - keep, real(1e-10f)));
    word row = word_from_real(floor((real_from_word(chosen) + 0.5f) * (1.0f / float(w))));
    word column = chosen - row * word(w);
    real place_x = (real_from_word(column) + clamp(across, real(0.0f), real(1.0f))) * (1.0f / float(w));
    real place_y = (real_from_word(row) + u.y) * (1.0f / float(h));
    real azimuth = (place_x - 0.5f) * 6.28318531f;
    real axis = place_y * 3.14159265f;
    real sin_axis = sine(axis);
    density = environment_cell(SCENE_ chosen, 2u) / max(sin_axis, real(1e-6f));
    return real3(FRAME.environment.up) * cosine(axis) +
           (real3(FRAME.environment.middle) * cosine(azimuth) + real3(FRAME.environment.right) * sine(azimuth)) *
               sin_axis;
}

KERNEL_END

#endif
