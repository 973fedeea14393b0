// SPDX-License-Identifier: Apache-2.0
// Lattice noise (Perlin, An Image Synthesizer, SIGGRAPH 1985): a random value and a random gradient at every point of
// the integer lattice, blended by cubics. Random numbers are hashed, so there is no table and no period. Mean, spread
// and spectrum are those that POV-Ray 3.7's pictures show; its grain is its own.
#ifndef SUNDOG_KERNEL_PATTERNS_NOISE_H
#define SUNDOG_KERNEL_PATTERNS_NOISE_H

#include "kernel/hash.h"
#include "kernel/math.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// x - floor(x): in [0, 1).
FN real fraction(real x) { return x - floor(x); }

/// Bits 0..9 of a word as a number in [-1, 1].
FN real signed_unit(word bits) { return real_from_word(bits & word(1023u)) * 0.00195503421f - 1.0f; }

/// Three numbers in [-1, 1] of a hash.
FN real3 random_vector(word hash) {
    return real3(signed_unit(hash), signed_unit(hash >> 10u), signed_unit(hash >> 20u));
}

/// A random number in [0, 1) that belongs to a point or a direction and a number, so that pictures don't depend on
/// threads.
FN real random_at(real3 p, word number) {
    word bits = hash_word(hash_word(hash_word(as_word(p.x) + number) + as_word(p.y)) + as_word(p.z));
    return real_from_word(bits >> 8u) * 5.96046448e-8f;
}

// What a step along an axis adds to a lattice point's hash before it is mixed: large primes (Collet, xxHash, 2012).
const uint LATTICE_X = 2654435761u;
const uint LATTICE_Y = 2246822519u;
const uint LATTICE_Z = 3266489917u;
/// Which of all noises this is: one of which known scenes' terrains leave their cameras in the open.
const uint LATTICE_START = 190056u;

/// The hash of a lattice point of which the coordinates are multiplied by these numbers, the start added to z.
FN word mixed_hash(word x, word y, word z) { return hash_word(x ^ (y + z)); }
/// The hash of a lattice point.
FN word lattice_hash(word x, word y, word z) {
    return mixed_hash(x * word(LATTICE_X), y * word(LATTICE_Y), z * word(LATTICE_Z) + word(LATTICE_START));
}

/// One of four words that a lattice point's hash gives: the hash itself (noise_value()'s), and three that are
/// independent enough of it and each other (noise_vector()'s).
FN word lattice_word(word hash, uint number) {
    return number == 0u ? hash : hash * word(number == 1u ? LATTICE_X : number == 2u ? LATTICE_Y : LATTICE_Z);
}

/// A word's number `part`, of four, in [-1, 1) times LATTICE_SCALE: 0 to 2 are a gradient, 3 is a value. A higher
/// byte's number goes on in those below it: that takes no mask.
FN real lattice_part(word bits, uint part) { return real_from_word(bits << (8u * part)); }
const float LATTICE_SCALE = 2147483648.0f;

/// Where a point lies in the lattice.
struct LatticePlace {
    word x;       ///< Of the lattice point below, times LATTICE_X.
    word y;       ///< Times LATTICE_Y.
    word z;       ///< Times LATTICE_Z, plus LATTICE_START.
    real3 below;  ///< The point from there, each 0 to 1.
    real3 above;  ///< From the lattice point above, each -1 to 0.
    real3 share;  ///< What points above count for, along each axis.
};

/// Number of a lattice coordinate, from 0 up: whole floats are exact to 2^24.
FN word lattice_number(real cell) { return word_from_real(clamp(cell + 8388608.0f, real(0.0f), real(16777214.0f))); }

FN LatticePlace lattice_place(real3 p) {
    real3 cell = real3(floor(p.x), floor(p.y), floor(p.z));
    LatticePlace at;
    at.x = lattice_number(cell.x) * word(LATTICE_X);
    at.y = lattice_number(cell.y) * word(LATTICE_Y);
    at.z = lattice_number(cell.z) * word(LATTICE_Z) + word(LATTICE_START);
    real3 f = p - cell;
    at.below = f;
    at.above = f - real3(real(1.0f));
    at.share = f * f * (real3(real(3.0f)) - f * real(2.0f));
    return at;
}

