// SPDX-License-Identifier: Apache-2.0
// Transcendental functions of our own, so that a picture's bits don't depend on a library's or a driver's.
#ifndef SUNDOG_KERNEL_MATH_H
#define SUNDOG_KERNEL_MATH_H

#include "kernel/compat/compat.h"

KERNEL_BEGIN

/// log2(x) for normal x > 0; relative error about 2e-7 away from 1, absolute about 1e-7 near it.
FN real log2_positive(real x) {
    // x = m * 2^e with m in [sqrt(1/2), sqrt(2)); log2(m) = 2/ln2 * atanh((m-1)/(m+1)) by its series.
    word bits = as_word(x) - word(0x3f3504f3u);
    word exponent = (bits + word(0x40000000u)) >> 23u;
    real m = as_real((bits & word(0x007fffffu)) + word(0x3f3504f3u));
    real s = (m - 1.0f) / (m + 1.0f);
    real s2 = s * s;
    real series = ((0.412198583f * s2 + 0.577078016f) * s2 + 0.961796694f) * s2 + 2.88539008f;
    return s * series + (real_from_word(exponent) - 128.0f);
}

/// 2^x; x is clamped to [-126, 127].
FN real exp2_clamped(real x) {
    real y = clamp(x, real(-126.0f), real(127.0f));
    real whole = floor(y + 0.5f);
    real f = y - whole;  // [-1/2, 1/2]; below, the Taylor series of 2^f
    real p = 1.54035304e-4f * f + 1.33335581e-3f;
    p = p * f + 9.61812911e-3f;
    p = p * f + 5.55041087e-2f;
    p = p * f + 2.40226507e-1f;
    p = p * f + 6.93147181e-1f;
    p = p * f + 1.0f;
    return p * as_real(word_from_real(whole + 127.0f) << 23u);
}

/// base^exponent for base >= 0; 0 for base 0 (or under the smallest normal number), whatever the exponent.
FN real power(real base, real exponent) {
    mask tiny = base < real(1.17549435e-38f);
    real safe = select(tiny, real(1.0f), base);
    return select(tiny, real(0.0f), exp2_clamped(exponent * log2_positive(safe)));
}

/// Linear light of an sRGB-encoded number (IEC 61966-2-1), also above 1.
FN real srgb_decoded(real x) {
    return select(x <= real(0.04045f), x * (1.0f / 12.92f),
                  power(max(x + 0.055f, real(0.0f)) * (1.0f / 1.055f), real(2.4f)));
}

/// Angle of (x, y) in radians, in (-pi, pi]; error under 2e-6. 0 for (0, 0).
FN real angle_of(real y, real x) {
    real ax = abs(x);
    real ay = abs(y);
    real large = max(ax, ay);
    mask zero = large <= real(0.0f);
    real q = min(ax, ay) / select(zero, real(1.0f), large);
    // atan on [0,1]: reduce to |z| <= tan(pi/8) by atan(q) = pi/4 + atan((q-1)/(q+1)), then the Taylor series.
    mask upper = q > real(0.414213562f);
    real z = select(upper, (q - 1.0f) / (q + 1.0f), q);
    real z2 = z * z;
    real p = 0.111111111f - 0.0909090909f * z2 + 0.0769230769f * (z2 * z2);
    p = -0.142857143f + z2 * p;
    p = 0.2f + z2 * p;
    p = -0.333333333f + z2 * p;
    real a = z + z * z2 * p;
    a = select(upper, a + 0.785398163f, a);
    a = select(ay > ax, 1.57079633f - a, a);
    a = select(x < real(0.0f), 3.14159265f - a, a);
    return select(y < real(0.0f), -a, a);
}

/// Sine of x radians; error under 1e-6 for |x| up to 10,000, growing beyond.
FN real sine(real x) {
    // x = k*pi + r with r in [-pi/2, pi/2]: sin(x) = (-1)^k sin(r). pi in three parts keeps r exact for large k.
    real k = floor(x * 0.318309886f + 0.5f);
    real r = x - k * 3.140625f;
    r = r - k * 9.67025757e-4f;
    r = r - k * 6.27832947e-7f;
    real r2 = r * r;
    real p = 2.71811842e-6f * r2 - 1.98393348e-4f;  // the series to r^9, last terms fitted to the interval
    p = p * r2 + 8.33329385e-3f;
    p = p * r2 - 1.66666567e-1f;
    real s = r + r * r2 * p;
    real odd = k - 2.0f * floor(k * 0.5f);
    return select(odd > real(0.5f), -s, s);
}

/// The largest of three numbers.
FN real largest(real3 v) { return max(v.x, max(v.y, v.z)); }

/// Luminance of linear RGB (ITU-R BT.709, the primaries of sRGB).
FN real luminance(real3 color) { return dot(color, real3(real(0.2126f), real(0.7152f), real(0.0722f))); }

/// POV-Ray's grey of a colour: weights of red, green and blue as its pictures show them.
FN real gray_of(real3 color) { return color.x * 0.297f + color.y * 0.589f + color.z * 0.114f; }

/// Cosine of x radians; as exact as sine.
FN real cosine(real x) { return sine(x + 1.57079633f); }

KERNEL_END

#endif
