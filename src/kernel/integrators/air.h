// SPDX-License-Identifier: Apache-2.0
// What lies between surfaces beside media: fog, rainbows.
#ifndef SUNDOG_KERNEL_INTEGRATORS_AIR_H
#define SUNDOG_KERNEL_INTEGRATORS_AIR_H

#include "kernel/atmosphere/fog.h"
#include "kernel/atmosphere/media_insides.h"
#include "kernel/atmosphere/rainbow.h"

KERNEL_BEGIN

/// Takes rays of the given weights through fog and rainbows, over the first `reach` of their ways: adds to `radiance`
/// what shines at them there, and dims the weights. `media` is what the rays start inside of.
FN void cross_fog(SCENE Ray ray, real reach, MediaInsides media, mask alive, INOUT(real3) weight,
                  INOUT(real3) radiance) {
    real3 black = real3(real(0.0f));
    if (FEATURE(FEATURE_ATMOSPHERE)) {
        mask in_air = alive;
        if (FEATURE(FEATURE_HOLLOW)) in_air = mask_and(in_air, mask_not(in_solid(media)));
        if (FRAME.fog_count > 0u) {
            real3 dimmed = weight;
            real3 glow = fog_radiance(SCENE_ ray, reach, dimmed);
            radiance = radiance + select(in_air, glow, black);
            weight = select(in_air, dimmed, weight);
        }
        if (FRAME.rainbows != NONE) {
            real3 dimmed = weight;
            real3 glow = rainbow_radiance(SCENE_ FRAME.rainbows, ray, reach, dimmed);
            radiance = radiance + select(in_air, glow, black);
            weight = select(in_air, dimmed, weight);
        }
    }
}

KERNEL_END

#endif
