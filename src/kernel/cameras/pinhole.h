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

KERNEL_END

#endif
