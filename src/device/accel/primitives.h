// SPDX-License-Identifier: Apache-2.0
// What a structure holds: primitives of a RenderScene, numbered from 0, and their boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "device/render_scene.h"

namespace sundog::accel {

/// Which primitive of which geometry.
struct Item {
    std::uint32_t geometry = 0;
    std::uint32_t primitive = 0;  ///< Counted from the geometry's first.
};

/// A run of items that belong to one object.
struct Run {
    std::uint32_t first = 0, count = 0;
};

/// Items in one space, the world's or that of a moving geometry. Those whose bounds are not finite or reach farther
/// than 1e18 are left out, as Embree does.
class Primitives {
public:
    explicit Primitives(const RenderScene& scene);

    /// Appends all primitives of a geometry that isn't a plane.
    void add(std::uint32_t geometry);
    /// Moves items without an end (solids that reach kFarthest) out of this and returns them: in a structure they would
    /// make all others look like a point.
    std::vector<Item> take_endless();

    [[nodiscard]] const RenderScene& scene() const { return *scene_; }
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(items_.size()); }
    [[nodiscard]] const Item& item(std::uint32_t i) const { return items_[i]; }
    [[nodiscard]] const Bounds3& bounds(std::uint32_t i) const { return bounds_[i]; }
    [[nodiscard]] std::span<const Bounds3> bounds() const { return bounds_; }
    /// One for each object, in order.
    [[nodiscard]] std::vector<Run> objects() const;
    /// Of all items.
    [[nodiscard]] Bounds3 total_bounds() const;
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    const RenderScene* scene_;
    std::vector<Item> items_;
    std::vector<Bounds3> bounds_;
};

/// The solid of a GEOMETRY_SOLID; null if the scene holds none for it.
const solids::CompiledSolid* solid_of(const RenderScene& scene, std::uint32_t geometry);

}  // namespace sundog::accel
