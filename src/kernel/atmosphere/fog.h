// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_ATMOSPHERE_FOG_H
#define SUNDOG_KERNEL_ATMOSPHERE_FOG_H

#include "kernel/math.h"
#include "kernel/patterns/noise.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// Amount of ground fog from its foot up to relative height z, whose density is 1 below z = 0 and 1/(1+z^2) above.
/// (The reference has another formula; this is what pictures of povray 3.7 show, to the last bit of 16.)
FN real ground_fog_depth(real z) { return select(z < real(0.0f), z, angle_of(max(z, real(0.0f)), real(1.0f))); }

/// Share of light, per channel, that gets through a fog over `distance` along a ray; `glow` is what the fog adds
/// (POV-Ray's reference, section 3.4.4.2 "Fog").
FN real3 fog_transmittance(Fog fog, Ray ray, real distance, OUT(real3) glow) {
    real way = min(distance, real(RAY_FAR));
    real length_in_fog = way;
    if (fog.ground != 0u) {
        float per_altitude = 1.0f / max(fog.altitude, 1e-20f);
        real z0 = (dot(ray.origin, real3(fog.up)) - fog.offset) * per_altitude;
        real rise = dot(ray.direction, real3(fog.up)) * way * per_altitude;
        real z1 = z0 + rise;
        mask level = abs(rise) < real(1e-3f);
        real up = max(z0, real(0.0f));
        real mean = select(level, 1.0f / (1.0f + up * up),
                           (ground_fog_depth(z1) - ground_fog_depth(z0)) / select(level, real(1.0f), rise));
        length_in_fog = length_in_fog * mean;
    }
    if (fog.turb_depth > 0.0f) {
        // As povray's pictures show: noise half-way along the ray thins it out, the less the longer the way is.
        real3 middle = point_at(ray, way * 0.5f) * real3(fog.turbulence);
        real noise = turbulence_sum(middle, fog.octaves, fog.lambda, fog.omega, fog.noise_generator);
        real near = exp2_clamped(way * (-1.44269504f / max(fog.distance, 1e-20f)));
        length_in_fog = length_in_fog * (1.0f - near * min(noise * fog.turb_depth, real(1.0f)));
    }
    real clear = exp2_clamped(length_in_fog * (-1.44269504f / max(fog.distance, 1e-20f)));
    clear = max(clear, real(fog.transmit_share));
    real3 color = real3(fog.color);
    glow = color * (1.0f - clear);
    return (real3(real(1.0f - fog.filter_share)) + color * real(fog.filter_share)) * clear;
}

/// All fogs on the way of `distance` along a ray: dims `weight` and returns what they add to the radiance that it
/// carries. Fogs don't dim each other's own light, as in povray.
FN real3 fog_radiance(SCENE Ray ray, real distance, INOUT(real3) weight) {
    real3 sum = real3(real(0.0f));
    real3 clear_weight = weight;
    for (uint i = 0u; i < FRAME.fog_count; i = i + 1u) {
        real3 glow;
        real3 passes = fog_transmittance(AT(fogs, i), ray, distance, glow);
        sum = sum + clear_weight * glow;
        weight = weight * passes;
    }
    return sum;
}

KERNEL_END

#endif
