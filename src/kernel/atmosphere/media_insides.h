// SPDX-License-Identifier: Apache-2.0
// What a ray is inside of: media that it crosses, and solids in which there are none.
#ifndef SUNDOG_KERNEL_ATMOSPHERE_MEDIA_INSIDES_H
#define SUNDOG_KERNEL_ATMOSPHERE_MEDIA_INSIDES_H

#include "kernel/materials/surface.h"

KERNEL_BEGIN

/// Interiors (PatternedMaterial::medium) that hold a ray's origin; NONE in free places.
struct MediaInsides {
    word entry[MAX_MEDIA_INSIDES];
};

/// What the eye is inside of, for the lanes of `seeing`; nothing for others.
FN MediaInsides eye_insides(SCENE mask seeing) {
    MediaInsides insides;
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
        insides.entry[i] = select(seeing, word(FRAME.eye_insides[i]), word(NONE));
    return insides;
}

/// True in the lanes that are inside of something that isn't hollow: there is neither fog nor a medium there.
FN mask in_solid(MediaInsides insides) {
    mask solid = insides.entry[0] == word(MEDIUM_SOLID);
    for (uint i = 1u; i < MAX_MEDIA_INSIDES; i = i + 1u) solid = mask_or(solid, insides.entry[i] == word(MEDIUM_SOLID));
    return solid;
}

/// The solids alone of what a ray is inside of.
FN MediaInsides solids_alone(MediaInsides insides) {
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
        insides.entry[i] = select(insides.entry[i] == word(MEDIUM_SOLID), insides.entry[i], word(NONE));
    return insides;
}

/// What rays are inside of once they have passed the surface, in the lanes of `passing`. As in povray, each surface
/// with an interior that a ray is in leads out of it, and each other one into it, whichever side is which (so two
/// overlapping parts of a union that share one interior are empty where they overlap). Solids are entered by the front.
FN MediaInsides media_beyond(SCENE Surface s, MediaInsides insides, mask passing) {
    word flags = FIELD(materials, s.material, flags);
    mask patterned_lanes = mask_and(passing, (flags & word(MATERIAL_PATTERNED)) != word(0u));
    if (!any_lane(patterned_lanes)) return insides;
    word index = valid_index(patterned_lanes, FIELD(materials, s.material, patterned));
    word medium = FIELD(patterned, index, medium);
    mask changes = mask_and(patterned_lanes, medium != word(NONE));
    if (!any_lane(changes)) return insides;
    mask solid = medium == word(MEDIUM_SOLID);
    mask leaving = mask_and(changes, mask_or(mask_not(solid), s.from_behind));
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u) {
        mask here = mask_and(leaving, insides.entry[i] == medium);
        insides.entry[i] = select(here, word(NONE), insides.entry[i]);
        leaving = mask_and(leaving, mask_not(here));
        changes = mask_and(changes, mask_not(here));
    }
    mask entering = mask_and(changes, mask_not(mask_and(solid, s.from_behind)));
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u) {
        mask here = mask_and(entering, insides.entry[i] == word(NONE));
        insides.entry[i] = select(here, medium, insides.entry[i]);
        entering = mask_and(entering, mask_not(here));
    }
    return insides;
}

KERNEL_END

#endif
