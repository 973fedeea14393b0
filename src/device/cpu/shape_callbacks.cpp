// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/shape_callbacks.h"

#include <cmath>

#include "device/accel/primitive_bounds.h"
#include "device/accel/primitive_tests.h"
#include "device/cpu/callback_rays.h"
#include "device/cpu/coincidence.h"

namespace sundog::cpu {

void shape_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    *args->bounds_o = rtc_bounds(accel::roomy(accel::bounds_of(*data.scene, data.geometry, args->primID)));
}

void intersect_shapes(const RTCIntersectFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const unsigned n = args->N;
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, n);
    const bool culling = culls(data, args->primID);
    for (unsigned lane = 0; lane < n; ++lane) {
        if (args->valid[lane] == 0 || (RTCRayN_mask(rays, n, lane) & data.visible_to) == 0) continue;
        float t = 0;
        kernel::real3 normal;
        kernel::Ray ray = ray_of(rays, n, lane);
        ray.t_max = reach_of(rays, n, lane);
        if (!accel::hit_shape(*data.scene, data.geometry, args->primID, ray, culling, t, normal)) continue;
        if (!enter_hit(args, lane, t, normal.x, normal.y, normal.z)) continue;
        RTCHitN_u(hits, n, lane) = 0;
        RTCHitN_v(hits, n, lane) = 0;
        RTCHitN_primID(hits, n, lane) = args->primID;
    }
}

void occluded_by_shapes(const RTCOccludedFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const bool culling = culls(data, args->primID);
    const unsigned n = args->N;
    for (unsigned lane = 0; lane < n; ++lane) {
        if (args->valid[lane] == 0 || (RTCRayN_mask(args->ray, n, lane) & data.visible_to) == 0) continue;
        float t = 0;
        kernel::real3 normal;
        if (accel::hit_shape(*data.scene, data.geometry, args->primID, ray_of(args->ray, n, lane), culling, t, normal))
            RTCRayN_tfar(args->ray, n, lane) = -INFINITY;
    }
}

}  // namespace sundog::cpu
