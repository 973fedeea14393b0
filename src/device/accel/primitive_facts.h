// SPDX-License-Identifier: Apache-2.0
// What is known of a RenderScene's primitives without a ray.
#pragma once

#include <cstdint>

#include "device/render_scene.h"

namespace sundog::accel {

/// Hits so near to each other, relative to their distance, are at one place: single precision tells them apart by
/// chance, pixel by pixel.
inline constexpr float kCoincident = 1e-6F;

/// Spheres from this radius on are found in double: where a ray leaves a planet, numbers of floats are too coarse to
/// tell that it does.
inline constexpr float kLargeRadius = 1000;

/// The material of a triangle, sphere or box.
inline std::uint32_t material_of(const RenderScene& scene, const kernel::Geometry& geometry, std::uint32_t primitive) {
    const std::uint32_t i = geometry.first_primitive + primitive;
    switch (geometry.kind) {
        case kernel::GEOMETRY_SPHERE:
            return scene.spheres[i].material;
        case kernel::GEOMETRY_BOX:
            return scene.boxes[i].material;
        default:
            return scene.triangles[i].material;
    }
}

}  // namespace sundog::accel
