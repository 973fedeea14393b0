// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/solid_callbacks.h"

#include <cmath>
#include <optional>

#include "device/accel/primitive_bounds.h"
#include "device/cpu/coincidence.h"
#include "solids/compiled_solid.h"

namespace sundog::cpu {
namespace {

solids::Ray ray_of(RTCRayN* rays, unsigned n, unsigned lane) {
    return {{RTCRayN_org_x(rays, n, lane), RTCRayN_org_y(rays, n, lane), RTCRayN_org_z(rays, n, lane)},
            {RTCRayN_dir_x(rays, n, lane), RTCRayN_dir_y(rays, n, lane), RTCRayN_dir_z(rays, n, lane)}};
}

/// The nearest surface in the lane's interval that isn't culled.
std::optional<solids::Hit> nearest(const GeometryData& data, RTCRayN* rays, unsigned n, unsigned lane, float reach) {
    const solids::Ray ray = ray_of(rays, n, lane);
    solids::Range range{RTCRayN_tnear(rays, n, lane), reach};
    std::optional<solids::Hit> hit = data.solid->nearest(ray, range);
    while (hit && data.culling && dot(hit->normal, ray.direction) >= 0 && data.opaque(hit->material)) {
        range.lower = hit->t;
        hit = data.solid->nearest(ray, range);
    }
    return hit;
}

}  // namespace

void solid_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    *args->bounds_o = rtc_bounds(accel::roomy(accel::bounds_of_solid(*data.solid)));
}

void intersect_solid(const RTCIntersectFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const unsigned n = args->N;
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, n);
    for (unsigned lane = 0; lane < n; ++lane) {
        if (args->valid[lane] == 0 || (RTCRayN_mask(rays, n, lane) & data.visible_to) == 0) continue;
        const std::optional<solids::Hit> hit = nearest(data, rays, n, lane, reach_of(rays, n, lane));
        if (!hit || !enter_hit(args, lane, static_cast<float>(hit->t), static_cast<float>(hit->normal.x),
                               static_cast<float>(hit->normal.y), static_cast<float>(hit->normal.z)))
            continue;
        RTCHitN_u(hits, n, lane) = static_cast<float>(hit->u);
        RTCHitN_v(hits, n, lane) = static_cast<float>(hit->v);
        RTCHitN_primID(hits, n, lane) = hit->material;
    }
}

void occluded_by_solid(const RTCOccludedFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const unsigned n = args->N;
    for (unsigned lane = 0; lane < n; ++lane) {
        if (args->valid[lane] == 0 || (RTCRayN_mask(args->ray, n, lane) & data.visible_to) == 0) continue;
        const bool hit = data.culling ? nearest(data, args->ray, n, lane, RTCRayN_tfar(args->ray, n, lane)).has_value()
                                      : data.solid->any(ray_of(args->ray, n, lane), {RTCRayN_tnear(args->ray, n, lane),
                                                                                     RTCRayN_tfar(args->ray, n, lane)});
        if (hit) RTCRayN_tfar(args->ray, n, lane) = -INFINITY;
    }
}

}  // namespace sundog::cpu