FN real blended(real below, real above, real share) { return below + share * (above - below); }

/// What a lattice point adds, times LATTICE_SCALE: its gradient's slope at an offset and `value_share` of its value.
FN real lattice_noise(word bits, real x, real y, real z, float value_share) {
    real slope = lattice_part(bits, 0u) * x + lattice_part(bits, 1u) * y + lattice_part(bits, 2u) * z;
    return value_share == 0.0f ? slope : slope + lattice_part(bits, 3u) * value_share;
}

/// An edge of the cell along x, of which y and z are given: the sum there, times LATTICE_SCALE.
FN real lattice_edge(LatticePlace at, word y, word z, real off_y, real off_z, float value_share) {
    real below = lattice_noise(mixed_hash(at.x, y, z), at.below.x, off_y, off_z, value_share);
    real above = lattice_noise(mixed_hash(at.x + word(LATTICE_X), y, z), at.above.x, off_y, off_z, value_share);
    return blended(below, above, at.share.x);
}

/// Noise of mean 0 at p, lattice cells of size 1: gradients' slopes and `value_share` of values.
FN real lattice_sum(real3 p, float value_share) {
    LatticePlace at = lattice_place(p);
    word y = at.y + word(LATTICE_Y);
    word z = at.z + word(LATTICE_Z);
    real near_below = lattice_edge(at, at.y, at.z, at.below.y, at.below.z, value_share);
    real near_above = lattice_edge(at, y, at.z, at.above.y, at.below.z, value_share);
    real far_below = lattice_edge(at, at.y, z, at.below.y, at.above.z, value_share);
    real far_above = lattice_edge(at, y, z, at.above.y, at.above.z, value_share);
    real sum =
        blended(blended(near_below, near_above, at.share.y), blended(far_below, far_above, at.share.y), at.share.z);
    return sum * (1.0f / LATTICE_SCALE);
}

/// The slopes of a lattice point's words 1 to 3.
FN real3 lattice_slopes(word hash, real x, real y, real z) {
    return real3(lattice_noise(lattice_word(hash, 1u), x, y, z, 0.0f),
                 lattice_noise(lattice_word(hash, 2u), x, y, z, 0.0f),
                 lattice_noise(lattice_word(hash, 3u), x, y, z, 0.0f));
}
FN real3 blended3(real3 below, real3 above, real share) { return below + (above - below) * share; }
FN real3 lattice_edge3(LatticePlace at, word y, word z, real off_y, real off_z) {
    return blended3(lattice_slopes(mixed_hash(at.x, y, z), at.below.x, off_y, off_z),
                    lattice_slopes(mixed_hash(at.x + word(LATTICE_X), y, z), at.above.x, off_y, off_z), at.share.x);
}

/// Three independent noises of slopes, as lattice_sum().
FN real3 lattice_sum3(real3 p) {
    LatticePlace at = lattice_place(p);
    word y = at.y + word(LATTICE_Y);
    word z = at.z + word(LATTICE_Z);
    real3 near_below = lattice_edge3(at, at.y, at.z, at.below.y, at.below.z);
    real3 near_above = lattice_edge3(at, y, at.z, at.above.y, at.below.z);
    real3 far_below = lattice_edge3(at, at.y, z, at.below.y, at.above.z);
    real3 far_above = lattice_edge3(at, y, z, at.above.y, at.above.z);
    real3 sum =
        blended3(blended3(near_below, near_above, at.share.y), blended3(far_below, far_above, at.share.y), at.share.z);
    return sum * real(1.0f / LATTICE_SCALE);
}

/// Mean and standard deviation of noise_value().
FN float noise_mean(uint generator) { return generator == 1u ? 0.481f : generator == 2u ? 0.506f : 0.489f; }
FN float noise_deviation(uint generator) { return generator == 1u ? 0.255f : generator == 2u ? 0.126f : 0.146f; }

/// noise_value()'s share of values (of slopes it is 1), and one over the standard deviation of the sum of such shares.
const float NOISE_VALUE_SHARE = 0.588235294f;
const float NOISE_SUM_SCALE = 3.5156f;
/// noise_vector()'s share of slopes.
const float NOISE_VECTOR_SHARE = 1.4f;

