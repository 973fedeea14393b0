// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/triangle_occluders.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "base/diagnostics.h"
#include "device/cpu/embree.h"

namespace sundog::cpu {
namespace {

/// A query that remembers the smallest number of what it meets, and goes on.
struct Collector {
    embree::Context context = embree::make_context();  // first: callbacks are given its address
    std::uint32_t smallest = RTC_INVALID_GEOMETRY_ID;
};

void collect(const RTCFilterFunctionNArguments* args) {
    auto& collector = *reinterpret_cast<Collector*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        collector.smallest = std::min(collector.smallest, RTCHitN_primID(args->hit, args->N, i));
        args->valid[i] = 0;
    }
}

RTCRay ray_between(Vec3 from, Vec3 to) {
    RTCRay ray{};
    ray.org_x = from.x;
    ray.org_y = from.y;
    ray.org_z = from.z;
    ray.dir_x = to.x - from.x;
    ray.dir_y = to.y - from.y;
    ray.dir_z = to.z - from.z;
    ray.tnear = 0;
    ray.tfar = 1;
    ray.mask = 0xffffffffU;
    return ray;
}

void all_hits(RTCScene scene, RTCRayHit& ray, Collector& collector) {
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &collector.context;
    rtcIntersect1(scene, &ray, &arguments);
#else
    rtcIntersect1(scene, &collector.context, &ray);
#endif
}

void any_hit(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray, nullptr);
#else
    embree::Context context = embree::make_context();
    rtcOccluded1(scene, &context, &ray);
#endif
}

}  // namespace

struct TriangleOccluders::Embree {
    embree::Device device;
    embree::Scene scene;
};

TriangleOccluders::TriangleOccluders(std::span<const Vec3> positions,
                                     std::span<const std::array<std::uint32_t, 3>> triangles, int threads)
    : embree_(std::make_unique<Embree>()) {
    embree_->device.reset(rtcNewDevice(threads > 0 ? ("threads=" + std::to_string(threads)).c_str() : nullptr));
    RTCDevice const device = embree_->device.get();
    if (device == nullptr) throw DeviceError("Embree can't start on this processor");
    embree_->scene.reset(rtcNewScene(device));
    RTCScene const scene = embree_->scene.get();
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    if (!triangles.empty()) {
        const embree::Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
        void* const vertices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                       sizeof(Vec3), positions.size());
        void* const indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                      sizeof(triangles[0]), triangles.size());
        if (vertices == nullptr || indices == nullptr) throw DeviceError("out of memory for what stops light");
        std::memcpy(vertices, positions.data(), positions.size_bytes());
        std::memcpy(indices, triangles.data(), triangles.size_bytes());
        rtcSetGeometryIntersectFilterFunction(geometry.get(), collect);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene, geometry.get());
    }
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw DeviceError("Embree failed building what stops light");
}

TriangleOccluders::~TriangleOccluders() = default;

bool TriangleOccluders::between(Vec3 from, Vec3 to) const {
    RTCRay ray = ray_between(from, to);
    any_hit(embree_->scene.get(), ray);
    return ray.tfar < 0;
}

std::optional<std::uint32_t> TriangleOccluders::first_between(Vec3 from, Vec3 to) const {
    RTCRayHit ray{};
    ray.ray = ray_between(from, to);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    Collector collector;
    all_hits(embree_->scene.get(), ray, collector);
    if (collector.smallest == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return collector.smallest;
}

}  // namespace sundog::cpu
