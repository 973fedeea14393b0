// SPDX-License-Identifier: Apache-2.0
// Compiled once per width (SUNDOG_KERNEL_LANES), under the names SUNDOG_INTERSECT_SHAPES and SUNDOG_OCCLUDED_BY_SHAPES:
// spheres and boxes against all lanes of a packet at once.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "device/cpu/coincidence.h"
#include "device/cpu/double_lanes.h"
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

/// accel::hit_large_sphere for half of the lanes.
unsigned hit_large_half(const kernel::Sphere& sphere, const Ray& ray, int half, float* ts, float* normals) {
    const auto wide_half = [&](const real& x) { return half_of(reinterpret_cast<const float&>(x.v), half); };
    const wide3 direction{wide_half(ray.direction.x), wide_half(ray.direction.y), wide_half(ray.direction.z)};
    const wide3 from = wide3{wide_half(ray.origin.x), wide_half(ray.origin.y), wide_half(ray.origin.z)} -
                       wide3{wide(sphere.center.x), wide(sphere.center.y), wide(sphere.center.z)};
    const wide a = dot(direction, direction), b = dot(from, direction);
    const wide c = dot(from, from) - wide(double{sphere.radius} * sphere.radius);
    const wide discriminant = b * b - a * c;
    const wide_mask reached = ~(discriminant < wide(0.0));
    const wide root = sqrt(select(reached, discriminant, wide(0.0)));
    const wide q = select(b < wide(0.0), root - b, -root - b);
    const wide one = select(q == wide(0.0), wide(0.0), c / q), other = q / a;
    const wide first = min(one, other), second = max(one, other);
    // In single precision, as the ray's ends are.
    const wide near = rounded(first), far = rounded(second);
    const wide t_min = wide_half(ray.t_min), t_max = wide_half(ray.t_max);
    const wide t = select((near > t_min) & (near < t_max), near, far);
    const wide3 out = from + direction * select(t == near, first, second);
    store_half(t, ts, half);
    store_half(out.x, normals, half);
    store_half(out.y, normals + kLanes, half);
    store_half(out.z, normals + 2 * kLanes, half);
    return bits_of(reached & (t > t_min) & (t < t_max));
}

mask hit_large_sphere(const kernel::Sphere& sphere, const Ray& ray, real& t, real3& normal) {
    alignas(64) std::array<float, kLanes> ts;
    alignas(64) std::array<float, 3 * kLanes> normals;
    unsigned found = 0;
    for (int half = 0; half < 2; ++half)
        found |= hit_large_half(sphere, ray, half, ts.data(), normals.data()) << (half * kWideLanes);
    t = lanes_from(ts[0]);
    normal = real3(lanes_from(normals[0]), lanes_from(normals[kLanes]), lanes_from(normals[2 * kLanes]));
    return lanes_of_bits(found);
}

mask hit_shape(const GeometryData& data, unsigned primitive, const Ray& ray, real& t, real3& normal) {
    const std::uint32_t i = data.geometry.first_primitive + primitive;
    mask found;
    if (data.geometry.kind == GEOMETRY_SPHERE) {
        const kernel::Sphere& sphere = data.scene->spheres[i];
        // Others are so large that floats don't tell where a ray leaves them.
        found = sphere.radius < accel::kLargeRadius ? intersect_sphere(ray, sphere.center, sphere.radius, t, normal)
                                                    : hit_large_sphere(sphere, ray, t, normal);
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
    if (args->N != n) {
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
    if (args->N != kLanes) {
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
