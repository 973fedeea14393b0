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

/// A coordinate that goes there and back: what lies in 1..2 mirrors 0..1.
FN real mirrored(real x) {
    real in_two = x - 2.0f * floor(x * 0.5f);
    return min(in_two, 2.0f - in_two);
}

/// `moved`, which is uv with a TextureRef's scale and offset, turned by its shear in the lanes that ask for it.
FN real2 turned_uv(word flags, real2 moved, real2 uv, real2 shear) {
    mask turned = (flags & word(TEXTURE_TURNED)) != word(0u);
    return select(turned, moved + real2(uv.y, uv.x) * shear, moved);
}

/// One texel as linear RGB and alpha.
FN real3 texel_at(SCENE word first, word width, word x, word y, mask srgb, OUT(real) alpha) {
    word packed = GET(texels, first + y * width + x);
    word r = packed & word(255u);
    word g = (packed >> 8u) & word(255u);
    word b = (packed >> 16u) & word(255u);
    alpha = real_from_word(packed >> 24u) * 0.00392156863f;
    real3 stored = real3(real_from_word(r), real_from_word(g), real_from_word(b)) * real(0.00392156863f);
    real3 decoded = real3(GET(tables, r), GET(tables, g), GET(tables, b));
    return select(srgb, decoded, stored);
}

/// Bilinear lookup of texture number `texture` (valid in every lane) at uv, v upwards; linear RGB and alpha.
/// flags: TEXTURE_CLAMP and TEXTURE_RARE.
FN real3 texture_lookup(SCENE word texture, word flags, real2 uv, OUT(real) alpha) {
    word width = FIELD(textures, texture, width);
    word height = FIELD(textures, texture, height);
    word first = FIELD(textures, texture, first_texel);
    mask srgb = (FIELD(textures, texture, flags) & word(TEXTURE_SRGB)) != word(0u);
    mask clamped_u = (flags & word(TEXTURE_CLAMP)) != word(0u);
    mask clamped_v = clamped_u;
    mask rare = (flags & word(TEXTURE_RARE)) != word(0u);
    if (any_lane(rare)) {
        uv.x = select((flags & word(TEXTURE_MIRROR_U)) != word(0u), mirrored(uv.x), uv.x);
        uv.y = select((flags & word(TEXTURE_MIRROR_V)) != word(0u), mirrored(uv.y), uv.y);
        // Beyond a mirror's edge lies the texel before it once more: as if clamped.
        clamped_u = mask_or(clamped_u, (flags & word(TEXTURE_CLAMP_U | TEXTURE_MIRROR_U)) != word(0u));
        clamped_v = mask_or(clamped_v, (flags & word(TEXTURE_CLAMP_V | TEXTURE_MIRROR_V)) != word(0u));
    }
    real w = real_from_word(width);
    real h = real_from_word(height);
    // Whole repeats go first: far from the origin they would eat the fraction's bits.
    real u = select(clamped_u, clamp(uv.x, real(0.0f), real(1.0f)), uv.x - floor(uv.x));
    real v = select(clamped_v, clamp(uv.y, real(0.0f), real(1.0f)), uv.y - floor(uv.y));
    real x = u * w - 0.5f;
    real y = (1.0f - v) * h - 0.5f;
    real x0 = floor(x);
    real y0 = floor(y);
    real fx = x - x0;
    real fy = y - y0;
    if (any_lane(rare)) {
        mask nearest = (flags & word(TEXTURE_NEAREST)) != word(0u);
        fx = select(nearest, select(fx >= real(0.5f), real(1.0f), real(0.0f)), fx);
        fy = select(nearest, select(fy >= real(0.5f), real(1.0f), real(0.0f)), fy);
    }
    word left = wrap_texel(x0, w, clamped_u);
    word right = wrap_texel(x0 + 1.0f, w, clamped_u);
    word top = wrap_texel(y0, h, clamped_v);
    word bottom = wrap_texel(y0 + 1.0f, h, clamped_v);
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
