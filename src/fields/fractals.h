// SPDX-License-Identifier: Apache-2.0
// Mandelbrot's, Julia's and magnet fractals (POV-Ray reference, section 3.4.7.1.11 "Fractal Pattern").
#pragma once

#include "scene/pattern.h"

namespace sundog::fields {

/// The pattern's value at (x, y), before its wave form.
double fractal_value(const scene::FractalForm& form, double x, double y);

}  // namespace sundog::fields
