// SPDX-License-Identifier: Apache-2.0
// The pattern `quilted` (POV-Ray reference, section 3.4.7.1.21): cells of size 1 with seams.
#pragma once

#include <cmath>

#include "base/vec3d.h"

namespace sundog::fields {

/// From the middle of the cell that p lies in: -0.5 to 0.5.
inline Vec3d from_cell_middle(Vec3d p) {
    return {p.x - std::floor(p.x) - 0.5, p.y - std::floor(p.y) - 0.5, p.z - std::floor(p.z) - 0.5};
}

/// The seam's height at a distance from the middle of a cell; the control values bend its foot and its top.
inline double quilted_curve(double control0, double control1, double u) {
    return u * (2.0 / 3 * u * u + 2 * control0 * (1 - u) * (1 - u) + 2 * control1 * u * (1 - u));
}

}  // namespace sundog::fields
