// SPDX-License-Identifier: Apache-2.0
// Bodies: what surfaces without layers enclose that bends light (glass, liquids), where they reach into each other or
// hold something. A ray keeps a list of those that it is in (interior.h); unlike POV-Ray's interiors they are entered
// by the front of their surfaces and left by the back, and of several the one that was entered last counts: a liquid
// may reach into its glass, and what has one material is one body.
#ifndef SUNDOG_KERNEL_MATERIALS_BODY_H
#define SUNDOG_KERNEL_MATERIALS_BODY_H

#include "kernel/materials/interior.h"

KERNEL_BEGIN

/// What the surface encloses, in the lanes of `found`: an index into `interiors`, 0 for nothing.
FN word body_of(SCENE Surface s, mask found) { return select(found, FIELD(materials, s.material, interior), word(0u)); }

FN Crossing body_crossing(Surface s, word body, Insides list) {
    mask encloses = body != word(0u);
    Insides with = insides_with(list, body);
    Insides without = insides_without(list, place_of_inside(list, body));
    Crossing crossing;
    crossing.leaves = mask_and(encloses, s.from_behind);
    mask enters = mask_and(encloses, mask_not(s.from_behind));
    crossing.behind.inner = select(enters, with.inner, select(crossing.leaves, without.inner, list.inner));
    crossing.behind.outer = select(enters, with.outer, select(crossing.leaves, without.outer, list.outer));
    return crossing;
}

/// The body that a ray comes through to the surface. One that starts inside of something doesn't know of it before.
FN word body_before(Crossing crossing, word body, Insides list) {
    word innermost = list.inner & word(65535u);
    return select(mask_and(crossing.leaves, innermost == word(0u)), body, innermost);
}

/// Index of refraction in front of the surface over the one behind it, for all colours together.
FN real body_eta(SCENE Crossing crossing, word body, Insides list) {
    word before = body_before(crossing, body, list);
    word after = crossing.behind.inner & word(65535u);
    return FIELD(interiors, before, ior) / FIELD(interiors, after, ior);
}

/// What a way of length `distance` to the surface lets pass (Beer 1852).
FN real3 body_transmittance(SCENE Crossing crossing, word body, Insides list, real distance) {
    word before = body_before(crossing, body, list);
    real3 rate = FIELD(interiors, before, attenuation) * (distance * -1.44269504f);
    return real3(exp2_clamped(rate.x), exp2_clamped(rate.y), exp2_clamped(rate.z));
}

KERNEL_END

#endif
