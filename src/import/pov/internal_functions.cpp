// SPDX-License-Identifier: Apache-2.0
#include "import/pov/internal_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/pov/turbulence.h"

namespace sundog::pov {
namespace {

double sqr(double a) { return a * a; }

// Arguments: a[0] to a[2] are the point; a[3] is the first of the parameters that functions.inc lists, mostly a factor
// of the whole. The surfaces are known by their implicit equations; how POV-Ray lays out their parameters was found by
// fitting polynomials to values that povray 3.7 prints.

double x2(const double* a) { return a[0] * a[0]; }
double y2(const double* a) { return a[1] * a[1]; }
double z2(const double* a) { return a[2] * a[2]; }
double r2(const double* a) { return x2(a) + y2(a) + z2(a); }
/// The factor applied, and values that go far kept within bounds.
double scaled(const double* a, double value) { return std::clamp(a[3] * value, -10.0, 10.0); }

double bicorn(const double* a) {
    const double s = a[4], r = x2(a) + z2(a);
    return scaled(a, y2(a) * (s * s - r) - sqr(r + 2 * s * a[1] - s * s));
}
double bifolia(const double* a) { return scaled(a, a[4] * a[1] * (x2(a) + z2(a)) - sqr(r2(a))); }
double boy_surface(const double* a) {
    const double x = a[0], y = a[1], z = a[2], r = x * x + y * y, w = 1 - z, root2 = std::sqrt(2.0);
    const double first = 64 * w * w * w * z * z * z - 48 * w * w * z * z * (3 * r + 2 * z * z);
    const double middle =
        12 * w * z * (27 * r * r - 24 * z * z * r + 36 * root2 * y * z * (y * y - 3 * x * x) + 4 * sqr(z * z));
    const double last = (9 * r - 2 * z * z) *
                        (-81 * r * r - 72 * z * z * r + 108 * root2 * x * z * (x * x - 3 * y * y) + 4 * sqr(z * z));
    return scaled(a, a[4] * (first + middle + last));
}
double crossed_trough(const double* a) { return scaled(a, x2(a) * z2(a) - a[1]); }
double cubic_saddle(const double* a) { return scaled(a, a[1] * y2(a) - a[0] * x2(a) + a[2]); }
double cushion(const double* a) {
    const double x = x2(a), y = y2(a), z = a[2], zz = z * z;
    return scaled(a, x + y - 2 * zz + 2 * z * (zz + y) + zz * (x - y) - 2 * x * y - x * x - y * y - zz * zz);
}
double devils_curve(const double* a) {
    return scaled(a, sqr(y2(a)) - 0.25 * y2(a) + 0.36 * x2(a) - sqr(x2(a) + z2(a)));
}
/// A torus inverted in a sphere.
double dupin_cyclid(const double* a) {
    const double torus_major = a[4], torus_minor = a[5], dx = a[6], dy = a[7], inversion = a[8] * a[8];
    const double kept = dx * dx + dy * dy + torus_major * torus_major - torus_minor * torus_minor;
    const double whole = inversion * inversion - 2 * inversion * (dx * a[0] + dy * a[1]) + kept * r2(a);
    const double exact =
        4 * sqr(torus_major) * (sqr(inversion * a[0] - dx * r2(a)) + sqr(inversion * a[2])) - sqr(whole);
    // The inverted torus has no such term; POV-Ray's surface has it.
    const double extra = 8 * inversion * dy * (sqr(torus_major) - sqr(torus_minor)) * a[1] * r2(a);
    return scaled(a, exact - extra);
}
double ellipsoid(const double* a) { return std::sqrt(sqr(a[0] * a[3]) + sqr(a[1] * a[4]) + sqr(a[2] * a[5])); }
double folium_surface(const double* a) {
    return scaled(a, (y2(a) + z2(a)) * (1 + (a[5] - 4 * a[4]) * a[0]) + (1 + a[5]) * x2(a));
}
double glob(const double* a) { return scaled(a, 0.5 * sqr(x2(a)) * (1 + a[0]) - y2(a) - z2(a)); }
double heart(const double* a) {
    const double shell = 2 * x2(a) + y2(a) + z2(a) - 1;
    return scaled(a, (0.1 * x2(a) + y2(a)) * a[2] * z2(a) - shell * shell * shell);
}
double hunt_surface(const double* a) {
    const double ball = r2(a) - 13;
    return scaled(a, -4 * ball * ball * ball - 27 * sqr(3 * x2(a) + y2(a) - 4 * z2(a) - 12));
}
/// What the torus and its open kin share: sum^2 - 2 (R^2 + r^2) round + 2 (R^2 - r^2) flat + (R^2 - r^2)^2.
double torus_like(const double* a, double sum, double round, double flat) {
    const double plus = sqr(a[4]) + sqr(a[5]), minus = sqr(a[4]) - sqr(a[5]);
    return scaled(a, 2 * plus * round - 2 * minus * flat - sum * sum - minus * minus);
}
double hyperbolic_torus(const double* a) { return torus_like(a, x2(a) + y2(a) - z2(a), x2(a) - z2(a), y2(a)); }
double parabolic_torus(const double* a) { return torus_like(a, x2(a) + y2(a) - a[2], (x2(a) - a[2]) / 2, y2(a) / 2); }
double torus2(const double* a) { return torus_like(a, r2(a), x2(a) + z2(a), y2(a)); }
double kampyle_of_eudoxus(const double* a) {
    return scaled(a, sqr(a[5]) * x2(a) * (x2(a) - sqr(a[4])) - y2(a) - z2(a));
}
double klein_bottle(const double* a) {
    const double r = r2(a), y = a[1], hollow = r - 2 * y - 1;
    return scaled(a, -(r + 2 * y - 1) * (hollow * hollow - 8 * z2(a)) - 16 * a[0] * a[2] * hollow);
}
double quartic_sum(const double* a) { return sqr(x2(a)) + sqr(y2(a)) + sqr(z2(a)); }
double quartic_mixed(const double* a) { return x2(a) * y2(a) + y2(a) * z2(a) + z2(a) * x2(a); }
double kummer_surface_v1(const double* a) { return scaled(a, r2(a) + quartic_mixed(a) - quartic_sum(a) - 1); }
double kummer_surface_v2(const double* a) {
    return scaled(a, 1 - quartic_sum(a) - a[4] * r2(a) - a[5] * quartic_mixed(a) - a[6] * a[0] * a[1] * a[2]);
}
double lemniscate_of_gerono(const double* a) { return scaled(a, x2(a) - sqr(x2(a)) - y2(a) - z2(a)); }
double mitre(const double* a) { return scaled(a, y2(a) * (1 - y2(a) - z2(a)) - 4 * x2(a) * r2(a)); }
double nodal_cubic(const double* a) { return scaled(a, 6 * a[1] * a[2] - a[1] * y2(a) - a[2] * z2(a)); }
double ovals_of_cassini(const double* a) {
    const double major2 = sqr(a[4]);
    return scaled(a, sqr(a[5]) + a[6] * major2 * (x2(a) + z2(a)) - sqr(r2(a) + major2));
}
double paraboloid(const double* a) { return scaled(a, a[1] - x2(a) - z2(a)); }
double elevation(const double* a) { return std::atan2(std::sqrt(x2(a) + z2(a)), a[1]); }
double pillow(const double* a) { return scaled(a, quartic_sum(a) - r2(a)); }
double piriform(const double* a) { return scaled(a, y2(a) + z2(a) - x2(a) * (a[0] - x2(a))); }
double poly4(const double* a) {
    const double y = a[1];
    return std::sqrt(x2(a) + z2(a)) - (a[3] + y * (a[4] + y * (a[5] + y * (a[6] + y * a[7]))));
}
double quartic_paraboloid(const double* a) { return scaled(a, a[1] - sqr(x2(a)) - sqr(z2(a))); }
double quartic_saddle(const double* a) { return scaled(a, sqr(z2(a)) + a[1] - sqr(x2(a))); }
double quartic_cylinder(const double* a) { return scaled(a, sqr(a[4] * a[5]) - (x2(a) + z2(a)) * (y2(a) + sqr(a[5]))); }
double distance(const double* a) { return std::sqrt(r2(a)); }
/// Distance from a box with half sizes a[4] to a[6] whose edges are rounded by a[3], less POV-Ray's millionth.
double rounded_box(const double* a) {
    const auto beyond = [&](int i) { return std::max(std::fabs(a[i]) - a[4 + i] + a[3], 0.0); };
    return std::sqrt(sqr(beyond(0)) + sqr(beyond(1)) + sqr(beyond(2))) - a[3] - 1e-6;
}
double sphere(const double* a) { return distance(a) - a[3]; }
double spikes_2d(const double* a) {
    return a[1] - a[3] * std::cos(a[4] * a[0]) * std::cos(a[5] * a[2]) * std::exp(-a[6] * (x2(a) + z2(a)));
}
double steiners_roman(const double* a) { return scaled(a, -quartic_mixed(a) - a[0] * a[1] * a[2]); }
double strophoid(const double* a) {
    return scaled(a, (a[0] - a[5]) * (y2(a) + z2(a)) + sqr(a[6]) * x2(a) * (a[4] + a[0]));
}
double superellipsoid(const double* a) {
    const double east_west = 2 / a[3], north_south = 2 / a[4];
    const double round = std::pow(std::fabs(a[0]), east_west) + std::pow(std::fabs(a[1]), east_west);
    return 1 - std::pow(std::pow(round, a[3] / a[4]) + std::pow(std::fabs(a[2]), north_south), a[4] / 2);
}
double azimuth(const double* a) { return std::atan2(a[0], a[2]); }
double torus(const double* a) { return std::sqrt(sqr(std::sqrt(x2(a) + z2(a)) - a[3]) + y2(a)) - a[4]; }
double torus_gumdrop(const double* a) {
    const double r = y2(a) + z2(a);
    return scaled(a, 20 * r2(a) - 4 * sqr(x2(a)) - 4 * r * r - 17 * x2(a) * r - 17);
}
double umbrella(const double* a) { return scaled(a, a[1] * z2(a) - x2(a)); }
double witch_of_agnesi(const double* a) { return scaled(a, a[4] - a[1] * (x2(a) + z2(a) + a[4])); }
double noise3d(const double* a) { return noise({a[0], a[1], a[2]}); }
/// All of POV-Ray's generators are the one noise here.
double noise_generator(const double* a) { return noise3d(a); }

constexpr std::array kFunctions{
    InternalFunction{4, "f_bicorn", 5, bicorn},
    InternalFunction{5, "f_bifolia", 5, bifolia},
    InternalFunction{8, "f_boy_surface", 5, boy_surface},
    InternalFunction{11, "f_crossed_trough", 4, crossed_trough},
    InternalFunction{12, "f_cubic_saddle", 4, cubic_saddle},
    InternalFunction{13, "f_cushion", 4, cushion},
    InternalFunction{14, "f_devils_curve", 4, devils_curve},
    InternalFunction{16, "f_dupin_cyclid", 9, dupin_cyclid},
    InternalFunction{17, "f_ellipsoid", 6, ellipsoid},
    InternalFunction{20, "f_folium_surface", 6, folium_surface},
    InternalFunction{22, "f_glob", 4, glob},
    InternalFunction{23, "f_heart", 4, heart},
    InternalFunction{30, "f_hunt_surface", 4, hunt_surface},
    InternalFunction{31, "f_hyperbolic_torus", 6, hyperbolic_torus},
    InternalFunction{33, "f_kampyle_of_eudoxus", 6, kampyle_of_eudoxus},
    InternalFunction{35, "f_klein_bottle", 4, klein_bottle},
    InternalFunction{36, "f_kummer_surface_v1", 4, kummer_surface_v1},
    InternalFunction{37, "f_kummer_surface_v2", 7, kummer_surface_v2},
    InternalFunction{38, "f_lemniscate_of_gerono", 4, lemniscate_of_gerono},
    InternalFunction{41, "f_mitre", 4, mitre},
    InternalFunction{42, "f_nodal_cubic", 4, nodal_cubic},
    InternalFunction{43, "f_odd", 4, cushion},
    InternalFunction{44, "f_ovals_of_cassini", 7, ovals_of_cassini},
    InternalFunction{45, "f_paraboloid", 4, paraboloid},
    InternalFunction{46, "f_parabolic_torus", 6, parabolic_torus},
    InternalFunction{47, "f_ph", 3, elevation},
    InternalFunction{48, "f_pillow", 4, pillow},
    InternalFunction{49, "f_piriform", 4, piriform},
    InternalFunction{51, "f_poly4", 8, poly4},
    InternalFunction{54, "f_quartic_paraboloid", 4, quartic_paraboloid},
    InternalFunction{55, "f_quartic_saddle", 4, quartic_saddle},
    InternalFunction{56, "f_quartic_cylinder", 6, quartic_cylinder},
    InternalFunction{57, "f_r", 3, distance},
    InternalFunction{60, "f_rounded_box", 7, rounded_box},
    InternalFunction{61, "f_sphere", 4, sphere},
    InternalFunction{63, "f_spikes_2d", 7, spikes_2d},
    InternalFunction{65, "f_steiners_roman", 4, steiners_roman},
    InternalFunction{66, "f_strophoid", 7, strophoid},
    InternalFunction{68, "f_superellipsoid", 5, superellipsoid},
    InternalFunction{69, "f_th", 3, azimuth},
    InternalFunction{70, "f_torus", 5, torus},
    InternalFunction{71, "f_torus2", 6, torus2},
    InternalFunction{72, "f_torus_gumdrop", 4, torus_gumdrop},
    InternalFunction{73, "f_umbrella", 4, umbrella},
    InternalFunction{74, "f_witch_of_agnesi", 5, witch_of_agnesi},
    InternalFunction{76, "f_noise3d", 3, noise3d},
    InternalFunction{78, "f_noise_generator", 4, noise_generator},
};

}  // namespace

const InternalFunction* internal_function(std::uint32_t number) {
    const auto* found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                     [&](const InternalFunction& function) { return function.number == number; });
    return found == kFunctions.end() ? nullptr : found;
}

}  // namespace sundog::pov
