// SPDX-License-Identifier: Apache-2.0
// A scene's surfaces as triangles small enough to carry light at their corners.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace sundog::bake {

/// The triangles of one object that have one material, in world space. All arrays but those of triangles are parallel.
struct Part {
    std::string object;
    std::size_t source = 0;  ///< Which of the scene's objects.
    scene::Index material = 0;
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;    ///< Unit, on the surface's front.
    std::vector<Vec2> texcoords;  ///< v upwards; 0 where the object has none.
    std::vector<Vec3> inside;     ///< A place beside each vertex in the middle of a face, where its light is asked.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint32_t, 3>> undivided;  ///< The same surface in as few as will do.
    std::vector<Vec3> light;  ///< Once baked: linear RGB radiance; of textured materials, what it is of white ones.
};

/// Surfaces at a moment, divided until no edge is longer than `longest_edge`; neighbours are divided alike, so that no
/// cracks come up. Planes and exact solids have no triangles: they are left out with a warning, but light the others.
/// Errors: InputError where that would be more than `kMostVertices`.
std::vector<Part> parts_of(const scene::Scene& scene, float time_s, float longest_edge, const WarningSink& warn);

inline constexpr std::size_t kMostVertices = 50'000'000;

}  // namespace sundog::bake
