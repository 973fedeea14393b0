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
    record.outline = word(0u);
    record.surface = word(0u);
    record.beyond = real(0.0f);
    record.shade = real3(real(0.0f));
    record.rest = real3(real(0.0f));
    return record;
}

/// From here on nothing is like the paths in the lanes of `where`.
FN void record_unlike(mask where, INOUT(PathRecord) record) {
    record.unlike = record.unlike | select(where, word(1u), word(0u));
}

/// `memory`, with one more thing at its end in the lanes of `where`.
FN word remembered(word memory, word thing, mask where) {
    return select(where, hash_word((memory ^ thing) * word(0x9e3779b1u)), memory);
}

/// A number, not 0, that stands for an object's parts of one material.
FN word object_number(word geometry, word material) {
    return hash_word(geometry ^ (material * word(0x9e3779b1u))) | word(1u);
}

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

/// Remembers a surface that a path of this weight met, the first or a further one. `base`: see direct_light();
/// `base_share`: how much of it counts.
FN void record_surface(SCENE Surface s, Lobes lobes, LightStates states, real3 base, real3 base_share, real3 weight,
                       mask found, bool is_first, INOUT(PathRecord) record) {
    mask textured;
    mask unlike;
    texture_kind(SCENE_ s, lobes, found, textured, unlike);
    word number = object_number(s.geometry, s.material);
    // Two words a surface: which it is, and what lights it.
    record.signature = remembered(record.signature, number, found);
    record.signature = remembered(record.signature, states.lit, found);
    record.highlights = remembered(record.highlights, states.highlit, found);
    if (is_first) {
        real3 shaded = weight * (base - lobes.emission) * base_share;
        real3 color = max(lobes.albedo, real3(real(DARKEST_TEXTURE)));
        real3 shade = real3(shaded.x / color.x, shaded.y / color.y, shaded.z / color.z);
        // A channel that the texture doesn't reflect says nothing of the light: it is taken to be as bright as others.
        real most = largest(shade);
        real darkest = real(DARKEST_TEXTURE);
        shade = real3(select(lobes.albedo.x < darkest, most, shade.x), select(lobes.albedo.y < darkest, most, shade.y),
                      select(lobes.albedo.z < darkest, most, shade.z));
        record.outline = select(found, number, word(0u));
        record.surface = select(textured, number, word(0u));
        record.shade = select(textured, shade, real3(real(0.0f)));
    } else {
        unlike = mask_or(unlike, mask_and(textured, largest(weight) > real(VISIBLE_HIGHLIGHT)));
    }
    record_unlike(unlike, record);
}

/// The same for rays that met nothing.
FN void record_miss(SCENE mask missed, INOUT(PathRecord) record) {
    record.signature = remembered(record.signature, word(NONE), missed);
    // What is painted on the sky is not interpolated.
    if (FEATURE(FEATURE_ATMOSPHERE) && FRAME.sky_layer_count > 0u) record_unlike(missed, record);
}

KERNEL_END

#endif
