// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_ATMOSPHERE_SKY_H
#define SUNDOG_KERNEL_ATMOSPHERE_SKY_H

#include "kernel/atmosphere/environment.h"
#include "kernel/patterns/program.h"

KERNEL_BEGIN

/// Radiance from infinitely far along a unit direction: the background, sky spheres over it.
FN real3 sky_radiance(SCENE real3 direction) {
    real3 sky = real3(FRAME.sky);
    for (uint i = 0u; i < FRAME.sky_layer_count; i = i + 1u) {
        SkyLayer layer = AT(sky_layers, i);
        real3 p = real3(layer.sky_from_world_x) * direction.x + real3(layer.sky_from_world_y) * direction.y +
                  real3(layer.sky_from_world_z) * direction.z;
        PigmentColor c = run_program(SCENE_ layer.program, p);
        real opacity = max(1.0f - c.filtered - c.transmitted, real(0.0f));
        real3 passes = c.rgb * c.filtered + real3(c.transmitted);
        sky = c.rgb * real3(layer.emission) * opacity + sky * passes;
    }
    return sky;
}

/// What rays see that miss everything.
FN real3 background_radiance(SCENE real3 direction) {
    if (FEATURE(FEATURE_ENVIRONMENT)) return environment_radiance(SCENE_ direction);
    if (FEATURE(FEATURE_ATMOSPHERE)) return sky_radiance(SCENE_ direction);
    return real3(FRAME.sky);
}

KERNEL_END

#endif
