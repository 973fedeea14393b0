// SPDX-License-Identifier: Apache-2.0
// Colours of textures.
#pragma once

#include "trace/noise_volume.h"
#include "trace/tables.h"

namespace sundog::intro {

/// The colour of one texture at places in its space.
[[gnu::noinline]] inline real3 texture_color(const Tables& tables, const Texture& texture, const real3& place) {
    real3 p = place + real3(texture.shift);
    real phase = dot(p, real3(texture.stripes));
    if (texture.rings > 0.0f) phase = phase + texture.rings * sqrt(p.x * p.x + p.y * p.y);
    if (texture.noise > 0.0f) {
        phase = phase + (noise_at(tables.noise, p * real3(texture.noise_scale)) - 0.5f) * texture.noise;
    }
    // Up the palette and down again, so that it has no seam.
    real turn = phase - 2.0f * floor(phase * 0.5f);
    real entry = min(turn, 2.0f - turn) * 255.0f;
    if (texture.tiles > 0.0f) {
        real tile = floor(p.x * texture.tiles) + floor(p.y * texture.tiles);
        real odd = tile - 2.0f * floor(tile * 0.5f);
        entry = entry * (127.0f / 255.0f) + 128.0f * odd;
    }
    word index = word_from_real(clamp(entry, real(0.0f), real(255.0f)));
    word packed = gather_lanes(tables.palettes + std::size_t{texture.palette} * kPaletteSize, 1, index);
    real3 root = real3(real_from_word(packed & word(1023u)), real_from_word((packed >> 10u) & word(1023u)),
                       real_from_word(packed >> 20u)) *
                 real(1.0f / 1023.0f);
    return root * root;
}

/// The same of lanes with textures of their own; white where the number is 0.
FN real3 texture_colors(const World& world, const Tables& tables, word number, real3 p, mask alive) {
    real3 color = real3(real(1.0f));
    mask left = mask_and(alive, number != word(0u));
    while (any_lane(left)) {
        uint one = first_lane(left, number);
        mask here = mask_and(left, number == word(one));
        color = select(here, texture_color(tables, world.textures[one], p), color);
        left = mask_and(left, mask_not(here));
    }
    return color;
}

}  // namespace sundog::intro
