// SPDX-License-Identifier: Apache-2.0
// What is white by the light of a colour temperature, made white on the screen.
#pragma once

#include <array>
#include <optional>

#include "base/vec.h"

namespace sundog::output {

/// The colour temperature of the screen's white, D65, in kelvins.
inline constexpr float kNeutralKelvin = 6504;
/// Colour temperatures that have a white.
inline constexpr float kLeastKelvin = 1667, kMostKelvin = 25000;

/// CIE 1931 chromaticity.
struct Chromaticity {
    double x = 0, y = 0;
};

/// The white of a colour temperature from kLeastKelvin to kMostKelvin. From 5000 K on that of daylight (Judd, MacAdam
/// and Wyszecki 1964; Wyszecki and Stiles, Color Science, 1982, 3.3.4), up to 4000 K that of a black body (the cubic
/// fits of Kim and others, US patent 7024034, 2006); between them both are mixed, so that it has no jump.
Chromaticity white_of_temperature(double kelvin);

/// Rows of the map of linear RGB that takes the white of `kelvin` to that of 6504 K, which is the screen's (D65), by
/// chromatic adaptation after von Kries in the cone responses of Bradford (Lam 1985). The identity at 6504 K.
std::array<Vec3, 3> balance_matrix(double kelvin);

}  // namespace sundog::output
