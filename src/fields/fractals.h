// SPDX-License-Identifier: Apache-2.0
// Mandelbrot's, Julia's and magnet fractals (POV-Ray reference, section 3.4.7.1.11 "Fractal Pattern").
#pragma once

#include <span>

#include "scene/pattern.h"

namespace sundog::fields {

/// The pattern's values at points (x, y), before its wave form; as many of each.
void fractal_values(const scene::FractalForm& form, std::span<const double> x, std::span<const double> y,
                    std::span<double> values);
/// The same at one point.
double fractal_value(const scene::FractalForm& form, double x, double y);

}  // namespace sundog::fields
