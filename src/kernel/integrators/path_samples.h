// SPDX-License-Identifier: Apache-2.0
// Which numbers a pixel's paths are drawn by, and what they bring to the picture.
#ifndef SUNDOG_KERNEL_INTEGRATORS_PATH_SAMPLES_H
#define SUNDOG_KERNEL_INTEGRATORS_PATH_SAMPLES_H

#include "kernel/cameras/pixel_samples.h"
#include "kernel/integrators/path.h"

KERNEL_BEGIN

/// The hash of a pixel by which its paths' numbers are scrambled.
FN word pixel_hash(SCENE word x, word y) { return hash_word(hash_word(x) + y + hash_word(word(FRAME.seed))); }

/// Of samples whose numbers differ in bits above these, paths of a pixel are scrambled anew.
FN uint block_bits(PixelSampling sampling) {
    bool in_blocks = sampling.pattern == SAMPLES_SOBOL && sampling.cells > 1u;
    if (!in_blocks || (sampling.cells & (sampling.cells - 1u)) != 0u) return 32u;
    uint bits = 0u;
    while ((sampling.cells >> bits) > 1u) bits = bits + 1u;
    return bits;
}

/// Path number `index` of a pixel, by its hash and block_bits().
FN PathSample path_sample(word pixel, word index, uint bits) {
    PathSample draws;
    draws.pixel = pixel;
    draws.index = index;
    if (bits < 32u) {
        draws.pixel = hash_word(pixel + (index >> bits));
        draws.index = index & word((1u << bits) - 1u);
    }
    return draws;
}

/// Where in and around its pixel a path begins.
FN PixelSample path_place(SCENE PathSample draws) {
    real2 place = sample_pair(draws, word(0u));
    PixelSample at;
    at.x = place.x;
    at.y = place.y;
    at.weight = real(1.0f);
    return filtered_sample(FRAME.sampling, at);
}

/// What a path brought, as linear light.
FN real3 path_light(SCENE real3 radiance) {
    if (FRAME.most_radiance > 0.0f) {
        real most = largest(radiance);
        radiance = radiance * min(real(FRAME.most_radiance) / max(most, real(1e-30f)), real(1.0f));
    }
    return linear_light(SCENE_ radiance);
}

KERNEL_END

#endif
