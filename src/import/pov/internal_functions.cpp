// SPDX-License-Identifier: Apache-2.0
#include "import/pov/internal_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/pov/turbulence.h"

namespace sundog::pov {
namespace {

double sqr(double a) { return a * a; }

// Arguments: a[0] to a[2] are the point, a[3] and on the parameters that functions.inc lists.

double ellipsoid(const double* a) { return std::sqrt(sqr(a[0] * a[3]) + sqr(a[1] * a[4]) + sqr(a[2] * a[5])); }
double paraboloid(const double* a) { return std::clamp(-a[3] * (sqr(a[0]) - a[1] + sqr(a[2])), -10.0, 10.0); }
double elevation(const double* a) { return std::atan2(std::sqrt(sqr(a[0]) + sqr(a[2])), a[1]); }
double distance(const double* a) { return std::sqrt(sqr(a[0]) + sqr(a[1]) + sqr(a[2])); }
double azimuth(const double* a) { return std::atan2(a[0], a[2]); }
double sphere(const double* a) { return distance(a) - a[3]; }
double torus(const double* a) { return std::sqrt(sqr(std::sqrt(sqr(a[0]) + sqr(a[2])) - a[3]) + sqr(a[1])) - a[4]; }
double noise3d(const double* a) { return noise({a[0], a[1], a[2]}); }

/// Distance from a box with half sizes a[4] to a[6] whose edges are rounded by a[3].
double rounded_box(const double* a) {
    const auto beyond = [&](int i) { return std::max(std::fabs(a[i]) - a[4 + i] + a[3], 0.0); };
    return std::sqrt(sqr(beyond(0)) + sqr(beyond(1)) + sqr(beyond(2))) - a[3];
}

constexpr std::array kFunctions{
    InternalFunction{17, "f_ellipsoid", 6, ellipsoid},
    InternalFunction{45, "f_paraboloid", 4, paraboloid},
    InternalFunction{47, "f_ph", 3, elevation},
    InternalFunction{57, "f_r", 3, distance},
    InternalFunction{60, "f_rounded_box", 7, rounded_box},
    InternalFunction{61, "f_sphere", 4, sphere},
    InternalFunction{69, "f_th", 3, azimuth},
    InternalFunction{70, "f_torus", 5, torus},
    InternalFunction{76, "f_noise3d", 3, noise3d},
};

}  // namespace

const InternalFunction* internal_function(std::uint32_t number) {
    const auto* found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                     [&](const InternalFunction& function) { return function.number == number; });
    return found == kFunctions.end() ? nullptr : found;
}

}  // namespace sundog::pov
