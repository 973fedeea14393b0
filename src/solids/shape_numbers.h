// SPDX-License-Identifier: Apache-2.0
// Shapes as plain numbers, for devices that find them on rays by code of their own.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec3d.h"

namespace sundog::solids {

/// A shape's kind and what tells it from others of its kind, in the shape's own space:
///   sphere      center, radius
///   box         lower and upper corner
///   half_space  normal, distance
///   cone        base, height, axis (unit), radius at the base, its growth per height, 1 if it lacks its end discs
///   quadric     the symmetric matrix's xx, yy, zz, xy, xz, yz, then what is linear, then the constant
///   disc        center, normal (unit), radius, the hole's radius
///   torus       major and minor radius
struct ShapeNumbers {
    enum class Kind : std::uint8_t { none, sphere, box, half_space, cone, quadric, disc, torus };
    Kind kind = Kind::none;
    std::vector<double> values;

    ShapeNumbers& add(double value) {
        values.push_back(value);
        return *this;
    }
    ShapeNumbers& add(Vec3d v) { return add(v.x).add(v.y).add(v.z); }
};

}  // namespace sundog::solids
