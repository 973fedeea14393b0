// SPDX-License-Identifier: Apache-2.0
// Image and checker textures on uvs.
#ifndef SUNDOG_KERNEL_PATTERNS_TEXTURE_H
#define SUNDOG_KERNEL_PATTERNS_TEXTURE_H

#include "kernel/rays.h"

KERNEL_BEGIN

/// True where the checker of cells.x by cells.y squares a unit shows its other colour.
FN mask checker_is_other(real2 uv, real2 cells) {
    real parity = floor(uv.x * cells.x) + floor(uv.y * cells.y);
    return parity - 2.0f * floor(parity * 0.5f) > real(0.5f);
}

/// Index of a texel along one axis of `size` texels: repeated or clamped. position is a whole number.
FN word wrap_texel(real position, real size, mask clamped) {
    real repeated = position - size * floor(position / size);
    real x = select(clamped, position, repeated);
    return word_from_real(clamp(x, real(0.0f), size - 1.0f));
}

/// One texel as linear RGB and alpha.
FN real3 texel_at(SCENE word first, word width, word x, word y, mask srgb, OUT(real) alpha) {
    word packed = GET(texels, first + y * width + x);
    word r = packed & word(255u);
    word g = (packed >> 8u) & word(255u);
    word b = (packed >> 16u) & word(255u);
    alpha = real_from_word(packed >> 24u) * 0.00392156863f;
    real3 stored = real3(real_from_word(r), real_from_word(g), real_from_word(b)) * real(0.00392156863f);
    real3 decoded = real3(GET(srgb_to_linear, r), GET(srgb_to_linear, g), GET(srgb_to_linear, b));
    return select(srgb, decoded, stored);
}

/// Bilinear lookup of texture number `texture` (valid in every lane) at uv, v upwards; linear RGB and alpha.
/// flags: TEXTURE_CLAMP.
FN real3 texture_lookup(SCENE word texture, word flags, real2 uv, OUT(real) alpha) {
    word width = FIELD(textures, texture, width);
    word height = FIELD(textures, texture, height);
    word first = FIELD(textures, texture, first_texel);
    mask srgb = (FIELD(textures, texture, flags) & word(TEXTURE_SRGB)) != word(0u);
    mask clamped = (flags & word(TEXTURE_CLAMP)) != word(0u);
    real w = real_from_word(width);
    real h = real_from_word(height);
    // Whole repeats go first: far from the origin they would eat the fraction's bits.
    real u = select(clamped, clamp(uv.x, real(0.0f), real(1.0f)), uv.x - floor(uv.x));
    real v = select(clamped, clamp(uv.y, real(0.0f), real(1.0f)), uv.y - floor(uv.y));
    real x = u * w - 0.5f;
    real y = (1.0f - v) * h - 0.5f;
    real x0 = floor(x);
    real y0 = floor(y);
    real fx = x - x0;
    real fy = y - y0;
    word left = wrap_texel(x0, w, clamped);
    word right = wrap_texel(x0 + 1.0f, w, clamped);
    word top = wrap_texel(y0, h, clamped);
    word bottom = wrap_texel(y0 + 1.0f, h, clamped);
    real a00;
    real a10;
    real a01;
    real a11;
    real3 c00 = texel_at(SCENE_ first, width, left, top, srgb, a00);
    real3 c10 = texel_at(SCENE_ first, width, right, top, srgb, a10);
    real3 c01 = texel_at(SCENE_ first, width, left, bottom, srgb, a01);
    real3 c11 = texel_at(SCENE_ first, width, right, bottom, srgb, a11);
    alpha = mix(mix(a00, a10, fx), mix(a01, a11, fx), fy);
    return mix(mix(c00, c10, fx), mix(c01, c11, fx), fy);
}

/// One number of a colour with alpha, as TextureRef::flags' channel says.
FN real texture_channel(real3 color, real alpha, word flags) {
    word channel = (flags >> TEXTURE_CHANNEL_SHIFT) & word(7u);
    return select(channel == word(0u), color.x,
                  select(channel == word(1u), color.y,
                         select(channel == word(2u), color.z, select(channel == word(3u), alpha, luminance(color)))));
}

KERNEL_END

#endif
