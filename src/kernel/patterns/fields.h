// SPDX-License-Identifier: Apache-2.0
// Patterns: a number, or a choice from a list, for every point of space. Meanings are those of POV-Ray's
// reference, section 3.5.11 "Patterns".
#ifndef SUNDOG_KERNEL_PATTERNS_FIELDS_H
#define SUNDOG_KERNEL_PATTERNS_FIELDS_H

#include "kernel/math.h"
#include "kernel/patterns/crackle.h"
#include "kernel/patterns/noise.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// A point moved by turbulence, in one of the ways STIR_*.
FN real3 stirred_point(uint way, real3 p, vec3 amount, uint octaves, float lambda, float omega, uint generator) {
    if (way == STIR_X) {
        p.x = p.x + amount.x * turbulence_sum(p, octaves, lambda, omega, generator);
        return p;
    }
    real3 noise = turbulence_vector(p, octaves, lambda, omega);
    if (way == STIR_WAVES) {
        real3 turns = (noise + p) * real3(amount);
        return real3(p.x + sine(turns.x * 6.28318531f), p.y + sine(turns.y * 6.28318531f), p.z);
    }
    real3 moved = p + real3(amount) * noise;
    if (way == STIR_ALL_Z) moved.z = moved.z + amount.x * turbulence_sum(p, octaves, lambda, omega, generator);
    return moved;
}

/// A field of noise before its wave form. `parameters`: of agate its amount of turbulence, lambda and omega.
FN real noise_field_value(uint kind, real3 p, vec3 parameters, uint noise) {
    uint generator = noise & 255u;
    if (FIELDS_HAVE(FIELD_NOISE) && kind == FIELD_NOISE) return noise_value(p, generator);
    if (FIELDS_HAVE(FIELD_GRANITE) && kind == FIELD_GRANITE)
        return min(folded_noise(p, 6u, 4.0f, generator) * 1.95f, real(1.0f));
    if (FIELDS_HAVE(FIELD_WRINKLES) && kind == FIELD_WRINKLES)
        return clamp(0.5f + 0.97f * turbulence_scalar(p, 10u, 2.0f, 0.5f, generator), real(0.0f), real(1.0f));
    if (FIELDS_HAVE(FIELD_DENTS) && kind == FIELD_DENTS) {
        real n = noise_value(p, generator);
        return n * n * n;
    }
    if (FIELDS_HAVE(FIELD_CELLS) && kind == FIELD_CELLS) {
        word hash = cell_hash(real3(floor(p.x), floor(p.y), floor(p.z)), 0x2bu);
        return real_from_word(hash >> 8u) * 5.9604645e-8f;
    }
    if (FIELDS_HAVE(FIELD_CRACKLE) && kind == FIELD_CRACKLE) return crackle_value(p);
    if ((FIELDS_HAVE(FIELD_RIPPLES) || FIELDS_HAVE(FIELD_WAVES)) && (kind == FIELD_RIPPLES || kind == FIELD_WAVES))
        return rings_value(p, kind == FIELD_RIPPLES);
    if (!FIELDS_HAVE(FIELD_AGATE)) return real(0.0f);
    // Bands across z, bent by turbulence.
    real bent = turbulence_sum(p, noise >> 8u, parameters.y, parameters.z, generator) * (1.3f * parameters.x);
    real band = 0.5f + 0.5f * sine((bent + 1.1f * p.z) * 6.28318531f);
    return power(band, real(0.77f));
}

/// A field before its wave form. `parameters`: gradient's unit axis; spirals: x is the number of arms.
FN real field_value(uint kind, real3 p, vec3 parameters, uint noise) {
    if (kind >= FIELD_NOISE) return noise_field_value(kind, p, parameters, noise);
    real3 a = abs(p);
    if (kind == FIELD_GRADIENT) {
        real x = dot(p, real3(parameters));
        // The end of the first unit is the end of the map: the top of a unit box is not of the colour of its bottom.
        // Only beyond is the remainder taken, which shows where a frequency isn't whole.
        return select(x <= real(1.0f), x, fraction(x));
    }
    if (kind == FIELD_ONION) return fraction(length(p));
    if (kind == FIELD_SPHERICAL) return max(1.0f - length(p), real(0.0f));
    if (kind == FIELD_CYLINDRICAL) return max(1.0f - sqrt(p.x * p.x + p.z * p.z), real(0.0f));
    if (kind == FIELD_PLANAR) return max(1.0f - a.y, real(0.0f));
    if (kind == FIELD_BOXED) return max(1.0f - largest(a), real(0.0f));
    if (FIELDS_HAVE(FIELD_RADIAL) && kind == FIELD_RADIAL) return angle_of(p.x, p.z) * 0.159154943f + 0.75f;
    if (FIELDS_HAVE(FIELD_LEOPARD) && kind == FIELD_LEOPARD) {
        real sum = (sine(p.x) + sine(p.y) + sine(p.z)) * 0.333333333f;
        return sum * sum;
    }
    if (kind == FIELD_WOOD) return sqrt(p.x * p.x + p.y * p.y);
    if (kind == FIELD_MARBLE) return p.x;
    if (!FIELDS_HAVE(FIELD_SPIRAL1) && !FIELDS_HAVE(FIELD_SPIRAL2)) return real(0.0f);
    // Counted from -y, which shows where a frequency isn't whole.
    real turns = fraction(angle_of(p.y, p.x) * 0.159154943f + 0.25f) * parameters.x;
    real radius = sqrt(p.x * p.x + p.y * p.y);
    if (kind == FIELD_SPIRAL1) return radius + turns + p.z;
    // spiral2: rings lie over them.
    real rings = 1.0f - abs(2.0f * fraction(radius) - 1.0f);
    real arms = 1.0f - abs(2.0f * fraction(radius + turns + p.z) - 1.0f);
    return rings + arms;
}

