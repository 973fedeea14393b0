// SPDX-License-Identifier: Apache-2.0
#include "fields/slope_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "fields/noise.h"
#include "fields/pigment_code.h"

namespace sundog::fields {
namespace {

using scene::Pattern;
using Kind = Pattern::Kind;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Of a field in its own space, before its wave form; for fields that stay within 0..1 only.
double field_limit(const Pattern& pattern) {
    const double noise = std::numbers::sqrt3 * noise_slope_limit(noise_generator_of(pattern));
    switch (pattern.kind) {
        case Kind::crackle: {
            const scene::CrackleForm& crackle = pattern.crackle;
            if (crackle.solid || crackle.metric < 1) return kUnknown;
            const Vec3d& form = crackle.form;
            const double sum = std::abs(form.x) + std::abs(form.y) + std::abs(form.z);
            return crackle.metric >= 2 ? sum : std::numbers::sqrt3 * sum;
        }
        case Kind::bozo:
        case Kind::bumps:
        case Kind::spotted:
            return noise;
        case Kind::dents:
            return 3 * noise;
        case Kind::wrinkles:
            return 10 * noise;
        case Kind::granite:
            return 6 * 4 * 1.95 * noise;
        case Kind::boxed:
        case Kind::cylindrical:
        case Kind::planar:
        case Kind::spherical:
            return 1;
        case Kind::leopard:
            return 2 / std::numbers::sqrt3;
        default:
            return kUnknown;
    }
}

/// Of a wave form, by its field.
double wave_limit(const Pattern& pattern) {
    const double frequency = pattern.frequency == 0 ? 1 : std::abs(pattern.frequency);
    switch (pattern.wave) {
        case Pattern::Wave::triangle:
            return 2 * frequency;
        case Pattern::Wave::sine:
            return std::numbers::pi * frequency;
        case Pattern::Wave::standard:
        case Pattern::Wave::ramp:
            // Beyond 1 it jumps.
            return frequency <= 1 && pattern.frequency >= 0 && pattern.phase == 0 ? frequency : kUnknown;
        default:
            return kUnknown;
    }
}

/// Of a map, by its pattern's value.
double map_limit(const scene::Pigment& pigment) {
    double limit = 0;
    for (std::size_t i = 0; i < pigment.entries.size(); ++i) {
        if (pigment.entries[i].pigment) return kUnknown;
        if (i == 0) continue;
        const scene::PigmentEntry& a = pigment.entries[i - 1];
        const scene::PigmentEntry& b = pigment.entries[i];
        const float change =
            std::max({std::abs(a.color.r - b.color.r), std::abs(a.color.g - b.color.g), std::abs(a.color.b - b.color.b),
                      std::abs(a.color.filter - b.color.filter), std::abs(a.color.transmit - b.color.transmit)});
        if (change == 0) continue;
        if (b.at <= a.at) return kUnknown;
        limit = std::max(limit, static_cast<double>(change / (b.at - a.at)));
    }
    return limit;
}

/// The most that a map stretches.
double stretch_limit(const Affine3d& m) {
    const std::array columns{m.x, m.y, m.z};
    double largest = 0;
    for (const Vec3d& a : columns) {
        double sum = 0;
        for (const Vec3d& b : columns) sum += std::abs(dot(a, b));
        largest = std::max(largest, sum);
    }
    return std::sqrt(largest);
}

}  // namespace

double pigment_slope_limit(const scene::Pigment& pigment) {
    if (pigment.kind == scene::Pigment::Kind::solid) return 0;
    const Pattern& pattern = pigment.pattern;
    if (pigment.kind != scene::Pigment::Kind::mapped || !pattern.warps.empty() || !(pattern.turbulence == Vec3d{}))
        return kUnknown;
    const double limit = field_limit(pattern);
    const double wave = wave_limit(pattern), map = map_limit(pigment);
    if (limit == kUnknown || wave == kUnknown || map == kUnknown) return kUnknown;
    return limit * wave * map * stretch_limit(pattern.pattern_from_texture);
}

}  // namespace sundog::fields
