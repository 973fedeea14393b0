// SPDX-License-Identifier: Apache-2.0
// Polynomial surfaces of first and second order.
#pragma once

#include <span>

#include "solids/shape.h"

namespace sundog::solids {

/// The points at which a polynomial of at most second order isn't positive. Errors: none; terms of a higher order don't
/// belong here.
ShapePointer make_quadric(std::span<const scene::Polynomial::Term> terms);

}  // namespace sundog::solids
