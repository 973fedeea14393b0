// SPDX-License-Identifier: Apache-2.0
// What a path remembers of its way, if RECORDING.
#ifndef SUNDOG_KERNEL_INTEGRATORS_RECORD_H
#define SUNDOG_KERNEL_INTEGRATORS_RECORD_H

#include "kernel/integrators/path.h"
#include "kernel/lights/direct.h"
#include "kernel/materials/layers.h"
#include "kernel/patterns/noise.h"

KERNEL_BEGIN

/// Texture colours below this say nothing of the light on them.
const float DARKEST_TEXTURE = 0.015625f;

FN PathRecord blank_record() {
    PathRecord record;
    record.signature = word(1u);
    record.highlights = word(1u);
    record.unlike = word(0u);
    record.surface = word(0u);
    record.beyond = real(0.0f);
    record.shade = real3(real(0.0f));
    record.rest = real3(real(0.0f));
    return record;
}

/// `memory`, with one more thing at its end in the lanes of `where`.
FN word remembered(word memory, word thing, mask where) {
    return select(where, hash_word((memory ^ thing) * word(0x9e3779b1u)), memory);
}

/// The number by which a textured surface is known again.
FN word surface_number(Surface s) { return hash_word(s.geometry ^ (s.material * word(0x9e3779b1u))) | word(1u); }

/// Tells in which lanes of `found` a surface is textured, and in which of them in a way that light on it can't be told
/// from it: bumps, several layers, or a texture that lets light through.
FN void texture_kind(SCENE Surface s, Lobes lobes, mask found, OUT(mask) textured, OUT(mask) unlike) {
    word flags = FIELD(materials, s.material, flags);
    textured = mask_and(found, (flags & word(MATERIAL_TEXTURED)) != word(0u));
    unlike = mask_and(found, mask_not(found));
    if (FEATURE(FEATURE_BUMP)) {
        word maps = FIELD(materials, s.material, maps);
        mask bumpy = mask_or(FIELD(material_maps, maps, bump.texture) != word(NONE),
                             FIELD(material_maps, maps, normal.texture) != word(NONE));
        unlike = mask_or(unlike, mask_and(found, bumpy));
    }
    if (FEATURE(FEATURE_PATTERNED)) {
        mask in_layers = mask_and(found, lobes.patterned);
        word index = valid_index(in_layers, FIELD(materials, s.material, patterned));
        word layer = valid_index(in_layers, FIELD(patterned, index, first_layer));
        mask varies = mask_and(in_layers, FIELD(layers, layer, program) != word(NONE));
        mask several = mask_and(in_layers, FIELD(patterned, index, layer_count) != word(1u));
        mask bent = mask_and(in_layers, FIELD(layers, layer, normal) != word(NONE));
        textured = mask_or(textured, varies);
        unlike = mask_or(unlike, mask_or(several, bent));
    }
    unlike = mask_or(unlike, mask_and(textured, (flags & word(MATERIAL_TRANSPARENT)) != word(0u)));
}

/// Remembers a surface that `path` met, the first or a further one. `own` is what of `base` (see direct_light) counts.
FN void record_surface(SCENE Surface s, Lobes lobes, LightStates states, real3 base, real3 counts_share, PathState path,
                       mask found, bool is_first, INOUT(FirstHit) first) {
    PathRecord record = first.record;
    mask textured;
    mask unlike;
    texture_kind(SCENE_ s, lobes, found, textured, unlike);
    // Two words a surface: which it is, and what lights it.
    record.signature = remembered(record.signature, s.geometry * word(0x85ebca6bu) + s.material, found);
    record.signature = remembered(record.signature, states.lit, found);
    record.highlights = remembered(record.highlights, states.highlit, found);
    if (is_first) {
        real3 shaded = path.weight * (base - lobes.emission) * counts_share;
        real3 color = max(lobes.albedo, real3(real(DARKEST_TEXTURE)));
        real3 shade = real3(shaded.x / color.x, shaded.y / color.y, shaded.z / color.z);
        // A channel that the texture doesn't reflect says nothing of the light: it is taken to be as bright as others.
        real most = largest(shade);
        real darkest = real(DARKEST_TEXTURE);
        shade = real3(select(lobes.albedo.x < darkest, most, shade.x), select(lobes.albedo.y < darkest, most, shade.y),
                      select(lobes.albedo.z < darkest, most, shade.z));
        record.surface = select(textured, surface_number(s), word(0u));
        record.shade = select(textured, shade, real3(real(0.0f)));
    } else {
        unlike = mask_or(unlike, mask_and(textured, largest(path.weight) > real(VISIBLE_HIGHLIGHT)));
    }
    record.unlike = record.unlike | select(unlike, word(1u), word(0u));
    first.record = record;
}

/// The same for rays that met nothing.
FN void record_miss(SCENE mask missed, INOUT(FirstHit) first) {
    first.record.signature = remembered(first.record.signature, word(NONE), missed);
    // What is painted on the sky is not interpolated.
    if (FEATURE(FEATURE_ATMOSPHERE) && FRAME.sky_layer_count > 0u)
        first.record.unlike = first.record.unlike | select(missed, word(1u), word(0u));
}

FN real luminance(real3 color) { return dot(color, real3(real(0.2126f), real(0.7152f), real(0.0722f))); }

KERNEL_END

#endif
