// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/solid_callbacks.h"

#include <bit>
#include <cmath>
#include <optional>

#include "device/accel/primitive_bounds.h"
#include "device/cpu/coincidence.h"
#include "device/cpu/quick_solid.h"
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

unsigned all_lanes(unsigned n) { return n >= 32 ? ~0U : (1U << n) - 1U; }

bool asks(const GeometryData& data, const int* valid, RTCRayN* rays, unsigned n, unsigned lane) {
    return valid[lane] != 0 && (RTCRayN_mask(rays, n, lane) & data.visible_to) != 0;
}

void enter(const RTCIntersectFunctionNArguments* args, unsigned lane, const solids::Hit& hit) {
    if (!enter_hit(args, lane, static_cast<float>(hit.t), static_cast<float>(hit.normal.x),
                   static_cast<float>(hit.normal.y), static_cast<float>(hit.normal.z)))
        return;
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
    RTCHitN_u(hits, args->N, lane) = static_cast<float>(hit.u);
    RTCHitN_v(hits, args->N, lane) = static_cast<float>(hit.v);
    RTCHitN_primID(hits, args->N, lane) = hit.material;
}

}  // namespace

void solid_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    *args->bounds_o = rtc_bounds(accel::roomy(accel::bounds_of_solid(*data.solid)));
}

void intersect_solid(const RTCIntersectFunctionNArguments* args) { intersect_solid_in(args, all_lanes(args->N)); }

void occluded_by_solid(const RTCOccludedFunctionNArguments* args) { occluded_by_solid_in(args, all_lanes(args->N)); }

void intersect_solid_in(const RTCIntersectFunctionNArguments* args, unsigned lanes) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const unsigned n = args->N;
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, n);
    for (unsigned left = lanes; left != 0; left &= left - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(left));
        if (!asks(data, args->valid, rays, n, lane)) continue;
        const std::optional<solids::Hit> hit = nearest(data, rays, n, lane, reach_of(rays, n, lane));
        if (hit) enter(args, lane, *hit);
    }
}

void occluded_by_solid_in(const RTCOccludedFunctionNArguments* args, unsigned lanes) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const unsigned n = args->N;
    for (unsigned left = lanes; left != 0; left &= left - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(left));
        if (!asks(data, args->valid, args->ray, n, lane)) continue;
        const bool hit = data.culling ? nearest(data, args->ray, n, lane, RTCRayN_tfar(args->ray, n, lane)).has_value()
                                      : data.solid->any(ray_of(args->ray, n, lane), {RTCRayN_tnear(args->ray, n, lane),
                                                                                     RTCRayN_tfar(args->ray, n, lane)});
        if (hit) RTCRayN_tfar(args->ray, n, lane) = -INFINITY;
    }
}

void enter_quick_hit(const RTCIntersectFunctionNArguments* args, unsigned lane, const QuickHit& hit) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const QuickPart& part = data.quick->parts[hit.place / 2];
    solids::Crossing crossing{hit.t};
    crossing.part = hit.face;
    const bool enters_part = hit.place % 2 == 0;
    enter(args, lane,
          data.solid->hit_on(ray_of(RTCRayHitN_RayN(args->rayhit, args->N), args->N, lane), part.leaf, crossing,
                             enters_part != part.flips, part.flips));
}

}  // namespace sundog::cpu
