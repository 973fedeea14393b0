// SPDX-License-Identifier: Apache-2.0
// How quickly pigments can change: what a search for surfaces may skip.
#pragma once

#include "scene/pigment.h"

namespace sundog::fields {

/// The most that any component of a pigment's colour changes over a distance of 1; infinite where that isn't known.
double pigment_slope_limit(const scene::Pigment& pigment);

}  // namespace sundog::fields