/// A field's value bent by its wave form: 0..1.
FN real wave_value(uint wave, real value, float frequency, float phase, float exponent) {
    if (wave == WAVE_NONE) return clamp(value, real(0.0f), real(1.0f));
    // Just over 1, so that 1 itself is the end of a map, not its beginning; as povray's pictures show it.
    const float period = 1.00001f;
    real scaled = value * frequency + phase;
    real v = scaled - floor(scaled * (1.0f / period)) * period;
    if (wave == WAVE_TRIANGLE) return 1.0f - abs(2.0f * v - 1.0f);
    if (wave == WAVE_SINE) return (1.0f + sine(v * 6.28318531f)) * 0.5f;
    if (wave == WAVE_SCALLOP) return sine(v * 3.14159265f);
    if (wave == WAVE_CUBIC) return v * v * (3.0f - 2.0f * v);
    if (wave == WAVE_POLY) return power(v, real(exponent));
    return v;
}

/// Number modulo a positive divisor: in [0, divisor).
FN real modulo(real x, float divisor) { return x - floor(x * (1.0f / divisor)) * divisor; }

/// Mortar (0) or brick (1): courses of size.y, every second shifted by half a brick along x, the others by half a brick
/// along z. The mortar is a brick's upper part in each direction.
FN real brick_choice(real3 p, vec3 size, float mortar) {
    mask odd = modulo(p.y, size.y * 2.0f) >= real(size.y);
    real x = modulo(p.x + select(odd, real(size.x * 0.5f), real(0.0f)), size.x);
    real y = modulo(p.y, size.y);
    real z = modulo(p.z + select(odd, real(0.0f), real(size.z * 0.5f)), size.z);
    mask joint = mask_or(mask_or(x >= real(size.x - mortar), y >= real(size.y - mortar)), z >= real(size.z - mortar));
    return select(joint, real(0.0f), real(1.0f));
}

/// Which of three hexagons of a tiling of the xz plane: side 1, one centred on the origin.
FN real hexagon_choice(real3 p) {
    // Axial coordinates of pointed hexagons with corners on the x axis' sides, rounded to the nearest centre.
    real q = p.x * 0.666666667f;
    real r = p.z * 0.577350269f - p.x * 0.333333333f;
    real s = -q - r;
    real rq = floor(q + 0.5f);
    real rr = floor(r + 0.5f);
    real rs = floor(s + 0.5f);
    real dq = abs(rq - q);
    real dr = abs(rr - r);
    real ds = abs(rs - s);
    mask fix_q = mask_and(dq > dr, dq > ds);
    mask fix_r = mask_and(mask_not(fix_q), dr > ds);
    real fixed_q = select(fix_q, -rr - rs, rq);
    real fixed_r = select(fix_r, -fixed_q - rs, rr);
    return modulo(fixed_r - fixed_q, 3.0f);
}

/// Number of the list's entry at a point.
FN real choice_value(uint kind, real3 p, vec3 size, float mortar) {
    if (kind == CHOICE_CHECKER) return modulo(floor(p.x) + floor(p.y) + floor(p.z), 2.0f);
    if (kind == CHOICE_BRICK) return brick_choice(p, size, mortar);
    if (kind == CHOICE_HEXAGON) return hexagon_choice(p);
    if (kind == CHOICE_SQUARE) {
        // Around a corner: 0, 1 upwards, then 2 beside 1, 3 beside 0.
        real odd_x = modulo(floor(p.x), 2.0f);
        real odd_z = modulo(floor(p.z), 2.0f);
        return select(odd_x > real(0.5f), 3.0f - odd_z, odd_z);
    }
    if (kind == CHOICE_TRIANGULAR) {
        // The six triangles around a corner in turn, over the tiling of the xz plane by triangles of side 1: cells of
        // two triangles, in rows that repeat after three.
        real v = p.z * 1.15470054f;
        real u = p.x - v * 0.5f;
        real cell = modulo(floor(u) - floor(v), 3.0f);
        mask upper = fraction(u) + fraction(v) > real(1.0f);
        real of_lower = select(cell < real(0.5f), real(0.0f), select(cell < real(1.5f), real(4.0f), real(2.0f)));
        real of_upper = select(cell < real(0.5f), real(3.0f), select(cell < real(1.5f), real(5.0f), real(1.0f)));
        return select(upper, of_upper, of_lower);
    }
    // cubic: which face of a cube around the origin the point lies behind.
    real3 a = abs(p);
    real along_x = select(p.x >= real(0.0f), real(0.0f), real(3.0f));
    real along_y = select(p.y >= real(0.0f), real(1.0f), real(4.0f));
    real along_z = select(p.z >= real(0.0f), real(2.0f), real(5.0f));
    mask x_most = mask_and(a.x > a.y, a.x > a.z);
    return select(x_most, along_x, select(a.y >= a.z, along_y, along_z));
}

KERNEL_END

#endif
