// SPDX-License-Identifier: Apache-2.0
// Mandelbrot's, Julia's and magnet fractals in single precision, for shaders: the CPU asks the host
// (fields/fractals.cpp).
#ifndef SUNDOG_KERNEL_PATTERNS_SHADER_FRACTALS_H
#define SUNDOG_KERNEL_PATTERNS_SHADER_FRACTALS_H

#include "kernel/patterns/code.h"

KERNEL_BEGIN

FN real2 complex_product(real2 a, real2 b) { return real2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
FN real complex_norm(real2 a) { return a.x * a.x + a.y * a.y; }
FN real2 complex_quotient(real2 a, real2 b) {
    real n = 1.0f / max(complex_norm(b), 1.0e-30f);
    return real2((a.x * b.x + a.y * b.y) * n, (a.y * b.x - a.x * b.y) * n);
}

/// How magnets are renormalised (Peitgen and Richter, The Beauty of Fractals, 1986): number 1 or 2.
FN real2 magnet_step(uint number, real2 z, real2 c) {
    real2 c1 = real2(c.x - 1.0f, c.y);
    real2 c2 = real2(c.x - 2.0f, c.y);
    real2 z2 = complex_product(z, z);
    real2 above = z2 + c1;
    real2 below = z * 2.0f + c2;
    if (number == 2u) {
        real2 both = complex_product(c1, c2);
        above = complex_product(z, z2) + complex_product(c1, z) * 3.0f + both;
        below = z2 * 3.0f + complex_product(c2, z) * 3.0f + both + real2(1.0f, 0.0f);
    }
    real2 quotient = complex_quotient(above, below);
    return complex_product(quotient, quotient);
}

FN real orbit_value(uint type, float factor, real2 z, real least_norm) {
    if (type == 0u) return factor;
    if (type == 1u) return sqrt(least_norm) * factor;
    if (type == 2u) return z.x * factor;
    if (type == 3u) return z.y * factor;
    if (type == 4u) return z.x * z.x * factor;
    if (type == 5u) return z.y * z.y * factor;
    return sqrt(complex_norm(z)) * factor;
}

/// Words: 0 for powers, or a magnet's number; 1 of Julia sets; their c; the number of iterations; the power; types and
/// factors of what is outside and inside.
FN real fractal_field(SCENE uint at, real x, real y) {
    uint magnet = AT(code, at);
    bool julia = AT(code, at + 1u) != 0u;
    real2 p = real2(x, y);
    real2 c = p;
    if (julia) c = real2(code_float(SCENE_ at + 2u), code_float(SCENE_ at + 3u));
    uint iterations = AT(code, at + 4u);
    uint exponent = AT(code, at + 5u);
    uint exterior = AT(code, at + 6u);
    float exterior_factor = code_float(SCENE_ at + 7u);
    bool from_p = julia || magnet == 0u;
    real2 z = real2(0.0f, 0.0f);
    if (from_p) z = p;
    real least_norm = from_p ? complex_norm(p) : 1.0e30f;
    float far = magnet == 0u ? 4.0f : 10000.0f;
    for (uint i = 0u; i < iterations; i = i + 1u) {
        if (magnet == 0u) {
            real2 power = z;
            for (uint k = 1u; k < exponent; k = k + 1u) power = complex_product(power, z);
            z = power + c;
        } else {
            z = magnet_step(magnet, z, c);
        }
        real n = complex_norm(z);
        least_norm = min(least_norm, n);
        // Magnets are attracted by 1, too.
        bool attracted = magnet != 0u && complex_norm(real2(z.x - 1.0f, z.y)) < 1.0e-4f;
        if (!(n <= far) || attracted) {
            if (exterior == 1u) return float(i) / float(iterations);
            if (exterior >= 7u) {
                if (!(exterior_factor > 0.0f)) return 0.0f;
                float period = exterior_factor + (exterior == 8u ? 1.0f : 0.0f);
                return (float(i) - floor(float(i) / period) * period) / exterior_factor;
            }
            return orbit_value(exterior, exterior_factor, z, least_norm);
        }
    }
    uint interior = AT(code, at + 8u);
    float interior_factor = code_float(SCENE_ at + 9u);
    if (interior == 6u) return complex_norm(z) * interior_factor;
    return orbit_value(interior, interior_factor, z, least_norm);
}

KERNEL_END

#endif
