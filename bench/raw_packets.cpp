// SPDX-License-Identifier: Apache-2.0
// Built three times, with RAW_LANES 4, 8 and 16. The loops over lanes are written for the compiler to vectorise.
#include "raw_packets.h"

namespace sundog::bench {

namespace {

constexpr int kLanes = RAW_LANES;
constexpr int kBlockWidth = kLanes == 4 ? 2 : 4;
constexpr int kBlockHeight = kLanes / kBlockWidth;

#if RTC_VERSION_MAJOR >= 4
using IntersectArguments = RTCIntersectArguments;
using OccludedArguments = RTCOccludedArguments;

IntersectArguments intersect_arguments() {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    return arguments;
}

OccludedArguments occluded_arguments() {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    return arguments;
}
#else
using IntersectArguments = RTCIntersectContext;
using OccludedArguments = RTCIntersectContext;

RTCIntersectContext intersect_arguments() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

RTCIntersectContext occluded_arguments() { return intersect_arguments(); }
#endif

// Embree 4 takes (valid, scene, packet, arguments), Embree 3 (valid, scene, context, packet).
template <class Call, class Packet, class Arguments>
void call_embree(const Call& call, const int* valid, RTCScene scene, Packet* packet, Arguments* arguments) {
#if RTC_VERSION_MAJOR >= 4
    call(valid, scene, packet, arguments);
#else
    call(valid, scene, arguments, packet);
#endif
}

/// Embree's types and calls for a packet width.
template <int lanes>
struct Packets;
template <>
struct Packets<4> {
    using RayHits = RTCRayHit4;
    using Rays = RTCRay4;
    [[maybe_unused]] static constexpr auto* kIntersect = rtcIntersect4;
    [[maybe_unused]] static constexpr auto* kOccluded = rtcOccluded4;
};
template <>
struct Packets<8> {
    using RayHits = RTCRayHit8;
    using Rays = RTCRay8;
    [[maybe_unused]] static constexpr auto* kIntersect = rtcIntersect8;
    [[maybe_unused]] static constexpr auto* kOccluded = rtcOccluded8;
};
template <>
struct Packets<16> {
    using RayHits = RTCRayHit16;
    using Rays = RTCRay16;
    [[maybe_unused]] static constexpr auto* kIntersect = rtcIntersect16;
    [[maybe_unused]] static constexpr auto* kOccluded = rtcOccluded16;
};
using RayHits = Packets<kLanes>::RayHits;
using Rays = Packets<kLanes>::Rays;

struct alignas(64) Lanes {
    float v[kLanes];
};
struct alignas(64) Mask {
    int v[kLanes];  ///< -1 active, 0 not: Embree's form.
};

int active_lanes(const Mask& mask) {
    int count = 0;
    for (int i = 0; i < kLanes; ++i) count -= mask.v[i];
    return count;
}

void intersect(const Mask& mask, RTCScene scene, RayHits& packet) {
    IntersectArguments arguments = intersect_arguments();
    call_embree(Packets<kLanes>::kIntersect, mask.v, scene, &packet, &arguments);
}

void occluded(const Mask& mask, RTCScene scene, Rays& packet) {
    OccludedArguments arguments = occluded_arguments();
    call_embree(Packets<kLanes>::kOccluded, mask.v, scene, &packet, &arguments);
}

void start_rays(Rays& ray) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) {
        ray.tnear[i] = 0;
        ray.time[i] = 0;
        ray.mask[i] = 0xffffffffU;
        ray.flags[i] = 0;
        ray.id[i] = 0;
    }
}

/// The surfaces that a packet has hit.
struct Surfaces {
    Lanes px, py, pz;  ///< Position.
    Lanes nx, ny, nz;  ///< Unit normal towards the ray's origin: that of the face, or the smoothed one for mirrors.
    Lanes error;       ///< How far to step off.
    Lanes dx, dy, dz;  ///< The ray's direction.
    Lanes eta;         ///< Of refracting lanes.
    Mask found;
    Mask mirrors, transmits;  ///< Lanes that go on by reflection and by refraction.
};

void locate(const RayHits& packet, const Mask& mask, Surfaces& s) {
    const Rays& ray = packet.ray;
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) {
        s.found.v[i] = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? mask.v[i] : 0;
        const float t = s.found.v[i] != 0 ? ray.tfar[i] : 1.0F;
        s.dx.v[i] = ray.dir_x[i], s.dy.v[i] = ray.dir_y[i], s.dz.v[i] = ray.dir_z[i];
        s.px.v[i] = ray.org_x[i] + s.dx.v[i] * t;
        s.py.v[i] = ray.org_y[i] + s.dy.v[i] * t;
        s.pz.v[i] = ray.org_z[i] + s.dz.v[i] * t;
        const float x = packet.hit.Ng_x[i], y = packet.hit.Ng_y[i], z = packet.hit.Ng_z[i];
        const float side = x * s.dx.v[i] + y * s.dy.v[i] + z * s.dz.v[i] > 0 ? -1.0F : 1.0F;
        const float scale = side / __builtin_sqrtf(x * x + y * y + z * z + 1e-30F);
        s.nx.v[i] = x * scale, s.ny.v[i] = y * scale, s.nz.v[i] = z * scale;
        const float ax = __builtin_fabsf(s.px.v[i]), ay = __builtin_fabsf(s.py.v[i]), az = __builtin_fabsf(s.pz.v[i]);
        const float xy = ax > ay ? ax : ay, zt = az > t ? az : t;
        s.error.v[i] = (xy > zt ? xy : zt) * 3.8e-6F;
    }
}

