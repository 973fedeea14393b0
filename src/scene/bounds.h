// SPDX-License-Identifier: Apache-2.0
// Where the things of a scene are.
#pragma once

#include "base/vec.h"
#include "scene/scene.h"

namespace sundog::scene {

/// Bounds of what an object's surface uses, at rest. Empty for planes, which have no end, and for empty meshes.
Bounds3 bounds_of(const Object& object);

/// Whether they have a point in common.
inline bool overlap(const Bounds3& a, const Bounds3& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y &&
           a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

/// Bounds of all finite objects at rest; of those that move with a node, where they are at first.
Bounds3 bounds_of(const Scene& scene);

}  // namespace sundog::scene
