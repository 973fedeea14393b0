// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/embree_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "base/diagnostics.h"

namespace sundog::cpu {
namespace {

using kernel::NONE;

/// The placement as Embree takes it: a 3x4 matrix by columns.
std::array<float, 12> columns_of(const kernel::Instance& i) {
    return {i.world_from_object_x.x, i.world_from_object_x.y, i.world_from_object_x.z, i.world_from_object_y.x,
            i.world_from_object_y.y, i.world_from_object_y.z, i.world_from_object_z.x, i.world_from_object_z.y,
            i.world_from_object_z.z, i.world_from_object_t.x, i.world_from_object_t.y, i.world_from_object_t.z};
}

/// True where a triangle isn't there for rays of that kind that come from behind.
bool culls_triangle(const GeometryData& data, std::uint32_t primitive, std::uint32_t ray_kind) {
    const kernel::Triangle& triangle = data.scene->triangles[data.geometry.first_primitive + primitive];
    const std::uint32_t flags = data.scene->materials[triangle.material].flags;
    return (data.culling && (flags & kernel::MATERIAL_TRANSPARENT) == 0) ||
           (data.one_sided && (ray_kind & kernel::RAY_CAMERA) != 0 && (flags & kernel::MATERIAL_ONE_SIDED) != 0);
}

}  // namespace

EmbreeScene::EmbreeScene(RTCDevice device, const RenderScene& scene, ShapeCallbacks shapes)
    : device_(device), scene_(scene), shapes_(shapes), top_(rtcNewScene(device)) {
    rtcSetSceneBuildQuality(top_.get(), RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSceneFlags(top_.get(), RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t i = 0; i < scene.geometries.size(); ++i)
        if (scene.geometries[i].primitive_count > 0 && scene.geometries[i].kind != kernel::GEOMETRY_PLANE) add(i);
    rtcCommitScene(top_.get());
    check("building acceleration structures");
}

void EmbreeScene::check(const char* doing) const {
    switch (rtcGetDeviceError(device_)) {
        case RTC_ERROR_NONE:
            return;
        case RTC_ERROR_OUT_OF_MEMORY:
            throw DeviceError(std::string("out of memory ") + doing);
        default:
            throw DeviceError(std::string("Embree failed ") + doing);
    }
}

embree::Geometry EmbreeScene::make_geometry(GeometryData& data) {
    const kernel::Geometry& g = data.geometry;
    const bool triangles = g.kind == kernel::GEOMETRY_TRIANGLES;
    embree::Geometry geometry(rtcNewGeometry(device_, triangles ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_USER));
    if (triangles) {
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   scene_.positions.data(), 0, sizeof(kernel::vec3), scene_.positions.size() - 1);
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, scene_.triangles.data(),
                                   sizeof(kernel::Triangle) * g.first_primitive, sizeof(kernel::Triangle),
                                   g.primitive_count);
    } else {
        const bool solid = g.kind == kernel::GEOMETRY_SOLID;
        rtcSetGeometryUserPrimitiveCount(geometry.get(), g.primitive_count);
        rtcSetGeometryBoundsFunction(geometry.get(), solid ? solid_bounds : shape_bounds, &data);
        rtcSetGeometryIntersectFunction(geometry.get(), solid ? shapes_.intersect_solid : shapes_.intersect);
        rtcSetGeometryOccludedFunction(geometry.get(), solid ? shapes_.occluded_by_solid : shapes_.occluded);
    }
    // What may be seen is for the callbacks to say; Embree 4 would compare masks by itself, and starts with 1.
    rtcSetGeometryMask(geometry.get(), 0xffffffffU);
    rtcSetGeometryUserData(geometry.get(), &data);
    data.handle = geometry.get();
    set_filters(data);
    rtcCommitGeometry(geometry.get());
    return geometry;
}

/// Triangles are Embree's own: what a frame or a geometry leaves out of them, a filter does.
void EmbreeScene::set_filters(const GeometryData& data) {
    if (data.geometry.kind != kernel::GEOMETRY_TRIANGLES) return;
    const bool filters = data.culling || data.visible_to != kernel::RAY_ALL;
    rtcSetGeometryIntersectFilterFunction(data.handle, filters || data.one_sided ? filter : nullptr);
    rtcSetGeometryOccludedFilterFunction(data.handle, filters ? filter : nullptr);
}

