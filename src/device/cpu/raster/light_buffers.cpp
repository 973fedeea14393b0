// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/raster/light_buffers.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "device/cpu/tile_kernel.h"

namespace sundog::cpu::raster {
namespace {

using kernel::vec3;

/// Each side of a cube is scanned in so many parts.
constexpr int kParts = 2;
/// Of a lamp's place, relative to the size of its coordinates: nothing nearer is asked about.
constexpr float kNearest = 1e-3F;
/// Finer meshes than one triangle in so many pixels fill no cells, and take longer to scan.
constexpr std::size_t kPixelsPerTriangle = 64;
/// What isn't scanned is looked for by its box, one by one, which takes as long as so many triangles.
constexpr std::size_t kTrianglesPerThing = 8;

/// Faces are large from this share of the scene's extent on; they fill cells …
constexpr float kLarge = 1.0F / 16;
/// … and are worth it where they are at least this share of all area.
constexpr float kLargeShare = 0.25F;

std::size_t pixels_of(const Frame& frame) { return std::size_t{frame.params.width} * frame.params.height; }

/// What a side of the cube shows, as `unknown_shadows` counts: 0 and 1 along x, 2 and 3 along y, 4 and 5 along z.
EyeView side_view(const vec3& place, int face, int side) {
    const float way = face % 2 == 0 ? 1.0F : -1.0F;
    const int axis = face / 2;
    kernel::FrameParams frame{};
    frame.camera.eye = place;
    frame.camera.center = {axis == 0 ? way : 0, axis == 1 ? way : 0, axis == 2 ? way : 0};
    frame.camera.right = axis == 0 ? vec3(0, 1, 0) : vec3(1, 0, 0);
    frame.camera.up = axis == 2 ? vec3(0, -1, 0) : vec3(0, 0, -1);
    frame.width = frame.height = static_cast<kernel::uint>(side);
    frame.far_z = INFINITY;
    return eye_view_of(frame);
}

struct Areas {
    double all = 0, large = 0;
    Areas& operator+=(const Areas& a) {
        all += a.all;
        large += a.large;
        return *this;
    }
};

/// Of a geometry's triangles.
Areas areas_of(const RenderScene& scene, const kernel::Geometry& g) {
    const float large = kLarge * length(scene.bounds.extent());
    Areas areas;
    for (std::uint32_t i = g.first_primitive; i < g.first_primitive + g.primitive_count; ++i) {
        const kernel::Triangle& t = scene.triangles[i];
        const vec3 u = scene.positions[t.p1] - scene.positions[t.p0], v = scene.positions[t.p2] - scene.positions[t.p0];
        const double area = kernel::length(kernel::cross(u, v));
        if (!std::isfinite(area)) continue;
        areas.all += area;
        if (std::max(kernel::length(u), kernel::length(v)) >= large) areas.large += area;
    }
    return areas;
}

bool buffered(const kernel::Light& light) {
    return (light.kind == kernel::LIGHT_LAMP || light.kind == kernel::LIGHT_SPOT) &&
           (light.flags & kernel::LIGHT_SHADOWS) != 0 && light.area_count_u * light.area_count_v <= 1 &&
           light.projection == 0;
}

bool same_instances(const std::vector<kernel::Instance>& a, const std::vector<kernel::Instance>& b) {
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): other bits of the same number only cost another buffer
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

}  // namespace

CellKernel cell_kernel(int lanes) { return lanes == 16 ? scan_cells_16 : lanes == 8 ? scan_cells_8 : scan_cells_4; }

LightBuffers::LightBuffers(const RenderScene& scene, CellKernel kernel)
    : scene_(scene), kernel_(kernel), traced_things_(scene), opaque_(scene.triangles.size(), 0) {
    Areas areas;
    for (const kernel::Geometry& g : scene.geometries) {
        if (g.kind != kernel::GEOMETRY_TRIANGLES || g.instance != kernel::NONE || g.primitive_count == 0) continue;
        runs_.push_back({g.first_primitive, g.primitive_count});
        triangle_count_ += g.primitive_count;
        areas += areas_of(scene, g);
        if ((g.hidden_from & kernel::RAY_SHADOW) != 0) continue;
        for (std::uint32_t i = g.first_primitive; i < g.first_primitive + g.primitive_count; ++i)
            if ((scene.materials[scene.triangles[i].material].flags & kernel::MATERIAL_TRANSPARENT) == 0)
                opaque_[i] = kernel::LIGHT_CELL_BLOCKS;
    }
    has_large_faces_ = areas.large > 0 && areas.large >= kLargeShare * areas.all;
}

bool LightBuffers::pays(const Frame& frame) const {
    // What lies in the air dims light that meets nothing; back faces that aren't there block none; planes aren't
    // scanned.
    constexpr std::uint32_t kOthers = kernel::FEATURE_ATMOSPHERE | kernel::FEATURE_MEDIA | kernel::FEATURE_PHOTONS |
                                      kernel::FEATURE_CAUSTICS | kernel::FEATURE_CULL;
    if ((frame.params.features & kOthers) != 0 || (frame.params.features & kernel::FEATURE_SHADOWS) == 0 ||
        frame.params.plane_count > 0 || !has_large_faces_ ||
        (triangle_count_ + traced_things_.count() * kTrianglesPerThing) * kPixelsPerTriangle > pixels_of(frame))
        return false;
    for (std::uint32_t i = 0; i < frame.params.light_count; ++i)
        if (buffered(frame.lights[i])) return true;
    return false;
}

void LightBuffers::prepare(const Frame& frame) {
    const int side = pixels_of(frame) > 800000 ? 256 : 128;
    buffers_.resize(frame.lights.size());
    cells_.assign(frame.lights.size(), {});
    for (std::uint32_t i = 0; i < frame.params.light_count; ++i) {
        const kernel::Light& light = frame.lights[i];
        if (!buffered(light)) continue;
        Buffer& buffer = buffers_[i];
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): other bits of the same number only cost another buffer
        if (buffer.side != side || std::memcmp(&buffer.place, &light.place, sizeof light.place) != 0 ||
            !same_instances(buffer.instances, frame.instances)) {
            buffer.place = light.place;
            buffer.side = side;
            buffer.instances = frame.instances;
            fill(buffer, frame);
        }
        const float size = std::abs(light.place.x) + std::abs(light.place.y) + std::abs(light.place.z);
        cells_[i] = {buffer.cells.data(), static_cast<kernel::uint>(side), kNearest * size};
    }
}

void LightBuffers::fill(Buffer& buffer, const Frame& frame) const {
    const int side = buffer.side, rows = side / kParts;
    buffer.cells.resize(std::size_t{6} * static_cast<std::size_t>(side * side));
    const kernel::SceneView scene_view = view_of(scene_, frame, nullptr);
    tbb::enumerable_thread_specific<CellScratch> scratch;
    const float size = std::abs(buffer.place.x) + std::abs(buffer.place.y) + std::abs(buffer.place.z);
    tbb::parallel_for(0, 6 * kParts, [&](int part) {
        const EyeView view = side_view(buffer.place, part / kParts, side);
        const std::vector<PixelRect> unknown = traced_things_.rects(frame, view);
        const int begin = part % kParts * rows;
        kernel_({scene_view, view, runs_, opaque_, unknown, side, begin, begin + rows, 1 / (kNearest * size + 1e-30F),
                 buffer.cells.data() + static_cast<std::ptrdiff_t>(part) * rows * side},
                scratch.local());
    });
}

}  // namespace sundog::cpu::raster
