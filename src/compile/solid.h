// SPDX-License-Identifier: Apache-2.0
// Exact solids: as primitives of the kernel where nothing is lost by that, else as what src/solids makes of them.
#pragma once

#include <functional>
#include <optional>

#include "base/diagnostics.h"
#include "compile/mesh.h"
#include "device/render_scene.h"
#include "scene/scene.h"

namespace sundog {

/// A run of primitives that was appended, or (GEOMETRY_SOLID) a solid.
struct SolidPart {
    kernel::Geometry geometry;
    std::shared_ptr<const solids::CompiledSolid> solid;  ///< Of a GEOMETRY_SOLID.
    Bounds3 bounds;                                      ///< Object space; empty where it has no end.
};

/// Which optional arrays the meshes in a solid need.
MeshAttributes solid_attributes(const scene::Solid& solid);

/// Splits flat unions, appends to the kernel's arrays the spheres, boxes, planes and meshes that need no exact solid,
/// and gives each part to `add` before the next one is appended. Errors: InputError for shapes that can't be.
void append_solid(const scene::Scene& scene, const scene::Object& object, const scene::Solid& solid,
                  MeshAttributes attributes, RenderScene& out, const WarningSink& warn,
                  const std::function<void(const SolidPart&)>& add);

}  // namespace sundog
