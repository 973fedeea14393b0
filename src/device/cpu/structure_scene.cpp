// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/structure_scene.h"

#include <cmath>
#include <optional>

#include "base/diagnostics.h"
#include "device/cpu/callback_rays.h"

namespace sundog::cpu {
namespace {

/// Nearly as far as Embree lets boxes reach.
constexpr float kEverywhere = 1e18F;

}  // namespace

StructureScene::StructureScene(RTCDevice device, Acceleration which, const RenderScene& scene)
    : world_(which, scene), scene_(rtcNewScene(device)) {
    const embree::Geometry everywhere(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(everywhere.get(), 1);
    rtcSetGeometryUserData(everywhere.get(), this);
    rtcSetGeometryBoundsFunction(everywhere.get(), bounds, nullptr);
    rtcSetGeometryIntersectFunction(everywhere.get(), intersect);
    rtcSetGeometryOccludedFunction(everywhere.get(), occluded);
    rtcSetGeometryMask(everywhere.get(), 0xffffffffU);
    rtcCommitGeometry(everywhere.get());
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(scene_.get(), everywhere.get());
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw DeviceError("Embree failed to take a structure of ours");
}

accel::Steps StructureScene::all_steps() const {
    accel::Steps sum;
    for (const Worker& worker : workers_) {
        sum.visits += worker.steps.visits;
        sum.tests += worker.steps.tests;
    }
    return sum;
}

void StructureScene::bounds(const RTCBoundsFunctionArguments* args) {
    *args->bounds_o = {-kEverywhere, -kEverywhere, -kEverywhere, 0, kEverywhere, kEverywhere, kEverywhere, 0};
}

void StructureScene::intersect(const RTCIntersectFunctionNArguments* args) {
    const auto& self = *static_cast<const StructureScene*>(args->geometryUserPtr);
    Worker& worker = self.workers_.local();
    const unsigned n = args->N;
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, n);
    for (unsigned lane = 0; lane < n; ++lane) {
        if (args->valid[lane] == 0) continue;
        const std::optional<accel::Found> found =
            self.world_.nearest(ray_of(rays, n, lane), RTCRayN_mask(rays, n, lane), worker.scratch, worker.steps);
        if (!found) continue;
        RTCRayN_tfar(rays, n, lane) = found->t;
        RTCHitN_u(hits, n, lane) = found->u;
        RTCHitN_v(hits, n, lane) = found->v;
        RTCHitN_Ng_x(hits, n, lane) = found->normal.x;
        RTCHitN_Ng_y(hits, n, lane) = found->normal.y;
        RTCHitN_Ng_z(hits, n, lane) = found->normal.z;
        // The kernel wants to know of what it sees: the geometry, not the one thing that Embree has.
        RTCHitN_geomID(hits, n, lane) = found->geometry;
        RTCHitN_primID(hits, n, lane) = found->primitive;
        RTCHitN_instID(hits, n, lane, 0) = RTC_INVALID_GEOMETRY_ID;
    }
}

void StructureScene::occluded(const RTCOccludedFunctionNArguments* args) {
    const auto& self = *static_cast<const StructureScene*>(args->geometryUserPtr);
    Worker& worker = self.workers_.local();
    const unsigned n = args->N;
    for (unsigned lane = 0; lane < n; ++lane) {
        if (args->valid[lane] == 0) continue;
        if (self.world_.any(ray_of(args->ray, n, lane), RTCRayN_mask(args->ray, n, lane), worker.scratch, worker.steps))
            RTCRayN_tfar(args->ray, n, lane) = -INFINITY;
    }
}

}  // namespace sundog::cpu
