// SPDX-License-Identifier: Apache-2.0
// A named reflection model, for teaching and comparing: how paths scatter at a surface (src/kernel/bsdf).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/vec.h"

namespace sundog::scene {

struct ReflectionModel {
    enum class Kind : std::uint8_t { oren_nayar, phong, blinn_phong, ward, cook_torrance, beckmann, ggx, glass };
    Kind kind = Kind::oren_nayar;
    /// Oren-Nayar: the slopes' deviation, radians. Phong, Blinn-Phong: the exponent. Others: roughness along x and y.
    float first = 0, second = 0;
    Vec3 n{1, 1, 1}, k{0, 0, 0};  ///< A metal's complex index of refraction, of red, green and blue light.
};

/// What was measured of a metal.
struct Metal {
    std::string_view name;
    Vec3 n, k;
};

/// All metals that have a name here, in its order. Interpolated at 611, 549 and 464 nm (near what red, green and blue
/// of sRGB look like) between measurements: copper, gold and silver by Johnson and Christy (Physical Review B 6, 1972),
/// chromium, iron, nickel and titanium by the same (Physical Review B 9, 1974), aluminium by McPeak et al. (ACS
/// Photonics 2, 2015).
std::span<const Metal> metals();

}  // namespace sundog::scene
