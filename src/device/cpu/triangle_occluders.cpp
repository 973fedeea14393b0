// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/triangle_occluders.h"

#include <cstring>
#include <string>

#include "base/diagnostics.h"
#include "device/cpu/embree.h"

namespace sundog::cpu {
namespace {

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
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene, geometry.get());
    }
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw DeviceError("Embree failed building what stops light");
}

TriangleOccluders::~TriangleOccluders() = default;

bool TriangleOccluders::between(Vec3 from, Vec3 to) const {
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
    any_hit(embree_->scene.get(), ray);
    return ray.tfar < 0;
}

}  // namespace sundog::cpu
