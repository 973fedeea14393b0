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

/// A random number in [0, 1) that belongs to a point or a direction and a number, so that pictures don't depend on
/// threads.
FN real random_at(real3 p, word number) {
    word bits = hash_word(hash_word(hash_word(as_word(p.x) + number) + as_word(p.y)) + as_word(p.z));
    return real_from_word(bits >> 8u) * 5.96046448e-8f;
}

/// The hash of a lattice point.
FN word lattice_hash(word x, word y, word z) { return hash_word(hash_word(hash_word(z) + y) + x); }

/// What a lattice point adds at an offset from it: `gradient_share` of its gradient's slope, `value_share` of its
/// value.
FN real lattice_noise(word hash, real3 offset, float gradient_share, float value_share) {
    real slope =
        signed_unit(hash) * offset.x + signed_unit(hash >> 10u) * offset.y + signed_unit(hash >> 20u) * offset.z;
    real value = signed_unit(hash_word(hash));
    return slope * gradient_share + value * value_share;
}

/// Noise of mean 0 at p, lattice cells of size 1. `seed` gives independent fields.
FN real lattice_sum(real3 p, uint seed, float gradient_share, float value_share) {
    real3 cell = real3(floor(p.x), floor(p.y), floor(p.z));
    real3 f = p - cell;
    // Lattice numbers from 0: whole floats are exact to 2^24.
    word x0 = word_from_real(clamp(cell.x + 8388608.0f, real(0.0f), real(16777214.0f)));
    word y0 = word_from_real(clamp(cell.y + 8388608.0f, real(0.0f), real(16777214.0f)));
    word z0 = word_from_real(clamp(cell.z + 8388608.0f, real(0.0f), real(16777214.0f)));
    real sx = f.x * f.x * (3.0f - 2.0f * f.x);
    real sy = f.y * f.y * (3.0f - 2.0f * f.y);
    real sz = f.z * f.z * (3.0f - 2.0f * f.z);
    real sum = real(0.0f);
    for (uint corner = 0u; corner < 8u; corner = corner + 1u) {
        uint dx = corner & 1u;
        uint dy = (corner >> 1u) & 1u;
        uint dz = corner >> 2u;
        word hash = lattice_hash(x0 + word(dx), y0 + word(dy), z0 + word(dz + seed));
        real3 offset = real3(f.x - float(dx), f.y - float(dy), f.z - float(dz));
        real weight = (dx == 1u ? sx : 1.0f - sx) * (dy == 1u ? sy : 1.0f - sy) * (dz == 1u ? sz : 1.0f - sz);
        sum = sum + weight * lattice_noise(hash, offset, gradient_share, value_share);
    }
    return sum;
}

/// Mean and standard deviation of noise_value().
FN float noise_mean(uint generator) { return generator == 1u ? 0.481f : generator == 2u ? 0.506f : 0.489f; }
FN float noise_deviation(uint generator) { return generator == 1u ? 0.255f : generator == 2u ? 0.126f : 0.146f; }

/// noise_value()'s share of slopes (of values it is 1), and one over the standard deviation of the sum of such shares.
const float NOISE_SLOPE_SHARE = 1.7f;
const float NOISE_SUM_SCALE = 2.068f;

/// Noise between 0 and 1 for POV-Ray's noise generators 1 (wide, cut off at both ends), 2 (kept within) and 3
/// (Perlin's).
FN real noise_value(real3 p, uint generator) {
    real sum = NOISE_SUM_SCALE * lattice_sum(p, 0u, NOISE_SLOPE_SHARE, 1.0f);
    return clamp(noise_mean(generator) + noise_deviation(generator) * sum, real(0.0f), real(1.0f));
}

/// Three independent noises of mean 0 and standard deviation 0.256.
FN real3 noise_vector(real3 p) {
    return real3(lattice_sum(p, 0x51u, 1.4f, 0.0f), lattice_sum(p, 0xa2u, 1.4f, 0.0f),
                 lattice_sum(p, 0xf3u, 1.4f, 0.0f));
}

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
    return lattice_hash(word_from_real(clamp(cell.x + 8388608.0f, real(0.0f), real(16777214.0f))),
                        word_from_real(clamp(cell.y + 8388608.0f, real(0.0f), real(16777214.0f))),
                        word_from_real(clamp(cell.z + 8388608.0f, real(0.0f), real(16777214.0f))) + word(seed));
}

/// Rings around ten places near the origin, added up: mean 0.5, standard deviation 0.12. Ripples have one wavelength,
/// 1; waves are each of another, the longer the higher.
FN real rings_value(real3 p, bool one_wavelength) {
    real sum = real(0.0f);
    float power_sum = 0.0f;
    for (uint i = 0u; i < 10u; i = i + 1u) {
        word hash = hash_word(word(i * 7919u + 101u));
        real3 source = real3(signed_unit(hash), signed_unit(hash >> 10u), signed_unit(hash >> 20u));
        float frequency = one_wavelength ? 1.0f : 0.08f + 0.08f * float(i);
        float height = 1.0f / frequency;
        sum = sum + height * sine(fraction(length(p - source) * frequency) * 6.28318531f);
        power_sum = power_sum + height * height * 0.5f;
    }
    return clamp(0.5f + sum * (0.12f / sqrt(power_sum)), real(0.0f), real(1.0f));
}

KERNEL_END

#endif
