// SPDX-License-Identifier: Apache-2.0
// Shapes as plain numbers, for devices that find them on rays by code of their own.
#pragma once

#include <array>
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
///   polynomial  order (3 to 6), how many terms; of each, exponents of x, y and z, and its coefficient
///   polygon     normal, a point of its plane, the numbers of two axes, how many edges; of each, both ends
///               along those axes
///   prism       (no conic ones) lower and upper end, 1 if they are open, how many pieces its outlines have;
///               of each, Bernstein's four coefficients of x and of z
///   revolution  1 if its ends are open, lower and upper end, largest radius, how many pieces; of each, its
///               ends and four coefficients of the square of the radius by the height above its lower end
///   lathe       how many pieces its curve has; an open curve's two ends, radius and height (radius 0: it is
///               closed); of each piece, Bernstein's four coefficients of the radius and of the height
///   blob        (without materials of components) threshold, how many components; of each,
///               component_from_blob (columns x, y, z, t; to the unit ball, or to the unit cylinder about z),
///               the axis' length there (0: a ball), strength
struct ShapeNumbers {
    enum class Kind : std::uint8_t {
        none,
        sphere,
        box,
        half_space,
        cone,
        quadric,
        disc,
        torus,
        polynomial,
        polygon,
        prism,
        revolution,
        lathe,
        blob,
    };
    Kind kind = Kind::none;
    std::vector<double> values;

    ShapeNumbers& add(double value) {
        values.push_back(value);
        return *this;
    }
    ShapeNumbers& add(Vec3d v) { return add(v.x).add(v.y).add(v.z); }
    ShapeNumbers& add(const std::array<double, 4>& cubic) {
        values.insert(values.end(), cubic.begin(), cubic.end());
        return *this;
    }
};

}  // namespace sundog::solids
