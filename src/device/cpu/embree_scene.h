// SPDX-License-Identifier: Apache-2.0
// A RenderScene as Embree geometry. Geometry IDs of the top-level scene are the RenderScene's geometry indices; planes
// are not in it (the kernel asks them one by one).
#pragma once

#include <memory>
#include <vector>

#include "device/cpu/embree.h"
#include "device/cpu/geometry_data.h"
#include "device/cpu/quick_solid.h"
#include "device/cpu/shape_callbacks.h"
#include "device/cpu/solid_callbacks.h"
#include "device/cpu/traversal.h"
#include "device/render_scene.h"

namespace sundog::cpu {

class EmbreeScene final : public Traversal {
public:
    /// Builds over the scene, which must outlive this; `shapes` are called for its spheres, boxes and solids. Errors:
    /// DeviceError (out of memory).
    EmbreeScene(RTCDevice device, const RenderScene& scene,
                ShapeCallbacks shapes = {intersect_shapes, occluded_by_shapes, intersect_solid, occluded_by_solid});

    /// Commits if anything changed.
    void update(const Frame& frame) override;

    [[nodiscard]] RTCScene handle() const override { return top_.get(); }

private:
    void add(std::uint32_t index);
    embree::Geometry make_geometry(GeometryData& data);
    void check(const char* doing) const;

    static void filter(const RTCFilterFunctionNArguments* args);
    static void set_filters(const GeometryData& data);

    RTCDevice device_;
    const RenderScene& scene_;
    ShapeCallbacks shapes_;
    embree::Scene top_;
    std::vector<std::unique_ptr<GeometryData>> data_;
    std::vector<std::unique_ptr<QuickSolid>> quick_;  ///< Of solids, for data_.
    std::vector<embree::Scene> moving_;               ///< One scene for each moving geometry, by instance.
    std::vector<RTCGeometry> instances_;    ///< Instance geometries in top_, by instance index; null for planes.
    std::vector<kernel::Instance> placed_;  ///< Placements last committed.
    bool culling_ = false;
    bool one_sided_ = false;
};

}  // namespace sundog::cpu