/// Noise between 0 and 1 for POV-Ray's noise generators 1 (wide, cut off at both ends), 2 (kept within) and 3
/// (Perlin's).
FN real noise_value(real3 p, uint generator) {
    real sum = NOISE_SUM_SCALE * lattice_sum(p, NOISE_VALUE_SHARE);
    return clamp(noise_mean(generator) + noise_deviation(generator) * sum, real(0.0f), real(1.0f));
}

/// Three independent noises of mean 0 and standard deviation 0.256.
FN real3 noise_vector(real3 p) { return lattice_sum3(p) * real(NOISE_VECTOR_SHARE); }

/// Sum of `octaves` noises, each `lambda` times finer and `omega` times weaker than the one before.
FN real3 turbulence_vector(real3 p, uint octaves, float lambda, float omega) {
    real3 sum = noise_vector(p);
    float frequency = lambda;
    float weight = omega;
    for (uint i = 1u; i < octaves; i = i + 1u) {
        sum = sum + noise_vector(p * real(frequency)) * real(weight);
        frequency = frequency * lambda;
        weight = weight * omega;
    }
    return sum;
}

/// The same of one number, each noise counted from its middle: a sum of mean 0.
FN real turbulence_scalar(real3 p, uint octaves, float lambda, float omega, uint generator) {
    real sum = real(0.0f);
    float frequency = 1.0f;
    float weight = 1.0f;
    for (uint i = 0u; i < octaves; i = i + 1u) {
        sum = sum + (noise_value(p * real(frequency), generator) - 0.5f) * weight;
        frequency = frequency * lambda;
        weight = weight * omega;
    }
    return sum;
}

/// A sum of noises from 0 up: of generators 2 and 3 they count over twice their range, the first cut off at 0 and 1; as
/// povray's pictures of marble show it.
FN real turbulence_sum(real3 p, uint octaves, float lambda, float omega, uint generator) {
    real sum = real(0.0f);
    float frequency = 1.0f;
    float weight = 1.0f;
    for (uint i = 0u; i < octaves; i = i + 1u) {
        real n = noise_value(p * real(frequency), generator);
        if (generator != 1u) n = 2.0f * n - 0.5f;
        if (i == 0u) n = clamp(n, real(0.0f), real(1.0f));
        sum = sum + n * weight;
        frequency = frequency * lambda;
        weight = weight * omega;
    }
    return sum;
}

/// Sum of `octaves` folded noises, from frequency `first` on by doubling and halving: sharp creases.
FN real folded_noise(real3 p, uint octaves, float first, uint generator) {
    real sum = real(0.0f);
    float frequency = first;
    float weight = 1.0f;
    for (uint i = 0u; i < octaves; i = i + 1u) {
        sum = sum + abs(noise_value(p * real(frequency), generator) - 0.5f) * weight;
        frequency = frequency * 2.0f;
        weight = weight * 0.5f;
    }
    return sum;
}

/// A random number in [0, 1) for each cell of the integer lattice.
FN word cell_hash(real3 cell, uint seed) {
    return lattice_hash(lattice_number(cell.x), lattice_number(cell.y), lattice_number(cell.z) + word(seed));
}

/// Rings around ten places near the origin, added up: mean 0.5, standard deviation 0.12. Ripples have one wavelength,
/// 1; waves are each of another, the longer the higher.
FN real rings_value(real3 p, bool one_wavelength) {
    real sum = real(0.0f);
    float power_sum = 0.0f;
    for (uint i = 0u; i < 10u; i = i + 1u) {
        word hash = hash_word(word(i * 7919u + 101u));
        real3 source = random_vector(hash);
        float frequency = one_wavelength ? 1.0f : 0.08f + 0.08f * float(i);
        float height = 1.0f / frequency;
        sum = sum + height * sine(fraction(length(p - source) * frequency) * 6.28318531f);
        power_sum = power_sum + height * height * 0.5f;
    }
    return clamp(0.5f + sum * (0.12f / sqrt(power_sum)), real(0.0f), real(1.0f));
}

KERNEL_END

#endif