void shadow_rays(const RawView& view, const Surfaces& s, RawCounts& counts) {
    for (std::uint32_t l = 0; l < view.frame.light_count; ++l) {
        const kernel::Light& light = view.lights[l];
        if ((light.flags & kernel::LIGHT_SHADOWS) == 0U) continue;
        const bool sun = light.kind == kernel::LIGHT_SUN;
        alignas(64) Rays shadow;
        Mask lit;
        start_rays(shadow);
#pragma omp simd
        for (int i = 0; i < kLanes; ++i) {
            const float x = sun ? light.place.x : light.place.x - s.px.v[i];
            const float y = sun ? light.place.y : light.place.y - s.py.v[i];
            const float z = sun ? light.place.z : light.place.z - s.pz.v[i];
            const float distance = __builtin_sqrtf(x * x + y * y + z * z);
            const float scale = 1 / distance;
            lit.v[i] = x * s.nx.v[i] + y * s.ny.v[i] + z * s.nz.v[i] > 0 ? s.found.v[i] : 0;
            shadow.org_x[i] = s.px.v[i] + s.nx.v[i] * s.error.v[i];
            shadow.org_y[i] = s.py.v[i] + s.ny.v[i] * s.error.v[i];
            shadow.org_z[i] = s.pz.v[i] + s.nz.v[i] * s.error.v[i];
            shadow.dir_x[i] = x * scale, shadow.dir_y[i] = y * scale, shadow.dir_z[i] = z * scale;
            shadow.tfar[i] = sun ? 3.0e38F : distance;
        }
        const int count = active_lanes(lit);
        if (count == 0) continue;
        occluded(lit, view.opaque, shadow);
        int blocked = 0;
        for (int i = 0; i < kLanes; ++i) blocked += lit.v[i] != 0 && shadow.tfar[i] < 0 ? 1 : 0;
        counts.rays += static_cast<unsigned>(count);
        counts.shadow_rays += static_cast<unsigned>(count);
        counts.blocked += static_cast<unsigned>(blocked);
    }
}

bool any(const kernel::vec3& color) { return color.x > 0 || color.y > 0 || color.z > 0; }

/// The normal that a mirror goes by, where the mesh is smooth.
void smooth_normal(const RawView& view, const RawGeometry& geometry, const RayHits& packet, int i, Surfaces& s) {
    if (geometry.normals == nullptr) return;
    const kernel::TriangleCorners& corners = geometry.normals[packet.hit.primID[i]];
    if (corners.a == kernel::NONE) return;
    const kernel::vec3 &a = view.normals[corners.a], &b = view.normals[corners.b], &c = view.normals[corners.c];
    const float u = packet.hit.u[i], v = packet.hit.v[i], w = 1 - u - v;
    const float x = a.x * w + b.x * u + c.x * v;
    const float y = a.y * w + b.y * u + c.y * v;
    const float z = a.z * w + b.z * u + c.z * v;
    const float side = x * s.nx.v[i] + y * s.ny.v[i] + z * s.nz.v[i] < 0 ? -1.0F : 1.0F;
    const float scale = side / __builtin_sqrtf(x * x + y * y + z * z + 1e-30F);
    s.nx.v[i] = x * scale, s.ny.v[i] = y * scale, s.nz.v[i] = z * scale;
}

/// Which lanes go on, and how, by their materials.
void branch(const RawView& view, const RayHits& packet, Surfaces& s) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) {
        s.mirrors.v[i] = s.transmits.v[i] = 0;
        s.eta.v[i] = 1;
        if (s.found.v[i] == 0) continue;
        const RawGeometry& geometry = view.geometries[packet.hit.geomID[i]];
        const kernel::Material& material = view.materials[geometry.materials[packet.hit.primID[i]]];
        s.mirrors.v[i] = any(material.reflectance) ? -1 : 0;
        s.transmits.v[i] = any(material.transmittance) ? -1 : 0;
        if ((s.mirrors.v[i] | s.transmits.v[i]) == 0) continue;
        const float along =
            packet.hit.Ng_x[i] * s.dx.v[i] + packet.hit.Ng_y[i] * s.dy.v[i] + packet.hit.Ng_z[i] * s.dz.v[i];
        smooth_normal(view, geometry, packet, i, s);
        if (s.transmits.v[i] == 0) continue;
        s.eta.v[i] = along > 0 ? material.ior : 1 / material.ior;
        const float cosine = s.nx.v[i] * s.dx.v[i] + s.ny.v[i] * s.dy.v[i] + s.nz.v[i] * s.dz.v[i];
        if (s.eta.v[i] * s.eta.v[i] * (1 - cosine * cosine) < 1) continue;
        s.mirrors.v[i] = -1;  // total internal reflection
        s.transmits.v[i] = 0;
    }
}

