// SPDX-License-Identifier: Apache-2.0
// The scenes of Haines, "A Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications 7(11),
// 1987 (the Standard Procedural Databases), written anew from their description: what is in them, how it is laid out,
// about how much of it, the eye and the lights. Coordinates needn't be those of Haines' programs to the last digit.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace sundog::bench {

/// A sphere with nine smaller ones on it, each with nine on it, four levels deep: 7,381 spheres on a square.
scene::Scene spd_balls();
/// 4x4x4 gears that mesh, each of a contour of 144 sides.
scene::Scene spd_gears();
/// A fractal mountain of 8,192 triangles with four glass balls.
scene::Scene spd_mount();
/// A pyramid of 140 dodecahedral rings: 4,200 spheres and 4,200 cylinders.
scene::Scene spd_rings();
/// A tetrahedron of tetrahedra of tetrahedra …: 4,096 triangles.
scene::Scene spd_tetra();
/// A tree without leaves: 4,095 cones and 4,095 spheres.
scene::Scene spd_tree();

/// A closed mesh like that of a scanned carving: 2*around*along small, uneven triangles on a bumpy knot. Not one of
/// Haines'.
scene::Scene scanned_knot(int around, int along);

}  // namespace sundog::bench
