// SPDX-License-Identifier: Apache-2.0
// Embree's rays in callbacks, as the kernel has them.
#pragma once

#include "device/cpu/embree.h"
#include "kernel/rays.h"

namespace sundog::cpu {

/// The ray of one lane of a packet of n.
inline kernel::Ray ray_of(RTCRayN* rays, unsigned n, unsigned lane) {
    kernel::Ray ray;
    ray.origin =
        kernel::real3(RTCRayN_org_x(rays, n, lane), RTCRayN_org_y(rays, n, lane), RTCRayN_org_z(rays, n, lane));
    ray.direction =
        kernel::real3(RTCRayN_dir_x(rays, n, lane), RTCRayN_dir_y(rays, n, lane), RTCRayN_dir_z(rays, n, lane));
    ray.t_min = RTCRayN_tnear(rays, n, lane);
    ray.t_max = RTCRayN_tfar(rays, n, lane);
    return ray;
}

}  // namespace sundog::cpu
