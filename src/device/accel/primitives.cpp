// SPDX-License-Identifier: Apache-2.0
#include "device/accel/primitives.h"

#include <algorithm>
#include <cmath>

#include "device/accel/primitive_bounds.h"

namespace sundog::accel {
namespace {

constexpr float kLargestCoordinate = 1e18F;

bool is_bounded(const Bounds3& box, float farthest) {
    const auto fits = [&](float v) { return std::abs(v) <= farthest; };  // not so for NaN
    return fits(box.lower.x) && fits(box.lower.y) && fits(box.lower.z) && fits(box.upper.x) && fits(box.upper.y) &&
           fits(box.upper.z);
}

}  // namespace

Primitives::Primitives(const RenderScene& scene) : scene_(&scene) {}

void Primitives::add(std::uint32_t geometry) {
    const kernel::Geometry& g = scene_->geometries[geometry];
    for (std::uint32_t i = 0; i < g.primitive_count; ++i) {
        Bounds3 box;
        if (g.kind != kernel::GEOMETRY_SOLID) box = bounds_of(*scene_, g, i);
        else if (const solids::CompiledSolid* solid = solid_of(*scene_, geometry)) box = bounds_of_solid(*solid);
        box = roomy(box);
        if (!is_bounded(box, kLargestCoordinate)) continue;
        items_.push_back({geometry, i});
        bounds_.push_back(box);
    }
}

std::vector<Item> Primitives::take_endless() {
    std::vector<Item> endless;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const bool solid = scene_->geometries[items_[i].geometry].kind == kernel::GEOMETRY_SOLID;
        if (solid && !is_bounded(bounds_[i], kFarthest / 2)) {
            endless.push_back(items_[i]);
            continue;
        }
        items_[kept] = items_[i];
        bounds_[kept] = bounds_[i];
        ++kept;
    }
    items_.resize(kept);
    bounds_.resize(kept);
    return endless;
}

std::vector<Run> Primitives::objects() const {
    std::vector<Run> runs;
    for (std::uint32_t i = 0; i < size(); ++i) {
        if (i == 0 || items_[i].geometry != items_[i - 1].geometry) runs.push_back({i, 0});
        ++runs.back().count;
    }
    return runs;
}

Bounds3 Primitives::total_bounds() const {
    Bounds3 total;
    for (const Bounds3& box : bounds_) total.include(box);
    return total;
}

std::size_t Primitives::memory_bytes() const {
    return items_.capacity() * sizeof(Item) + bounds_.capacity() * sizeof(Bounds3);
}

const solids::CompiledSolid* solid_of(const RenderScene& scene, std::uint32_t geometry) {
    const auto placed = std::lower_bound(scene.solids.begin(), scene.solids.end(), geometry,
                                         [](const PlacedSolid& s, std::uint32_t i) { return s.geometry < i; });
    return placed != scene.solids.end() && placed->geometry == geometry ? placed->solid.get() : nullptr;
}

}  // namespace sundog::accel
