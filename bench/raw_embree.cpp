// SPDX-License-Identifier: Apache-2.0
#include "raw_embree.h"

#include <fmt/format.h>
#include <tbb/blocked_range2d.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>

#include "base/diagnostics.h"
#include "raw_packets.h"

namespace sundog::bench {

namespace {

constexpr int kTile = 32;

struct DeviceDeleter {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneDeleter {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using DeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, DeviceDeleter>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, SceneDeleter>;

bool transparent(const kernel::Material& material) {
    return std::max({material.transmittance.x, material.transmittance.y, material.transmittance.z}) > 0;
}

/// Primitives of one kind that are all opaque or all transparent.
struct Part {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<kernel::TriangleCorners> normals;
    std::vector<std::array<float, 4>> spheres;
    std::vector<std::uint32_t> materials;
};

int widest() {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) return 16;
    return __builtin_cpu_supports("avx2") ? 8 : 4;
}

}  // namespace

struct RawEmbree::Impl {
    std::shared_ptr<const RenderScene> scene;
    tbb::task_arena arena;
    int lanes;
    DeviceHandle device{rtcNewDevice("")};
    SceneHandle all, opaque;
    std::array<Part, 4> parts;  ///< Triangles and spheres, opaque ones first.
    std::array<RawGeometry, 4> geometries{};

    Impl(std::shared_ptr<const RenderScene> scene_, int threads, int lanes_)
        : scene(std::move(scene_)), arena(threads), lanes(lanes_) {
        all.reset(rtcNewScene(device.get()));
        opaque.reset(rtcNewScene(device.get()));
        sort_primitives();
        for (unsigned id = 0; id < parts.size(); ++id) attach(id);
        rtcCommitScene(all.get());
        rtcCommitScene(opaque.get());
    }

    void sort_primitives() {
        const bool smooth = (scene->features & kernel::FEATURE_SMOOTH) != 0;
        for (const kernel::Geometry& geometry : scene->geometries) {
            for (std::uint32_t k = 0; k < geometry.primitive_count; ++k) {
                const std::uint32_t i = geometry.first_primitive + k;
                if (geometry.kind == kernel::GEOMETRY_TRIANGLES) {
                    const kernel::Triangle& t = scene->triangles[i];
                    Part& part = parts[transparent(scene->materials[t.material]) ? 2 : 0];
                    part.triangles.push_back({t.p0, t.p1, t.p2});
                    if (smooth) part.normals.push_back(scene->triangle_normals[i]);
                    part.materials.push_back(t.material);
                } else {
                    const kernel::Sphere& s = scene->spheres[i];
                    Part& part = parts[transparent(scene->materials[s.material]) ? 3 : 1];
                    part.spheres.push_back({s.center.x, s.center.y, s.center.z, s.radius});
                    part.materials.push_back(s.material);
                }
            }
        }
    }

    void attach(unsigned id) {
        const Part& part = parts[id];
        geometries[id] = {part.materials.data(), part.normals.empty() ? nullptr : part.normals.data()};
        if (part.materials.empty()) return;
        const bool triangles = !part.triangles.empty();
        RTCGeometry geometry =
            rtcNewGeometry(device.get(), triangles ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_SPHERE_POINT);
        if (triangles) {
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, scene->positions.data(),
                                       0, sizeof(kernel::vec3), scene->positions.size() - 1);
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, part.triangles.data(), 0,
                                       sizeof(part.triangles[0]), part.triangles.size());
        } else {
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, part.spheres.data(), 0,
                                       sizeof(part.spheres[0]), part.spheres.size());
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(all.get(), geometry, id);
        if (id < 2) rtcAttachGeometryByID(opaque.get(), geometry, id);
        rtcReleaseGeometry(geometry);
    }
};

RawEmbree::RawEmbree(std::shared_ptr<const RenderScene> scene, int threads, int lanes) {
    for (const kernel::Geometry& geometry : scene->geometries) {
        const bool drawable = geometry.kind == kernel::GEOMETRY_TRIANGLES || geometry.kind == kernel::GEOMETRY_SPHERE;
        if (geometry.primitive_count > 0 && (!drawable || geometry.instance != kernel::NONE))
            throw DeviceError("the raw Embree measurement takes triangles and spheres at rest only");
    }
    if (lanes > widest()) throw DeviceError(fmt::format("this processor has no {} lanes", lanes));
    impl_ = std::make_unique<Impl>(std::move(scene), threads, lanes == 0 ? widest() : lanes);
}

RawEmbree::~RawEmbree() = default;

std::string RawEmbree::name() const {
    return fmt::format("Embree {}, packets of {}", RTC_VERSION_STRING, impl_->lanes);
}

RawFrame RawEmbree::trace(const Frame& frame) {
    const RawView view{impl_->all.get(),
                       impl_->opaque.get(),
                       impl_->geometries.data(),
                       impl_->scene->materials.data(),
                       impl_->scene->normals.data(),
                       frame.lights.data(),
                       frame.params};
    auto* const trace_one_tile = impl_->lanes == 16  ? &trace_tile<16>
                                 : impl_->lanes == 8 ? &trace_tile<8>
                                                     : &trace_tile<4>;
    const int width = static_cast<int>(frame.params.width), height = static_cast<int>(frame.params.height);
    tbb::combinable<RawCounts> counts;
    impl_->arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range2d<int>(0, (height + kTile - 1) / kTile, 1, 0, (width + kTile - 1) / kTile, 1),
            [&](const tbb::blocked_range2d<int>& tiles) {
                RawCounts& local = counts.local();
                for (int y = tiles.rows().begin(); y < tiles.rows().end(); ++y)
                    for (int x = tiles.cols().begin(); x < tiles.cols().end(); ++x)
                        trace_one_tile(view, x * kTile, y * kTile, std::min((x + 1) * kTile, width),
                                       std::min((y + 1) * kTile, height), local);
            });
    });
    RawFrame total;
    counts.combine_each([&](const RawCounts& c) {
        total.rays += c.rays;
        total.shadow_rays += c.shadow_rays;
        total.blocked += c.blocked;
    });
    return total;
}

}  // namespace sundog::bench
