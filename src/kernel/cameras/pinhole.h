// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_CAMERAS_PINHOLE_H
#define SUNDOG_KERNEL_CAMERAS_PINHOLE_H

#include "kernel/rays.h"

KERNEL_BEGIN

/// The ray through image point (x, y) in [0,1]^2, y down, up to depth far_z along the view axis.
FN Ray pinhole_ray(Camera camera, real x, real y, float far_z) {
    real3 through =
        real3(camera.center) + real3(camera.right) * (2.0f * x - 1.0f) + real3(camera.up) * (1.0f - 2.0f * y);
    Ray ray;
    ray.origin = real3(camera.eye);
    real inverse_length = 1.0f / sqrt(dot(through, through));
    ray.direction = through * inverse_length;
    ray.t_min = real(0.0f);
    // The window is perpendicular to center, so every ray's depth along the axis is that of center per length of
    // through.
    ray.t_max = far_z / (length(camera.center) * inverse_length);
    return ray;
}

/// Where sample `index` of a pixel goes, in pixels from its left (top) edge: the middle for sample 0, then the R2
/// sequence (Roberts 2018), which fills the square evenly for any count.
FN vec2 pixel_sample(uint index) {
    uint x = 0x80000000u + index * 0xc13fa9a9u;
    uint y = 0x80000000u + index * 0x91e10da5u;
    return vec2(float(x >> 8u) * 5.9604645e-8f, float(y >> 8u) * 5.9604645e-8f);
}

KERNEL_END

#endif
