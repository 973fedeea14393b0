// SPDX-License-Identifier: Apache-2.0
// What objects and lights together do with photons.
#ifndef SUNDOG_KERNEL_LIGHTS_PHOTON_FLAGS_H
#define SUNDOG_KERNEL_LIGHTS_PHOTON_FLAGS_H

#include "kernel/math.h"

KERNEL_BEGIN

/// True where neither the light nor the object (Geometry::photons) says "never", and one of them says so.
FN mask photons_agree(word photons, uint light_flags, uint object_yes, uint object_never, uint light_yes,
                      uint light_never) {
    mask says = (photons & word(object_yes)) != word(0u);
    if ((light_flags & light_yes) != 0u) says = mask(true);
    mask denies = (photons & word(object_never)) != word(0u);
    if ((light_flags & light_never) != 0u) denies = mask(true);
    return mask_and(says, mask_not(denies));
}

/// Where photons of a light are reflected.
FN mask photons_reflect(word photons, uint light_flags) {
    return photons_agree(photons, light_flags, PHOTONS_REFLECT, PHOTONS_NEVER_REFLECT, LIGHT_PHOTONS_REFLECT,
                         LIGHT_PHOTONS_NEVER_REFLECT);
}

/// Where photons of a light are refracted.
FN mask photons_refract(word photons, uint light_flags) {
    return photons_agree(photons, light_flags, PHOTONS_REFRACT, PHOTONS_NEVER_REFRACT, LIGHT_PHOTONS_REFRACT,
                         LIGHT_PHOTONS_NEVER_REFRACT);
}

/// Where a light's shadow rays end, because photons bring what gets through.
FN mask photons_replace_shadow(word photons, uint light_flags) {
    return mask_and((photons >> PHOTONS_TARGET_SHIFT) != word(0u), photons_refract(photons, light_flags));
}

KERNEL_END

#endif
