// SPDX-License-Identifier: Apache-2.0
// Bounds of the kernel's noise (kernel/patterns/noise.h) over boxes, from the numbers that the lattice has there.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/vec3d.h"

namespace sundog {

/// All numbers from lower to upper.
struct Range {
    double lower = 0, upper = 0;
    [[nodiscard]] double most() const { return std::max(-lower, upper); }
    [[nodiscard]] bool operator==(const Range&) const = default;
};

inline Range operator+(Range a, Range b) { return {a.lower + b.lower, a.upper + b.upper}; }
inline Range operator*(Range a, double s) {
    return s < 0 ? Range{a.upper * s, a.lower * s} : Range{a.lower * s, a.upper * s};
}
/// What either of the two may be.
inline Range either(Range a, Range b) { return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}; }
inline Range clamped(Range a, double lower, double upper) {
    return {std::clamp(a.lower, lower, upper), std::clamp(a.upper, lower, upper)};
}
/// Of the absolute value.
inline Range size_of(Range a) {
    const double least = a.lower > 0 ? a.lower : a.upper < 0 ? -a.upper : 0;
    return {least, a.most()};
}

/// A box, by its ranges along x, y and z.
using RangeBox = std::array<Range, 3>;

/// A box that holds all points there are.
inline constexpr RangeBox kEverywhere{Range{-1e30, 1e30}, Range{-1e30, 1e30}, Range{-1e30, 1e30}};

/// What noise_value() is within, over a box. All of these are sound, the kernel's rounding included.
Range noise_over(const RangeBox& box, std::uint32_t generator);
/// The same of noise_vector().
std::array<Range, 3> noise_vector_over(const RangeBox& box);

}  // namespace sundog
