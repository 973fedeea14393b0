// SPDX-License-Identifier: Apache-2.0
// Sobol's sequence in two dimensions, scrambled by Owen's method, and pairs of it for the many choices of a path.
#ifndef SUNDOG_KERNEL_SEQUENCES_H
#define SUNDOG_KERNEL_SEQUENCES_H

#include "kernel/hash.h"

KERNEL_BEGIN

/// The upper 24 bits of a word as a number in [0, 1).
FN real unit_from_word(word bits) { return real_from_word(bits >> 8u) * 5.9604645e-8f; }

/// The second coordinate of Sobol's sequence (1967) as 32 bits after the binary point, in reverse order; the first is
/// `index` itself, likewise. Its matrix is Pascal's triangle modulo 2: bit i is the sum of those bits of the index
/// whose numbers have all the bits of i (Lucas 1878), which are five sums of halves.
FN word sobol_second_reversed(word index) {
    index = index ^ ((index >> 1u) & word(0x55555555u));
    index = index ^ ((index >> 2u) & word(0x33333333u));
    index = index ^ ((index >> 4u) & word(0x0f0f0f0fu));
    index = index ^ ((index >> 8u) & word(0x00ff00ffu));
    return index ^ ((index >> 16u) & word(0x0000ffffu));
}

/// Owen's scrambling of a coordinate whose bits are given in reverse order (Burley, Practical Hash-based Owen
/// Scrambling, JCGT 2020, section 4): whether a bit flips depends on the seed and on all bits of more worth.
FN word owen_scrambled(word reversed_bits, word seed) {
    word x = reversed_bits + seed;
    x = x ^ (x * word(0x6c50b47cu));
    x = x ^ (x * word(0xb82f1e52u));
    x = x ^ (x * word(0xc7afe638u));
    x = x ^ (x * word(0x8d22f6e6u));
    return reversed(x);
}

/// Which of a pixel's paths a choice is made for.
struct PathSample {
    word pixel;  ///< A hash of the pixel's place.
    word index;  ///< The path's number in its pixel.
};

/// Two numbers in [0, 1) for choice number `dimension` of a path: a pixel's paths have well spread ones for each
/// choice, in an order of its own, so that choices don't know of each other (Burley 2020, section 5).
FN real2 sample_pair(PathSample path, word dimension) {
    word seed = hash_word(path.pixel + dimension);
    word shuffled = owen_scrambled(reversed(path.index), seed);
    return real2(unit_from_word(owen_scrambled(shuffled, hash_word(seed))),
                 unit_from_word(owen_scrambled(sobol_second_reversed(shuffled), hash_word(seed + word(1u)))));
}

/// A number in [0, 1) for choice number `dimension`, as random as a hash is.
FN real sample_hash(PathSample path, word dimension) {
    return unit_from_word(hash_word(hash_word(path.pixel + dimension) + path.index));
}

KERNEL_END

#endif