void reflect(const Surfaces& s, Rays& next) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) {
        const float twice = 2 * (s.nx.v[i] * s.dx.v[i] + s.ny.v[i] * s.dy.v[i] + s.nz.v[i] * s.dz.v[i]);
        next.org_x[i] = s.px.v[i] + s.nx.v[i] * s.error.v[i];
        next.org_y[i] = s.py.v[i] + s.ny.v[i] * s.error.v[i];
        next.org_z[i] = s.pz.v[i] + s.nz.v[i] * s.error.v[i];
        next.dir_x[i] = s.dx.v[i] - s.nx.v[i] * twice;
        next.dir_y[i] = s.dy.v[i] - s.ny.v[i] * twice;
        next.dir_z[i] = s.dz.v[i] - s.nz.v[i] * twice;
        next.tfar[i] = 3.0e38F;
    }
}

void refract(const Surfaces& s, Rays& next) {
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) {
        const float cosine = -(s.nx.v[i] * s.dx.v[i] + s.ny.v[i] * s.dy.v[i] + s.nz.v[i] * s.dz.v[i]);
        const float eta = s.eta.v[i];
        const float inside = 1 - eta * eta * (1 - cosine * cosine);
        const float along_normal = eta * cosine - __builtin_sqrtf(inside > 0 ? inside : 0);
        next.org_x[i] = s.px.v[i] - s.nx.v[i] * s.error.v[i];
        next.org_y[i] = s.py.v[i] - s.ny.v[i] * s.error.v[i];
        next.org_z[i] = s.pz.v[i] - s.nz.v[i] * s.error.v[i];
        next.dir_x[i] = s.dx.v[i] * eta + s.nx.v[i] * along_normal;
        next.dir_y[i] = s.dy.v[i] * eta + s.ny.v[i] * along_normal;
        next.dir_z[i] = s.dz.v[i] * eta + s.nz.v[i] * along_normal;
        next.tfar[i] = 3.0e38F;
    }
}

void clear_hits(RayHits& packet) {
    start_rays(packet.ray);
#pragma omp simd
    for (int i = 0; i < kLanes; ++i) {
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
}

// Depth of the recursion is frame.max_depth, which the benchmark keeps small.
void follow(const RawView& view, RayHits& packet, const Mask& mask, std::uint32_t depth, RawCounts& counts) {
    intersect(mask, view.all, packet);
    counts.rays += static_cast<unsigned>(active_lanes(mask));
    Surfaces s;
    locate(packet, mask, s);
    if (active_lanes(s.found) == 0) return;
    if ((view.frame.features & kernel::FEATURE_SHADOWS) != 0) shadow_rays(view, s, counts);
    if (depth == view.frame.max_depth) return;
    branch(view, packet, s);
    alignas(64) RayHits next;
    if (active_lanes(s.mirrors) != 0) {
        clear_hits(next);
        reflect(s, next.ray);
        follow(view, next, s.mirrors, depth + 1, counts);
    }
    if (active_lanes(s.transmits) != 0) {
        clear_hits(next);
        refract(s, next.ray);
        follow(view, next, s.transmits, depth + 1, counts);
    }
}

}  // namespace

template <>
void trace_tile<RAW_LANES>(const RawView& view, int x0, int y0, int x1, int y1, RawCounts& counts) {
    const kernel::Camera& camera = view.frame.camera;
    const float to_x = 2.0F / static_cast<float>(view.frame.width);
    const float to_y = 2.0F / static_cast<float>(view.frame.height);
    for (int y = y0; y < y1; y += kBlockHeight) {
        for (int x = x0; x < x1; x += kBlockWidth) {
            alignas(64) RayHits packet;
            Mask mask;
            clear_hits(packet);
#pragma omp simd
            for (int i = 0; i < kLanes; ++i) {
                const int px = x + i % kBlockWidth, py = y + i / kBlockWidth;
                const float right = (static_cast<float>(px) + 0.5F) * to_x - 1;
                const float up = 1 - (static_cast<float>(py) + 0.5F) * to_y;
                const float dx = camera.center.x + camera.right.x * right + camera.up.x * up;
                const float dy = camera.center.y + camera.right.y * right + camera.up.y * up;
                const float dz = camera.center.z + camera.right.z * right + camera.up.z * up;
                const float scale = 1 / __builtin_sqrtf(dx * dx + dy * dy + dz * dz);
                packet.ray.org_x[i] = camera.eye.x;
                packet.ray.org_y[i] = camera.eye.y;
                packet.ray.org_z[i] = camera.eye.z;
                packet.ray.dir_x[i] = dx * scale, packet.ray.dir_y[i] = dy * scale, packet.ray.dir_z[i] = dz * scale;
                packet.ray.tfar[i] = 3.0e38F;
                mask.v[i] = px < x1 && py < y1 ? -1 : 0;
            }
            follow(view, packet, mask, 0, counts);
        }
    }
}

}  // namespace sundog::bench