void EmbreeScene::add(std::uint32_t index) {
    const kernel::Geometry& g = scene_.geometries[index];
    data_.push_back(std::make_unique<GeometryData>(GeometryData{&scene_, g}));
    GeometryData& data = *data_.back();
    data.visible_to = kernel::RAY_ALL & ~g.hidden_from;
    if (g.kind == kernel::GEOMETRY_SOLID) {
        const auto placed = std::lower_bound(scene_.solids.begin(), scene_.solids.end(), index,
                                             [](const PlacedSolid& s, std::uint32_t i) { return s.geometry < i; });
        if (placed == scene_.solids.end() || placed->geometry != index)
            throw DeviceError("geometry " + std::to_string(index) + " is a solid, but the scene holds none for it");
        data.solid = placed->solid.get();
        auto quick = std::make_unique<QuickSolid>(*data.solid);
        if (quick->useful()) {
            data.quick = quick.get();
            quick_.push_back(std::move(quick));
        }
    }
    const embree::Geometry geometry = make_geometry(data);
    if (g.instance == NONE) {
        rtcAttachGeometryByID(top_.get(), geometry.get(), index);
        return;
    }
    embree::Scene object(rtcNewScene(device_));
    rtcSetSceneFlags(object.get(), RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometryByID(object.get(), geometry.get(), 0);
    rtcCommitScene(object.get());
    const embree::Geometry instance(rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(instance.get(), object.get());
    rtcSetGeometryTimeStepCount(instance.get(), 1);
    rtcSetGeometryMask(instance.get(), 0xffffffffU);
    rtcCommitGeometry(instance.get());
    rtcAttachGeometryByID(top_.get(), instance.get(), index);
    if (instances_.size() <= g.instance) instances_.resize(g.instance + 1, nullptr);
    instances_[g.instance] = instance.get();
    moving_.push_back(std::move(object));
}

void EmbreeScene::update(const Frame& frame) {
    bool changed = false;
    const bool cull_now = (frame.params.features & kernel::FEATURE_CULL) != 0;
    const bool one_sided_now = (frame.params.features & kernel::FEATURE_ONE_SIDED) != 0;
    if (cull_now != culling_ || one_sided_now != one_sided_) {
        culling_ = cull_now;
        one_sided_ = one_sided_now;
        for (const std::unique_ptr<GeometryData>& data : data_) {
            data->culling = cull_now;
            data->one_sided = one_sided_now;
            if (data->geometry.kind != kernel::GEOMETRY_TRIANGLES) continue;  // shapes of ours cull by themselves
            set_filters(*data);
            rtcCommitGeometry(data->handle);
        }
        for (const embree::Scene& object : moving_) rtcCommitScene(object.get());
        changed = true;
    }
    placed_.resize(instances_.size());
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): other bits of the same number only cost an update
        if (!instances_[i] || std::memcmp(&placed_[i], &frame.instances[i], sizeof placed_[i]) == 0) continue;
        placed_[i] = frame.instances[i];
        const std::array<float, 12> columns = columns_of(placed_[i]);
        rtcSetGeometryTransform(instances_[i], 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
        rtcCommitGeometry(instances_[i]);
        changed = true;
    }
    if (changed) {
        rtcCommitScene(top_.get());
        check("updating acceleration structures");
    }
}

void EmbreeScene::filter(const RTCFilterFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    const unsigned n = args->N;
    for (unsigned lane = 0; lane < n; ++lane) {
        if (args->valid[lane] == 0) continue;
        if ((RTCRayN_mask(args->ray, n, lane) & data.visible_to) == 0) {
            args->valid[lane] = 0;
            continue;
        }
        if (!culls_triangle(data, RTCHitN_primID(args->hit, n, lane), RTCRayN_mask(args->ray, n, lane))) continue;
        const float facing = RTCHitN_Ng_x(args->hit, n, lane) * RTCRayN_dir_x(args->ray, n, lane) +
                             RTCHitN_Ng_y(args->hit, n, lane) * RTCRayN_dir_y(args->ray, n, lane) +
                             RTCHitN_Ng_z(args->hit, n, lane) * RTCRayN_dir_z(args->ray, n, lane);
        if (facing >= 0) args->valid[lane] = 0;
    }
}

}  // namespace sundog::cpu
