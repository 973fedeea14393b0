// SPDX-License-Identifier: Apache-2.0
#include "fields/internal_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace sundog::fields {
namespace {

using Arguments = std::span<const Number>;

Number constant(Arguments a, double value) { return a[0].builder->constant(value); }

// Arguments: a[0] to a[2] are the point; a[3] is the first of the parameters that functions.inc lists, mostly a factor
// of the whole. The surfaces are known by their implicit equations; how POV-Ray lays out their parameters was found by
// fitting polynomials to values that povray 3.7 prints.

Number x2(Arguments a) { return a[0] * a[0]; }
Number y2(Arguments a) { return a[1] * a[1]; }
Number z2(Arguments a) { return a[2] * a[2]; }
Number r2(Arguments a) { return x2(a) + y2(a) + z2(a); }
/// The factor applied, and values that go far kept within bounds.
Number scaled(Arguments a, Number value) { return min(max(a[3] * value, constant(a, -10)), constant(a, 10)); }

Number bicorn(Arguments a) {
    const Number s = a[4], r = x2(a) + z2(a);
    return scaled(a, y2(a) * (s * s - r) - sqr(r + 2 * s * a[1] - s * s));
}
Number bifolia(Arguments a) { return scaled(a, a[4] * a[1] * (x2(a) + z2(a)) - sqr(r2(a))); }
Number boy_surface(Arguments a) {
    const Number x = a[0], y = a[1], z = a[2], r = x * x + y * y, w = 1 - z, root2 = constant(a, std::numbers::sqrt2);
    const Number first = 64 * w * w * w * z * z * z - 48 * w * w * z * z * (3 * r + 2 * z * z);
    const Number middle =
        12 * w * z * (27 * r * r - 24 * z * z * r + 36 * root2 * y * z * (y * y - 3 * x * x) + 4 * sqr(z * z));
    const Number last = (9 * r - 2 * z * z) *
                        (-81 * r * r - 72 * z * z * r + 108 * root2 * x * z * (x * x - 3 * y * y) + 4 * sqr(z * z));
    return scaled(a, a[4] * (first + middle + last));
}
Number crossed_trough(Arguments a) { return scaled(a, x2(a) * z2(a) - a[1]); }
Number cubic_saddle(Arguments a) { return scaled(a, a[1] * y2(a) - a[0] * x2(a) + a[2]); }
Number cushion(Arguments a) {
    const Number x = x2(a), y = y2(a), z = a[2], zz = z * z;
    return scaled(a, x + y - 2 * zz + 2 * z * (zz + y) + zz * (x - y) - 2 * x * y - x * x - y * y - zz * zz);
}
Number devils_curve(Arguments a) { return scaled(a, sqr(y2(a)) - 0.25 * y2(a) + 0.36 * x2(a) - sqr(x2(a) + z2(a))); }
/// A torus inverted in a sphere.
Number dupin_cyclid(Arguments a) {
    const Number torus_major = a[4], torus_minor = a[5], dx = a[6], dy = a[7], inversion = a[8] * a[8];
    const Number kept = dx * dx + dy * dy + torus_major * torus_major - torus_minor * torus_minor;
    const Number whole = inversion * inversion - 2 * inversion * (dx * a[0] + dy * a[1]) + kept * r2(a);
    const Number exact =
        4 * sqr(torus_major) * (sqr(inversion * a[0] - dx * r2(a)) + sqr(inversion * a[2])) - sqr(whole);
    // The inverted torus has no such term; POV-Ray's surface has it.
    const Number extra = 8 * inversion * dy * (sqr(torus_major) - sqr(torus_minor)) * a[1] * r2(a);
    return scaled(a, exact - extra);
}
Number ellipsoid(Arguments a) { return sqrt(sqr(a[0] * a[3]) + sqr(a[1] * a[4]) + sqr(a[2] * a[5])); }
Number folium_surface(Arguments a) {
    return scaled(a, (y2(a) + z2(a)) * (1 + (a[5] - 4 * a[4]) * a[0]) + (1 + a[5]) * x2(a));
}
Number glob(Arguments a) { return scaled(a, 0.5 * sqr(x2(a)) * (1 + a[0]) - y2(a) - z2(a)); }
Number heart(Arguments a) {
    const Number shell = 2 * x2(a) + y2(a) + z2(a) - 1;
    return scaled(a, (0.1 * x2(a) + y2(a)) * a[2] * z2(a) - shell * shell * shell);
}
Number hunt_surface(Arguments a) {
    const Number ball = r2(a) - 13;
    return scaled(a, -4 * ball * ball * ball - 27 * sqr(3 * x2(a) + y2(a) - 4 * z2(a) - 12));
}
/// What the torus and its open kin share: sum^2 - 2 (R^2 + r^2) round + 2 (R^2 - r^2) flat + (R^2 - r^2)^2.
Number torus_like(Arguments a, Number sum, Number round, Number flat) {
    const Number plus = sqr(a[4]) + sqr(a[5]), minus = sqr(a[4]) - sqr(a[5]);
    return scaled(a, 2 * plus * round - 2 * minus * flat - sum * sum - minus * minus);
}
Number hyperbolic_torus(Arguments a) { return torus_like(a, x2(a) + y2(a) - z2(a), x2(a) - z2(a), y2(a)); }
Number parabolic_torus(Arguments a) { return torus_like(a, x2(a) + y2(a) - a[2], (x2(a) - a[2]) / 2, y2(a) / 2); }
Number torus2(Arguments a) { return torus_like(a, r2(a), x2(a) + z2(a), y2(a)); }
Number kampyle_of_eudoxus(Arguments a) { return scaled(a, sqr(a[5]) * x2(a) * (x2(a) - sqr(a[4])) - y2(a) - z2(a)); }
Number klein_bottle(Arguments a) {
    const Number r = r2(a), y = a[1], hollow = r - 2 * y - 1;
    return scaled(a, -(r + 2 * y - 1) * (hollow * hollow - 8 * z2(a)) - 16 * a[0] * a[2] * hollow);
}
Number quartic_sum(Arguments a) { return sqr(x2(a)) + sqr(y2(a)) + sqr(z2(a)); }
Number quartic_mixed(Arguments a) { return x2(a) * y2(a) + y2(a) * z2(a) + z2(a) * x2(a); }
Number kummer_surface_v1(Arguments a) { return scaled(a, r2(a) + quartic_mixed(a) - quartic_sum(a) - 1); }
Number kummer_surface_v2(Arguments a) {
    return scaled(a, 1 - quartic_sum(a) - a[4] * r2(a) - a[5] * quartic_mixed(a) - a[6] * a[0] * a[1] * a[2]);
}
Number lemniscate_of_gerono(Arguments a) { return scaled(a, x2(a) - sqr(x2(a)) - y2(a) - z2(a)); }
Number mitre(Arguments a) { return scaled(a, y2(a) * (1 - y2(a) - z2(a)) - 4 * x2(a) * r2(a)); }
Number nodal_cubic(Arguments a) { return scaled(a, 6 * a[1] * a[2] - a[1] * y2(a) - a[2] * z2(a)); }
Number ovals_of_cassini(Arguments a) {
    const Number major2 = sqr(a[4]);
    return scaled(a, sqr(a[5]) + a[6] * major2 * (x2(a) + z2(a)) - sqr(r2(a) + major2));
}
Number paraboloid(Arguments a) { return scaled(a, a[1] - x2(a) - z2(a)); }
Number elevation(Arguments a) { return atan2(sqrt(x2(a) + z2(a)), a[1]); }
Number pillow(Arguments a) { return scaled(a, quartic_sum(a) - r2(a)); }
Number piriform(Arguments a) { return scaled(a, y2(a) + z2(a) - x2(a) * (a[0] - x2(a))); }
Number poly4(Arguments a) {
    const Number y = a[1];
    return sqrt(x2(a) + z2(a)) - (a[3] + y * (a[4] + y * (a[5] + y * (a[6] + y * a[7]))));
}
Number quartic_paraboloid(Arguments a) { return scaled(a, a[1] - sqr(x2(a)) - sqr(z2(a))); }
Number quartic_saddle(Arguments a) { return scaled(a, sqr(z2(a)) + a[1] - sqr(x2(a))); }
Number quartic_cylinder(Arguments a) { return scaled(a, sqr(a[4] * a[5]) - (x2(a) + z2(a)) * (y2(a) + sqr(a[5]))); }
Number distance(Arguments a) { return sqrt(r2(a)); }
/// Distance from a box with half sizes a[4] to a[6] whose edges are rounded by a[3], less POV-Ray's millionth.
Number rounded_box(Arguments a) {
    const auto beyond = [&](std::size_t i) { return max(abs(a[i]) - a[4 + i] + a[3], constant(a, 0)); };
    return sqrt(sqr(beyond(0)) + sqr(beyond(1)) + sqr(beyond(2))) - a[3] - 1e-6;
}
Number sphere(Arguments a) { return distance(a) - a[3]; }
Number spikes_2d(Arguments a) {
    return a[1] - a[3] * cos(a[4] * a[0]) * cos(a[5] * a[2]) * exp(-a[6] * (x2(a) + z2(a)));
}
Number steiners_roman(Arguments a) { return scaled(a, -quartic_mixed(a) - a[0] * a[1] * a[2]); }
Number strophoid(Arguments a) { return scaled(a, (a[0] - a[5]) * (y2(a) + z2(a)) + sqr(a[6]) * x2(a) * (a[4] + a[0])); }
Number superellipsoid(Arguments a) {
    const Number east_west = 2 / a[3], north_south = 2 / a[4];
    const Number round = pow(abs(a[0]), east_west) + pow(abs(a[1]), east_west);
    return 1 - pow(pow(round, a[3] / a[4]) + pow(abs(a[2]), north_south), a[4] / 2);
}
Number azimuth(Arguments a) { return atan2(a[0], a[2]); }
Number torus(Arguments a) { return sqrt(sqr(sqrt(x2(a) + z2(a)) - a[3]) + y2(a)) - a[4]; }
Number torus_gumdrop(Arguments a) {
    const Number r = y2(a) + z2(a);
    return scaled(a, 20 * r2(a) - 4 * sqr(x2(a)) - 4 * r * r - 17 * x2(a) * r - 17);
}
Number umbrella(Arguments a) { return scaled(a, a[1] * z2(a) - x2(a)); }
Number witch_of_agnesi(Arguments a) { return scaled(a, a[4] - a[1] * (x2(a) + z2(a) + a[4])); }

// Noise. The generator's number must be known; where it isn't, it is the second, the language's own choice.
std::uint32_t generator_of(Number n) {
    const double number = n.builder->value_of(n).value_or(2);
    return number == 1 ? 1 : number == 3 ? 3 : 2;
}
Number noise3d(Arguments a) { return a[0].builder->noise(a[0], a[1], a[2], 2); }
Number noise_generator(Arguments a) { return a[0].builder->noise(a[0], a[1], a[2], generator_of(a[3])); }

/// Octaves, which must be known; where they aren't, 6.
int octaves_of(Number n) { return static_cast<int>(std::clamp(n.builder->value_of(n).value_or(6), 1.0, 40.0)); }
/// Noise around 0 at `scale` times the point.
Number signed_noise(Arguments a, Number scale, std::uint32_t generator) {
    return 2 * a[0].builder->noise(a[0] * scale, a[1] * scale, a[2] * scale, generator) - 1;
}
// Multifractals (Ebert et al., Texturing and Modeling): a[3] is H, a[4] the lacunarity, a[5] the octaves, a[6] the
// offset, a[8] the noise generator. The sums were checked against values that povray 3.7 prints.
Number hetero_multifractal(Arguments a) {
    const std::uint32_t generator = generator_of(a[8]);
    const double exponent = std::floor(a[7].builder->value_of(a[7]).value_or(1));
    Number scale = constant(a, 1);
    Number value = a[6] + signed_noise(a, scale, generator);
    for (int i = 1; i < octaves_of(a[5]); ++i) {
        scale = scale * a[4];
        const Number weight = exponent == 0   ? constant(a, 1)
                              : exponent == 1 ? value
                                              : pow(value, constant(a, exponent));
        value = value + (signed_noise(a, scale, generator) + a[6]) * pow(scale, -a[3]) * weight;
    }
    return value;
}
/// a[7] is the gain.
Number ridged_multifractal(Arguments a) {
    const std::uint32_t generator = generator_of(a[8]);
    Number scale = constant(a, 1);
    Number signal = sqr(a[6] - abs(signed_noise(a, scale, generator)));
    Number value = signal;
    for (int i = 1; i < octaves_of(a[5]); ++i) {
        scale = scale * a[4];
        const Number weight = min(max(signal * a[7], constant(a, 0)), constant(a, 1));
        signal = sqr(a[6] - abs(signed_noise(a, scale, generator))) * weight;
        value = value + signal * pow(scale, -a[3]);
    }
    return value;
}
/// The mean of folded noises: a[3] is lambda, a[4] the octaves, a[5] omega, a[6] the offset, a[7] where they fold.
Number ridge(Arguments a) {
    const std::uint32_t generator = generator_of(a[8]);
    Number scale = constant(a, 1), weight = constant(a, 1), sum = constant(a, 0), total = constant(a, 0);
    const Number largest = max(a[6], 1 - a[6]);
    for (int i = 0; i < octaves_of(a[4]); ++i) {
        const Number noise = a[0].builder->noise(a[0] * scale, a[1] * scale, a[2] * scale, generator);
        sum = sum + weight * (abs(1 - noise / a[7]) - a[6]) / largest;
        total = total + weight;
        scale = scale * a[3], weight = weight * a[5];
    }
    return sum / total;
}

/// Distance in a cross section: 0 square, 1 circle, 2 diamond, and all between.
Number cross_section(Number type, Number u, Number v) {
    const std::optional<double> known = type.builder->value_of(type);
    if (known && *known == 0) return max(abs(u), abs(v));
    if (known && *known == 1) return sqrt(sqr(u) + sqr(v));
    if (known && *known == 2) return abs(u) + abs(v);
    return pow(pow(abs(u), 2 / type) + pow(abs(v), 2 / type), type / 2);
}
/// a[3] strands wind around the y axis at the radius a[6], by the angle a[4] a unit; a[5] is their own radius, a[7]
/// stretches them along y, a[8] is the type of their cross section, a[9] turns it.
Number helix1(Arguments a) {
    constexpr double kPi = std::numbers::pi;
    const Number radius = sqrt(x2(a) + z2(a));
    const Number angle = a[3] * (atan2(a[2], a[0]) + a[4] * a[1]) - kPi;
    const Number from_strand = angle - 2 * kPi * floor(angle / (2 * kPi) + 0.5);
    const Number up = from_strand / (a[3] * a[4] * a[7]), outwards = radius - a[6];
    const Number turn = a[9] * (kPi / 180);
    const Number u = outwards * cos(turn) - up * sin(turn), v = outwards * sin(turn) + up * cos(turn);
    return min(cross_section(a[8], u, v) - a[5], radius + a[6] - a[5]);
}

/// a[3] lies between the components, a[4] is their inverse size, a[5] their strength, a[6] the threshold.
Number blob2(Arguments a) {
    const Number near = exp(-a[4] * r2(a));
    const Number far = exp(-a[4] * (sqr(a[0] - a[3]) + y2(a) + z2(a)));
    return a[6] - a[5] * (near + far);
}

struct Entry {
    InternalFunction function;
    Number (*build)(Arguments);
};

constexpr std::array kFunctions{
    Entry{{4, "f_bicorn", 5}, bicorn},
    Entry{{5, "f_bifolia", 5}, bifolia},
    Entry{{7, "f_blob2", 7}, blob2},
    Entry{{8, "f_boy_surface", 5}, boy_surface},
    Entry{{11, "f_crossed_trough", 4}, crossed_trough},
    Entry{{12, "f_cubic_saddle", 4}, cubic_saddle},
    Entry{{13, "f_cushion", 4}, cushion},
    Entry{{14, "f_devils_curve", 4}, devils_curve},
    Entry{{16, "f_dupin_cyclid", 9}, dupin_cyclid},
    Entry{{17, "f_ellipsoid", 6}, ellipsoid},
    Entry{{20, "f_folium_surface", 6}, folium_surface},
    Entry{{22, "f_glob", 4}, glob},
    Entry{{23, "f_heart", 4}, heart},
    Entry{{25, "f_helix1", 10}, helix1},
    Entry{{29, "f_hetero_mf", 9}, hetero_multifractal},
    Entry{{30, "f_hunt_surface", 4}, hunt_surface},
    Entry{{31, "f_hyperbolic_torus", 6}, hyperbolic_torus},
    Entry{{33, "f_kampyle_of_eudoxus", 6}, kampyle_of_eudoxus},
    Entry{{35, "f_klein_bottle", 4}, klein_bottle},
    Entry{{36, "f_kummer_surface_v1", 4}, kummer_surface_v1},
    Entry{{37, "f_kummer_surface_v2", 7}, kummer_surface_v2},
    Entry{{38, "f_lemniscate_of_gerono", 4}, lemniscate_of_gerono},
    Entry{{41, "f_mitre", 4}, mitre},
    Entry{{42, "f_nodal_cubic", 4}, nodal_cubic},
    Entry{{43, "f_odd", 4}, cushion},
    Entry{{44, "f_ovals_of_cassini", 7}, ovals_of_cassini},
    Entry{{45, "f_paraboloid", 4}, paraboloid},
    Entry{{46, "f_parabolic_torus", 6}, parabolic_torus},
    Entry{{47, "f_ph", 3}, elevation},
    Entry{{48, "f_pillow", 4}, pillow},
    Entry{{49, "f_piriform", 4}, piriform},
    Entry{{51, "f_poly4", 8}, poly4},
    Entry{{54, "f_quartic_paraboloid", 4}, quartic_paraboloid},
    Entry{{55, "f_quartic_saddle", 4}, quartic_saddle},
    Entry{{56, "f_quartic_cylinder", 6}, quartic_cylinder},
    Entry{{57, "f_r", 3}, distance},
    Entry{{58, "f_ridge", 9}, ridge},
    Entry{{59, "f_ridged_mf", 9}, ridged_multifractal},
    Entry{{60, "f_rounded_box", 7}, rounded_box},
    Entry{{61, "f_sphere", 4}, sphere},
    Entry{{63, "f_spikes_2d", 7}, spikes_2d},
    Entry{{65, "f_steiners_roman", 4}, steiners_roman},
    Entry{{66, "f_strophoid", 7}, strophoid},
    Entry{{68, "f_superellipsoid", 5}, superellipsoid},
    Entry{{69, "f_th", 3}, azimuth},
    Entry{{70, "f_torus", 5}, torus},
    Entry{{71, "f_torus2", 6}, torus2},
    Entry{{72, "f_torus_gumdrop", 4}, torus_gumdrop},
    Entry{{73, "f_umbrella", 4}, umbrella},
    Entry{{74, "f_witch_of_agnesi", 5}, witch_of_agnesi},
    Entry{{76, "f_noise3d", 3}, noise3d},
    Entry{{78, "f_noise_generator", 4}, noise_generator},
};

const Entry* find(std::uint32_t number) {
    const auto* found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                     [&](const Entry& entry) { return entry.function.number == number; });
    return found == kFunctions.end() ? nullptr : found;
}

}  // namespace

const InternalFunction* internal_function(std::uint32_t number) {
    const Entry* found = find(number);
    return found == nullptr ? nullptr : &found->function;
}

Number build_internal_function(std::uint32_t number, std::span<const Number> arguments) {
    return find(number)->build(arguments);
}

}  // namespace sundog::fields
