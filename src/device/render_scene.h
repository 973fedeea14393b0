// SPDX-License-Identifier: Apache-2.0
// What devices are given: the compiled scene (fixed) and the frame (new for every picture).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/vec.h"
#include "kernel/shared.h"

namespace sundog {

namespace render_scene_detail {
// The kernel's types, under the names that kernel/arrays.h uses.
using namespace kernel;
struct Arrays {
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) std::vector<type> name;
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
};
}  // namespace render_scene_detail

namespace solids {
class CompiledSolid;
}

/// The solid that a Geometry of kind GEOMETRY_SOLID stands for. Its hits' materials are indices into `materials`.
struct PlacedSolid {
    std::shared_ptr<const solids::CompiledSolid> solid;
    std::uint32_t geometry = 0;  ///< Index into `geometries`.
    SourceLocation where;        ///< Of the object in the scene's file.
};

/// A compiled scene: the kernel's arrays (see kernel/arrays.h), immutable once made by compile(), shared by devices.
struct RenderScene : render_scene_detail::Arrays {
    std::uint32_t features = 0;  ///< FEATURE_* bits that the scene itself needs (shadows and culling are the frame's).
    Bounds3 bounds;              ///< World bounds of all finite geometry at rest.
    std::vector<std::string> geometry_names;      ///< One for each of `geometries`; the scene object's name.
    std::vector<std::uint32_t> geometry_objects;  ///< One for each of `geometries`: index into Scene::objects.
    std::vector<std::string> material_names;      ///< One for each of `materials`.
    std::uint32_t atmosphere = kernel::NONE;      ///< Media that are everywhere: a list of them in `code`.
    std::vector<SourceLocation> media_places;     ///< Of all media in the scene's file.
    std::vector<PlacedSolid> solids;              ///< Ascending by geometry.
};

/// Bytes of all arrays.
std::size_t memory_bytes(const RenderScene& scene);

/// Everything about a picture that is not the RenderScene. `lights` and `instances` are never empty (one zeroed
/// element stands in; params.light_count says how many lights count).
struct Frame {
    kernel::FrameParams params{};
    std::vector<kernel::Light> lights;
    std::vector<kernel::Instance> instances;  ///< As many as the scene's geometries refer to.
};

}  // namespace sundog
