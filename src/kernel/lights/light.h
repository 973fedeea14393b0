// SPDX-License-Identifier: Apache-2.0
// Lights without size, and what a light does to a surface.
#ifndef SUNDOG_KERNEL_LIGHTS_LIGHT_H
#define SUNDOG_KERNEL_LIGHTS_LIGHT_H

#include "kernel/rays.h"

KERNEL_BEGIN

/// Unit direction and distance from a point to a light; a sun is infinitely far.
FN real3 direction_to_light(Light light, real3 point, OUT(real) distance) {
    if (light.kind == LIGHT_SUN) {
        distance = real(3.0e38f);
        return real3(light.place);
    }
    real3 to_light = real3(light.place) - point;
    distance = length(to_light);
    return to_light * (1.0f / max(distance, real(1e-30f)));
}

KERNEL_END

#endif
