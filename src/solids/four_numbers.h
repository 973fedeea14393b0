// SPDX-License-Identifier: Apache-2.0
// The two algebras of numbers of four parts that POV-Ray's julia_fractal knows (reference, section 3.4.5.1.7), and its
// functions of them with their slopes.
#pragma once

#include <array>
#include <complex>

#include "scene/solid.h"

namespace sundog::solids {

/// a + b*i + c*j + d*k.
using FourNumber = std::array<double, 4>;

inline double squared(const FourNumber& h) { return h[0] * h[0] + h[1] * h[1] + h[2] * h[2] + h[3] * h[3]; }

/// Hamilton's product: ij = k = -ji.
inline FourNumber quaternion_product(const FourNumber& a, const FourNumber& b) {
    return {
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

/// Hypercomplex numbers, in which ij = ji = k, are pairs of complex ones: their parts along (1 - k)/2 and (1 + k)/2,
/// whose products don't mix. So functions apply to each alone.
struct ComplexPair {
    std::complex<double> u, v;
    explicit ComplexPair(const FourNumber& h) : u(h[0] - h[3], h[1] + h[2]), v(h[0] + h[3], h[1] - h[2]) {}
    [[nodiscard]] double squared() const { return 0.5 * (std::norm(u) + std::norm(v)); }
};

/// A complex function's value and derivative.
struct ComplexValue {
    std::complex<double> value, slope;
};
/// `exponent` is pwr's.
std::complex<double> julia_value(scene::JuliaFractal::Function function, std::complex<double> h,
                                 std::complex<double> exponent);
ComplexValue julia_function(scene::JuliaFractal::Function function, std::complex<double> h,
                            std::complex<double> exponent);

}  // namespace sundog::solids
