// SPDX-License-Identifier: Apache-2.0
// Where in and around a pixel its samples go. A pixel's value is the mean of its samples' radiance times their weights:
// samples are drawn from the reconstruction filter itself (Ernst, Stamminger and Greiner, Filter Importance Sampling,
// 2006), so pixels share none and can have different numbers of them.
#ifndef SUNDOG_KERNEL_CAMERAS_PIXEL_SAMPLES_H
#define SUNDOG_KERNEL_CAMERAS_PIXEL_SAMPLES_H

#include "kernel/math.h"
#include "kernel/sequences.h"

KERNEL_BEGIN

struct PixelSample {
    real x;  ///< In pixels from the pixel's left edge, and
    real y;  ///< from its upper one.
    real weight;
};

/// Number `index` of the R2 sequence (Roberts 2018), which fills the square evenly for any count; number 0 is its
/// middle.
FN vec2 r2_sample(uint index) {
    uint x = 0x80000000u + index * 0xc13fa9a9u;
    uint y = 0x80000000u + index * 0x91e10da5u;
    return vec2(float(x >> 8u) * 5.9604645e-8f, float(y >> 8u) * 5.9604645e-8f);
}

/// How much of |filter| lies between its middle and x of its radius, as a share of all on one side; x in [0, 1].
FN real filter_share(uint pixel_filter, real x) {
    if (pixel_filter == FILTER_TENT) return x * (2.0f - x);
    if (pixel_filter == FILTER_GAUSSIAN) {
        // erf(3x / sqrt(2)) by Abramowitz and Stegun, 7.1.26; the last factor makes it 1 at x = 1.
        real z = x * 2.12132034f;
        real t = 1.0f / (1.0f + 0.3275911f * z);
        real series =
            t * (0.254829592f + t * (t * (1.421413741f + t * (t * 1.061405429f - 1.453152027f)) - 0.284496736f));
        return (1.0f - series * exp2_clamped(z * z * -1.44269504f)) * 1.00270714f;
    }
    if (pixel_filter == FILTER_MITCHELL) {
        // Integrals of the two cubics for B = C = 1/3 (Mitchell and Netravali, SIGGRAPH 1988, equation 8); the outer
        // one is below 0 from 8/7 on.
        real y = 2.0f * x;
        real inner = y * (0.88888889f + y * y * (0.29166667f * y - 0.66666667f));
        real outer = y * (1.77777778f + y * (y * (0.66666667f - 0.097222222f * y) - 1.66666667f)) - 0.16666667f;
        return select(y <= real(1.0f), inner, select(y <= real(1.14285714f), outer, 1.03498542f - outer)) * 1.86920981f;
    }
    if (pixel_filter == FILTER_BLACKMAN_HARRIS) {
        // The four-term window's integral (Harris, Proceedings of the IEEE 66, 1978).
        real s = sine(x * 3.14159265f);
        real c = cosine(x * 3.14159265f);
        return x + s * (0.43324748f + c * 0.12535420f + (3.0f - 4.0f * s * s) * 0.0034544571f);
    }
    return x;
}

/// Where a filter's |values| reach the share u from its left end, in radii from its middle.
FN real filter_place(uint pixel_filter, real u) {
    real signed_share = 2.0f * u - 1.0f;
    if (pixel_filter == FILTER_BOX) return signed_share;
    real share = abs(signed_share);
    real place;
    if (pixel_filter == FILTER_TENT) {
        place = 1.0f - sqrt(max(1.0f - share, real(0.0f)));
    } else {
        // Halved until it is nearly straight, then straight.
        real low = real(0.0f);
        real high = real(1.0f);
        real share_low = real(0.0f);
        real share_high = real(1.0f);
        for (uint i = 0u; i < 7u; i = i + 1u) {
            real middle = (low + high) * 0.5f;
            real share_middle = filter_share(pixel_filter, middle);
            mask beyond = share_middle < share;
            low = select(beyond, middle, low);
            share_low = select(beyond, share_middle, share_low);
            high = select(beyond, high, middle);
            share_high = select(beyond, share_high, share_middle);
        }
        place = low + (high - low) * ((share - share_low) / max(share_high - share_low, real(1e-10f)));
        place = clamp(place, low, high);
    }
    return select(signed_share < real(0.0f), -place, place);
}

/// A place in the pixel's square as one that is spread as the filter says.
FN PixelSample filtered_sample(PixelSampling sampling, PixelSample result) {
    if (sampling.pixel_filter == FILTER_PIXEL) return result;
    real across = filter_place(sampling.pixel_filter, result.x);
    real down = filter_place(sampling.pixel_filter, result.y);
    result.x = 0.5f + across * sampling.radius;
    result.y = 0.5f + down * sampling.radius;
    if (sampling.pixel_filter == FILTER_MITCHELL) {
        // The filter's sign, times the integral of its absolute value.
        real wx = select(abs(across) > real(0.57142857f), real(-1.06997085f), real(1.06997085f));
        real wy = select(abs(down) > real(0.57142857f), real(-1.06997085f), real(1.06997085f));
        result.weight = wx * wy;
    }
    return result;
}

/// Sample `index` of pixel (x, y).
FN PixelSample pixel_sample(PixelSampling sampling, word x, word y, uint index) {
    PixelSample result;
    result.weight = real(1.0f);
    uint cells = max(sampling.cells, 1u);
    // Grids begin in the middle, for those of an odd number of cells on a side.
    uint cell = (index + cells * cells / 2u) % (cells * cells);
    if (sampling.pattern == SAMPLES_R2) {
        vec2 place = r2_sample(index);
        result.x = real(place.x);
        result.y = real(place.y);
    } else if (sampling.pattern == SAMPLES_REGULAR) {
        result.x = real((float(cell % cells) + 0.5f) / float(cells));
        result.y = real((float(cell / cells) + 0.5f) / float(cells));
    } else {
        word pixel = hash_word(hash_word(x) + y);
        if (sampling.pattern == SAMPLES_JITTERED) {
            word bits = hash_word(pixel + word(index));
            result.x = (real(float(cell % cells)) + unit_from_word(bits)) * (1.0f / float(cells));
            result.y = (real(float(cell / cells)) + unit_from_word(hash_word(bits))) * (1.0f / float(cells));
        } else {
            // Blocks of samples, each with a scrambling of its own.
            uint block_size = sampling.cells == 0u ? 0xffffffffu : sampling.cells;
            uint number = index % block_size;
            word seed = hash_word(pixel + word(index / block_size));
            result.x = unit_from_word(owen_scrambled(word(number), seed));
            result.y = unit_from_word(owen_scrambled(sobol_second_reversed(word(number)), hash_word(seed)));
        }
    }
    return filtered_sample(sampling, result);
}

KERNEL_END

#endif
