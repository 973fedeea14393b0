// SPDX-License-Identifier: Apache-2.0
// Which interiors a ray is in, and what they do to it (POV-Ray's reference, section 3.4.7 "Interior"). A ray keeps a
// short list: it grows where the ray enters an object, and shrinks where it leaves one, in whatever order.
#ifndef SUNDOG_KERNEL_MATERIALS_INTERIOR_H
#define SUNDOG_KERNEL_MATERIALS_INTERIOR_H

#include "kernel/materials/surface.h"

KERNEL_BEGIN

/// Up to four indices into `interiors`, of 16 bits each, the innermost in the lowest bits of `inner`; 0 for none. An
/// entry that a fifth one pushes out is forgotten.
struct Insides {
    word inner;
    word outer;
};

/// What the eye is in, for the lanes of `seeing`; nothing for others.
FN Insides insides_of_eye(SCENE mask seeing) {
    Insides list;
    list.inner = select(seeing, word(FRAME.eye_interiors_inner), word(0u));
    list.outer = select(seeing, word(FRAME.eye_interiors_outer), word(0u));
    return list;
}

/// Number `i` (0: the innermost) of a list.
FN word inside_at(Insides list, uint i) {
    word pair = i < 2u ? list.inner : list.outer;
    return (pair >> ((i & 1u) * 16u)) & word(65535u);
}

/// The place of an interior in a list; 4 where it isn't there. Interior 0 never is.
FN word place_of_inside(Insides list, word interior) {
    word place = word(4u);
    for (uint k = 0u; k < 4u; k = k + 1u) {
        uint i = 3u - k;
        place = select(inside_at(list, i) == interior, word(i), place);
    }
    return select(interior == word(0u), word(4u), place);
}

/// The list after entering an interior.
FN Insides insides_with(Insides list, word interior) {
    Insides more;
    more.outer = (list.outer << 16u) | (list.inner >> 16u);
    more.inner = (list.inner << 16u) | interior;
    return more;
}

/// The list without its entry number `place`; as it is where that is 4.
FN Insides insides_without(Insides list, word place) {
    Insides fewer;
    // From the entry on, all move down by one.
    word first = select(place == word(0u), list.inner >> 16u, list.inner & word(65535u));
    word second = select(place < word(2u), list.outer & word(65535u), list.inner >> 16u);
    word third = select(place < word(3u), list.outer >> 16u, list.outer & word(65535u));
    mask some = place < word(4u);
    fewer.inner = select(some, first | (second << 16u), list.inner);
    fewer.outer = select(some, third, list.outer);
    return fewer;
}

/// Share of light, per channel, that gets through `distance` of an interior (reference, section 3.4.7.3
/// "Attenuation"). Interior 0, the open air, is clear.
FN real3 interior_transmittance(SCENE word interior, real distance) {
    real3 white = real3(real(1.0f));
    real power_of = FIELD(interiors, interior, fade_power);
    mask dims = power_of > real(0.0f);
    if (!any_lane(dims)) return white;
    real depth = distance / FIELD(interiors, interior, fade_distance);
    real clear = 1.0f / (1.0f + power(depth, power_of));
    real3 color = FIELD(interiors, interior, fade_color);
    real3 passes = color + (white - color) * clear;
    // From there on each colour dims by itself, as povray's pictures show it, and without an end.
    real3 rate = (white - color) * (depth * -1.44269504f);
    real3 beer = real3(exp2_clamped(rate.x), exp2_clamped(rate.y), exp2_clamped(rate.z));
    passes = select(power_of >= real(1000.0f), beer, passes);
    return select(dims, passes, white);
}

/// The interior of the object that a surface is of, in the lanes of `layered`; 0 in others.
FN word interior_of(SCENE Surface s, mask layered) {
    word material = valid_index(layered, FIELD(materials, s.material, patterned));
    word number = FIELD(patterned, material, interior);
    mask copied = mask_and(layered, word(INTERIOR_PLAIN) < number);
    number = number + select(copied, FIELD(geometries, s.geometry, interior_copy), word(0u));
    return select(layered, number, word(0u));
}

/// What a ray meets at a surface of an object that has an interior.
struct Crossing {
    mask leaves;     ///< It is inside the object.
    Insides behind;  ///< The list beyond the surface.
};

/// In which lanes a ray leaves an object while it is inside of another one as well, were it the sky. There nothing is
/// reflected by Fresnel's equations in povray's pictures.
FN mask is_enclosed(Crossing crossing) { return mask_and(crossing.leaves, crossing.behind.inner != word(0u)); }

/// By the list alone, whichever side the ray comes from, as povray has it: open and clipped shapes are entered through
/// their inner side too, a part that is cut out of a solid is entered from the solid, and triangles may be wound
/// either way.
FN Crossing crossing_at(word interior, Insides list) {
    word place = place_of_inside(list, interior);
    Crossing crossing;
    crossing.leaves = place < word(4u);
    Insides with = insides_with(list, interior);
    Insides without = insides_without(list, place);
    mask enters = mask_and(mask_not(crossing.leaves), interior != word(0u));
    crossing.behind.inner = select(enters, with.inner, without.inner);
    crossing.behind.outer = select(enters, with.outer, without.outer);
    return crossing;
}

/// Index of refraction of an interior for light whose place in the spectrum is 0 (violet) to 1 (red), 0.5 for all
/// colours together. By steps of the same ratio, as povray's pictures show it.
FN real interior_ior(SCENE word interior, real spectrum) {
    real ior = FIELD(interiors, interior, ior);
    if (!FEATURE(FEATURE_DISPERSION)) return ior;
    return ior * power(FIELD(interiors, interior, dispersion), 0.5f - spectrum);
}

/// Index of refraction of the innermost interior of a list; 1 outside of all.
FN real insides_ior(SCENE Insides list, real spectrum) {
    return interior_ior(SCENE_ list.inner & word(65535u), spectrum);
}

/// Index of refraction in front of the surface over the one behind it; 1 at objects without an interior. `spectrum`
/// as in interior_ior().
FN real crossing_eta(SCENE Crossing crossing, word interior, Insides list, real spectrum) {
    real own = interior_ior(SCENE_ interior, spectrum);
    real entering = insides_ior(SCENE_ list, spectrum) / own;
    real leaving = own / insides_ior(SCENE_ crossing.behind, spectrum);
    real eta = select(crossing.leaves, leaving, entering);
    return select(interior == word(0u), real(1.0f), eta);
}

/// What a ray's way of length `distance` does to its light: all interiors that it is in dim it.
FN real3 inside_transmittance(SCENE Insides list, real distance) {
    real3 passes = real3(real(1.0f));
    for (uint i = 0u; i < 4u; i = i + 1u) {
        word inside = inside_at(list, i);
        if (!any_lane(inside != word(0u))) break;
        passes = passes * interior_transmittance(SCENE_ inside, distance);
    }
    return passes;
}

KERNEL_END

#endif
