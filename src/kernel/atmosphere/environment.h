// SPDX-License-Identifier: Apache-2.0
// Light from infinitely far away, as a picture of all directions: rows by height, columns by direction around it.
#ifndef SUNDOG_KERNEL_ATMOSPHERE_ENVIRONMENT_H
#define SUNDOG_KERNEL_ATMOSPHERE_ENVIRONMENT_H

#include "kernel/math.h"

KERNEL_BEGIN

/// Where in the environment's picture a unit direction lies: (0, 0) to (1, 1), from its upper left corner; the last
/// parameter is the sine of the angle to its axis.
FN real2 environment_place(SCENE real3 direction, OUT(real) sin_axis) {
    real up = dot(direction, real3(FRAME.environment.up));
    real ahead = dot(direction, real3(FRAME.environment.middle));
    real aside = dot(direction, real3(FRAME.environment.right));
    sin_axis = sqrt(max(ahead * ahead + aside * aside, real(0.0f)));
    return real2(0.5f + angle_of(aside, ahead) * 0.159154943f, angle_of(sin_axis, up) * 0.318309886f);
}

/// One of its pixels, row by row.
FN real3 environment_pixel(SCENE word number) {
    word at = word(ENVIRONMENT_FIRST) + number * word(3u);
    return real3(GET(tables, at), GET(tables, at + word(1u)), GET(tables, at + word(2u)));
}

/// Its radiance there, between the middles of pixels.
FN real3 environment_radiance(SCENE real3 direction) {
    real sin_axis;
    real2 place = environment_place(SCENE_ direction, sin_axis);
    float w = float(FRAME.environment.width);
    float h = float(FRAME.environment.height);
    real x = place.x * w - 0.5f;
    real y = clamp(place.y * h - 0.5f, real(0.0f), real(h - 1.0f));
    real x0 = floor(x);
    real y0 = min(floor(y), real(max(h - 2.0f, 0.0f)));
    real fx = x - x0;
    real fy = y - y0;
    // Around the horizon it goes on.
    word left = word_from_real(select(x0 < real(0.0f), x0 + w, x0));
    word right = word_from_real(select(x0 + 1.0f >= real(w), x0 + 1.0f - w, x0 + 1.0f));
    word top = word_from_real(y0) * word(FRAME.environment.width);
    word bottom = top + word(FRAME.environment.height > 1u ? FRAME.environment.width : 0u);
    real3 upper = mix(environment_pixel(SCENE_ top + left), environment_pixel(SCENE_ top + right), fx);
    real3 lower = mix(environment_pixel(SCENE_ bottom + left), environment_pixel(SCENE_ bottom + right), fx);
    return mix(upper, lower, fy) * real(FRAME.environment.gain);
}

KERNEL_END

#endif
