// SPDX-License-Identifier: Apache-2.0
// The traversal that the kernel asks for (kernel/integrators/whitted.h), over Embree's packets of SUNDOG_KERNEL_LANES
// rays. Only units that hold a kernel include it.
#pragma once

#include <cstdint>
#include <utility>

#include "device/cpu/embree.h"
#include "device/cpu/given_hits.h"
#include "device/cpu/light_cells.h"
#include "kernel/rays.h"
#include "kernel/shapes/all_planes.h"

KERNEL_BEGIN

#if SUNDOG_KERNEL_LANES == 16
using RayPacket = RTCRay16;
using RayHitPacket = RTCRayHit16;
#elif SUNDOG_KERNEL_LANES == 8
using RayPacket = RTCRay8;
using RayHitPacket = RTCRayHit8;
#else
using RayPacket = RTCRay4;
using RayHitPacket = RTCRayHit4;
#endif

FN vfloat& lanes_of(float* first) { return *reinterpret_cast<vfloat*>(first); }
FN vuint& lanes_of(unsigned* first) { return *reinterpret_cast<vuint*>(first); }

FN std::uint64_t sum_lanes(word w) {
    std::uint64_t sum = 0;
    for (int lane = 0; lane < kLanes; ++lane) sum += w.v[lane];
    return sum;
}

FN void store_ray(const Ray& ray, word ray_kind, RayPacket& packet) {
    lanes_of(packet.org_x) = ray.origin.x.v;
    lanes_of(packet.org_y) = ray.origin.y.v;
    lanes_of(packet.org_z) = ray.origin.z.v;
    lanes_of(packet.dir_x) = ray.direction.x.v;
    lanes_of(packet.dir_y) = ray.direction.y.v;
    lanes_of(packet.dir_z) = ray.direction.z.v;
    lanes_of(packet.tnear) = ray.t_min.v;
    lanes_of(packet.tfar) = ray.t_max.v;
    lanes_of(packet.time) = vfloat{};
    lanes_of(packet.mask) = ray_kind.v;
    lanes_of(packet.flags) = vuint{};
}

#ifdef SUNDOG_KERNEL_RECORDS
/// What points of a picture are traced in: the scene, and, where they are taken to see something, their eye rays' hits,
/// which the next search finds. The kernel of such units gets no other SceneView.
struct PointView : SceneView {
    explicit PointView(const SceneView& view) : SceneView(view) {}
    mutable const Hit* next_hit = nullptr;
};
#endif

/// Whether a packet's rays are to be taken for coherent: paths' rays go apart at their first surface.
FN bool packed([[maybe_unused]] bool whitted, [[maybe_unused]] bool path) {
#ifdef SUNDOG_KERNEL_PATHS
    return path;
#else
    return whitted;
#endif
}

inline Hit trace_closest(SCENE Ray ray, mask alive, word ray_kind, bool together, const EyeHits* given = nullptr) {
#ifdef SUNDOG_KERNEL_RECORDS
    if (const Hit* known = std::exchange(static_cast<const PointView&>(scene).next_hit, nullptr)) return *known;
#endif
    alignas(64) RayHitPacket packet;
    store_ray(ray, ray_kind, packet.ray);
    lanes_of(packet.hit.geomID) = vuint{} - 1u;
    lanes_of(packet.hit.instID[0]) = vuint{} - 1u;
    alignas(64) vint valid = lane_ints(alive);
    word triangle(NONE);
    if (given != nullptr) {
        triangle = word(*reinterpret_cast<const vuint*>(given->triangles));
        valid = lane_ints(mask_and(alive, triangle == word(EYE_UNKNOWN)));
    }
    // As one packet even off mirrors: neighbours' rays mostly stay together, and that is a tenth to a quarter faster on
    // the gallery. But not where things move: see trace_any.
    embree::Query query(packed(together || !FEATURE(FEATURE_INSTANCES), together));
    // Embree looks into a packet of which nothing is asked all the same.
    if (given == nullptr || any_lane(mask_and(alive, triangle == word(EYE_UNKNOWN))))
        embree::closest_hit(reinterpret_cast<const int*>(&valid),
                            static_cast<RTCScene>(const_cast<void*>(scene.traversal)), query, packet);
    Hit hit;
    hit.t = real(lanes_of(packet.ray.tfar));
    hit.u = real(lanes_of(packet.hit.u));
    hit.v = real(lanes_of(packet.hit.v));
    hit.normal =
        real3(real(lanes_of(packet.hit.Ng_x)), real(lanes_of(packet.hit.Ng_y)), real(lanes_of(packet.hit.Ng_z)));
    hit.geometry = word(lanes_of(packet.hit.geomID));
    if (FEATURE(FEATURE_INSTANCES)) {
        const word instance(lanes_of(packet.hit.instID[0]));
        hit.geometry = select(instance != word(NONE), instance, hit.geometry);
    }
    const mask found = mask_and(alive, hit.geometry != word(NONE));
    hit.primitive =
        word(lanes_of(packet.hit.primID)) + FIELD(geometries, valid_index(found, hit.geometry), first_primitive);
    if (given != nullptr) {
        const mask met = mask_and(alive, triangle < word(EYE_UNKNOWN));
        if (any_lane(met)) hit_given_triangles(scene, ray, triangle, *given, met, hit);
    }
    if (scene.frame.plane_count > 0) closest_plane(scene, ray, ray_kind, alive, hit);
    return hit;
}

inline mask trace_any(SCENE Ray ray, mask alive, word ray_kind) {
    alignas(64) RayPacket packet;
    store_ray(ray, ray_kind, packet);
    alignas(64) const vint valid = lane_ints(alive);
    // Not as coherent where things move: Embree 3.13 never returns from rtcOccluded16 on coherent rays that meet an
    // instance of shapes with callbacks.
    embree::Query query(packed(!FEATURE(FEATURE_INSTANCES), false));
    embree::any_hit(reinterpret_cast<const int*>(&valid), static_cast<RTCScene>(const_cast<void*>(scene.traversal)),
                    query, packet);
    mask blocked = mask_and(alive, real(lanes_of(packet.tfar)) < real(0.0f));
    if (scene.frame.plane_count > 0) blocked = mask_or(blocked, any_plane(scene, ray, ray_kind, alive));
    return blocked;
}

KERNEL_END
