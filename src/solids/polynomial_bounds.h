// SPDX-License-Identifier: Apache-2.0
// How far a polynomial surface reaches.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "scene/solid.h"
#include "solids/bounds.h"

namespace sundog::solids {

/// A torus around a coordinate axis (0 to 2), its center at the origin.
struct QuarticTorus {
    std::size_t axis = 0;
    double major_radius = 0, minor_radius = 0;
};

/// The torus whose equation, times a positive factor, the polynomial is; none if it is another surface. Scenes of the
/// time before POV-Ray had tori write them so.
std::optional<QuarticTorus> as_torus(std::span<const scene::Polynomial::Term> terms);

/// A box around all points at which the polynomial of these terms is not positive, not much larger than it must be;
/// everywhere where that isn't certain: found are polynomials of even order whose terms of that order are even powers
/// with positive factors, x^n, y^n and z^n among them (tori written as quartics, and most closed surfaces).
Bounds3d polynomial_bounds(std::span<const scene::Polynomial::Term> terms, std::size_t order);

}  // namespace sundog::solids
