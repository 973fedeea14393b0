// SPDX-License-Identifier: Apache-2.0
// Which share of a matt surface's view something takes: form factors from a point, without anything in between.
#pragma once

#include "base/vec.h"

namespace sundog::bake {

/// The form factor from a point of a surface with a unit normal to a disc of that area around `center` whose unit axis
/// is `axis`, either of whose sides may be seen: with s = A / (pi r^2), it is s cos_j cos_i / (1 + s) (Wallace,
/// Elmquist and Haines, A Ray Tracing Algorithm for Progressive Radiosity, SIGGRAPH 1989), which is exact on the axis
/// for parallel surfaces, and for others right to the second order of the disc's size by s cos_i (2 - 3 cos_j^2) + s
/// n_i.n_j cos_j more in the place of cos_i: half the variance of the disc's points times the Laplacian, in its plane,
/// of cos_i cos_j / r^2. 0 where its middle is below the point's horizon.
float disc_form_factor(Vec3 point, Vec3 normal, Vec3 center, Vec3 axis, float area);

/// The exact form factor from a point of a surface with a unit normal to a triangle, whichever of its sides is seen:
/// half of each edge's angle over pi, times the cosine to the edge's plane (Lambert, Photometria, 1760; Baum, Rushmeier
/// and Winget, Improving Radiosity Solutions Through the Use of Analytically Determined Form-Factors, SIGGRAPH 1989).
/// What is below the point's horizon is cut off. Undefined for points of the
/// triangle itself.
float triangle_form_factor(Vec3 point, Vec3 normal, Vec3 a, Vec3 b, Vec3 c);

}  // namespace sundog::bake
