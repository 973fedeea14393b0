// SPDX-License-Identifier: Apache-2.0
// Compiled once per width (SUNDOG_KERNEL_LANES), under the names SUNDOG_INTERSECT_SHAPES and SUNDOG_OCCLUDED_BY_SHAPES:
// spheres and boxes against all lanes of a packet at once.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "device/cpu/coincidence.h"
#include "device/cpu/shape_callbacks.h"
#include "kernel/shapes/box.h"
#include "kernel/shapes/sphere.h"

namespace sundog::cpu {
namespace {

using namespace kernel;

/// The lanes of one member of a packet, the first of which this is.
real lanes_from(const float& first) {
    vfloat v;
    std::memcpy(&v, &first, sizeof v);
    return real(v);
}
word lanes_from(const unsigned& first) {
    vuint v;
    std::memcpy(&v, &first, sizeof v);
    return word(v);
}

Ray rays_of(RTCRayN* rays) {
    constexpr unsigned n = kLanes;
    Ray ray;
    ray.origin = real3(lanes_from(RTCRayN_org_x(rays, n, 0)), lanes_from(RTCRayN_org_y(rays, n, 0)),
                       lanes_from(RTCRayN_org_z(rays, n, 0)));
    ray.direction = real3(lanes_from(RTCRayN_dir_x(rays, n, 0)), lanes_from(RTCRayN_dir_y(rays, n, 0)),
                          lanes_from(RTCRayN_dir_z(rays, n, 0)));
    ray.t_min = lanes_from(RTCRayN_tnear(rays, n, 0));
    ray.t_max = lanes_from(RTCRayN_tfar(rays, n, 0));
    return ray;
}

/// Lanes in which there is a ray that sees the geometry.
mask asking_lanes(const GeometryData& data, const int* valid, RTCRayN* rays) {
    vuint asked;
    std::memcpy(&asked, valid, sizeof asked);
    return mask_and(word(asked) != word(0U),
                    (lanes_from(RTCRayN_mask(rays, kLanes, 0)) & word(data.visible_to)) != word(0U));
}

/// True for spheres so large that they are found in double, ray by ray.
bool is_large(const GeometryData& data, unsigned primitive) {
    const kernel::Geometry& g = data.geometry;
    return g.kind == GEOMETRY_SPHERE &&
           data.scene->spheres[g.first_primitive + primitive].radius >= accel::kLargeRadius;
}

mask hit_shape(const GeometryData& data, unsigned primitive, const Ray& ray, real& t, real3& normal) {
    const std::uint32_t i = data.geometry.first_primitive + primitive;
    mask found;
    if (data.geometry.kind == GEOMETRY_SPHERE) {
        const kernel::Sphere& sphere = data.scene->spheres[i];
        found = intersect_sphere(ray, sphere.center, sphere.radius, t, normal);
    } else {
        const kernel::Box& box = data.scene->boxes[i];
        found = intersect_box(ray, box.lower, box.upper, t, normal);
    }
    if (culls(data, primitive)) found = mask_and(found, mask_not(dot(normal, ray.direction) >= real(0.0F)));
    return found;
}

}  // namespace

void SUNDOG_INTERSECT_SHAPES(const RTCIntersectFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    constexpr unsigned n = kLanes;
    if (args->N != n || is_large(data, args->primID)) {
        intersect_shapes(args);
        return;
    }
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, n);
    Ray ray = rays_of(rays);
    ray.t_max = ray.t_max * (1 + kCoincident);  // reach_of()
    real t;
    real3 normal;
    const mask found = mask_and(hit_shape(data, args->primID, ray, t, normal), asking_lanes(data, args->valid, rays));
    if (!any_lane(found)) return;
    const auto stored = [](real x) { return std::bit_cast<std::array<float, n>>(x.v); };
    const auto ts = stored(t), xs = stored(normal.x), ys = stored(normal.y), zs = stored(normal.z);
    const vint lanes = lane_ints(found);
    for (unsigned lane = 0; lane < n; ++lane) {
        if (lanes[lane] == 0 || !enter_hit(args, lane, ts[lane], xs[lane], ys[lane], zs[lane])) continue;
        RTCHitN_u(hits, n, lane) = 0;
        RTCHitN_v(hits, n, lane) = 0;
        RTCHitN_primID(hits, n, lane) = args->primID;
    }
}

void SUNDOG_OCCLUDED_BY_SHAPES(const RTCOccludedFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    if (args->N != kLanes || is_large(data, args->primID)) {
        occluded_by_shapes(args);
        return;
    }
    const Ray ray = rays_of(args->ray);
    real t;
    real3 normal;
    const mask found =
        mask_and(hit_shape(data, args->primID, ray, t, normal), asking_lanes(data, args->valid, args->ray));
    const real t_far = select(found, real(-INFINITY), ray.t_max);
    std::memcpy(&RTCRayN_tfar(args->ray, kLanes, 0), &t_far.v, sizeof t_far.v);
}

}  // namespace sundog::cpu
