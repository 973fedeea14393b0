// SPDX-License-Identifier: Apache-2.0
// Lists of media, and which of them rays are in.
#ifndef SUNDOG_KERNEL_ATMOSPHERE_MEDIA_GROUP_H
#define SUNDOG_KERNEL_ATMOSPHERE_MEDIA_GROUP_H

#include "kernel/atmosphere/media_insides.h"
#include "kernel/patterns/program.h"

KERNEL_BEGIN

/// Most lists of media at one place: of the insides, and the atmosphere's.
const uint MAX_MEDIA_LISTS = MAX_MEDIA_INSIDES + 1u;

/// The media that some lanes are in together.
struct MediaGroup {
    uint count;
    uint list[MAX_MEDIA_LISTS];  ///< In `code`.
    uint first;                  ///< The medium in `code` whose sampling counts: as in povray, the one entered first.
    bool varies;                 ///< Somewhere, density depends on the place.
    bool absorbs;                ///< Some light is lost.
    bool emits;
    bool scatters;
    bool collects;  ///< Photons are stored there.
};

FN bool not_black(vec3 c) { return max(abs(c.x), max(abs(c.y), abs(c.z))) > 0.0f; }

FN void add_list(SCENE uint list, INOUT(MediaGroup) group) {
    if (group.count == 0u) group.first = list + MEDIA_LIST_WORDS;
    group.list[group.count] = list;
    group.count = group.count + 1u;
    uint count = AT(code, list);
    for (uint i = 0u; i < count; i = i + 1u) {
        uint at = list + MEDIA_LIST_WORDS + i * MEDIUM_WORDS;
        bool scatters = not_black(code_vec3(SCENE_ at + 6u));
        group.scatters = group.scatters || scatters;
        group.collects = group.collects || AT(code, at + 21u) != 0u;
        group.emits = group.emits || not_black(code_vec3(SCENE_ at + 3u));
        group.absorbs =
            group.absorbs || not_black(code_vec3(SCENE_ at)) || (scatters && code_float(SCENE_ at + 9u) != 0.0f);
        group.varies = group.varies || AT(code, at + 12u) > 0u;
    }
}

/// Takes those lanes from `todo` that are in the same media as its first one, and says in which. In what isn't hollow
/// there are none, whatever it stands in.
FN mask take_alike(SCENE MediaInsides insides, bool atmosphere, INOUT(mask) todo, OUT(MediaGroup) group) {
    mask alike = todo;
    bool solid = false;
    group.count = 0u;
    group.first = 0u;
    group.varies = false;
    group.absorbs = false;
    group.emits = false;
    group.scatters = false;
    group.collects = false;
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u) {
        uint list = first_lane(todo, insides.entry[i]);
        alike = mask_and(alike, insides.entry[i] == word(list));
        if (list == MEDIUM_SOLID) solid = true;
        else if (list != NONE) add_list(SCENE_ list, group);
    }
    if (atmosphere) add_list(SCENE_ FRAME.atmosphere, group);
    if (solid) group.count = 0u;
    todo = mask_and(todo, mask_not(alike));
    return alike;
}

KERNEL_END

#endif
