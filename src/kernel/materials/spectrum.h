// SPDX-License-Identifier: Apache-2.0
// Colours of places in the spectrum, 0 (violet) to 1 (red).
#ifndef SUNDOG_KERNEL_MATERIALS_SPECTRUM_H
#define SUNDOG_KERNEL_MATERIALS_SPECTRUM_H

#include "kernel/math.h"

KERNEL_BEGIN

/// Share of a colour's light between the violet end of the spectrum and a place in it, 0 to 1: a parabola around
/// `middle`. The parabolas were fitted to povray's pictures.
FN float spectrum_share(float place, float middle, float reach) {
    float x = min(max((place - middle) / reach, -1.0f), 1.0f);
    return 0.5f + 0.75f * x - 0.25f * x * x * x;
}

/// The same of red, green and blue.
FN vec3 spectrum_shares(float place) {
    float red = 0.959f * spectrum_share(place, 0.783f, 0.24f) + 0.041f * spectrum_share(place, 0.078f, 0.097f);
    return vec3(red, spectrum_share(place, 0.582f, 0.26f), spectrum_share(place, 0.258f, 0.279f));
}

/// The colour of sample `index` of `count` that the spectrum is cut into; they add up to white.
FN vec3 spectrum_color(uint index, uint count) {
    vec3 before = index == 0u ? vec3(0.0f) : spectrum_shares(float(index) / float(count));
    vec3 after = index + 1u == count ? vec3(1.0f) : spectrum_shares(float(index + 1u) / float(count));
    return after - before;
}

/// Density of a parabola around `middle` at a place; over all places it adds up to 1.
FN real spectrum_density(real place, float middle, float reach) {
    real x = (place - middle) * (1.0f / reach);
    return max(1.0f - x * x, real(0.0f)) * (0.75f / reach);
}

/// The colour of light at one place, of which the mean over all places is white.
FN real3 spectrum_light(real place) {
    real red = 0.959f * spectrum_density(place, 0.783f, 0.24f) + 0.041f * spectrum_density(place, 0.078f, 0.097f);
    return real3(red, spectrum_density(place, 0.582f, 0.26f), spectrum_density(place, 0.258f, 0.279f));
}

KERNEL_END

#endif
