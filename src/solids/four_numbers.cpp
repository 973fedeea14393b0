// SPDX-License-Identifier: Apache-2.0
#include "solids/four_numbers.h"

#include <cmath>

namespace sundog::solids {

std::complex<double> julia_value(scene::JuliaFractal::Function function, std::complex<double> h,
                                 std::complex<double> exponent) {
    using Function = scene::JuliaFractal::Function;
    switch (function) {
        case Function::sin:
            return std::sin(h);
        case Function::asin:
            return std::asin(h);
        case Function::sinh:
            return std::sinh(h);
        case Function::asinh:
            return std::asinh(h);
        case Function::cos:
            return std::cos(h);
        case Function::acos:
            return std::acos(h);
        case Function::cosh:
            return std::cosh(h);
        case Function::acosh:
            return std::acosh(h);
        case Function::atan:
            return std::atan(h);
        case Function::atanh:
            return std::atanh(h);
        default:
            return julia_function(function, h, exponent).value;
    }
}

ComplexValue julia_function(scene::JuliaFractal::Function function, std::complex<double> h,
                            std::complex<double> exponent) {
    using Function = scene::JuliaFractal::Function;
    using std::sqrt;
    switch (function) {
        case Function::sqr:
            return {h * h, 2.0 * h};
        case Function::cube:
            return {h * h * h, 3.0 * h * h};
        case Function::exp: {
            const std::complex<double> e = std::exp(h);
            return {e, e};
        }
        case Function::reciprocal: {
            const std::complex<double> r = 1.0 / h;
            return {r, -r * r};
        }
        case Function::sin:
            return {std::sin(h), std::cos(h)};
        case Function::asin:
            return {std::asin(h), 1.0 / sqrt(1.0 - h * h)};
        case Function::sinh:
            return {std::sinh(h), std::cosh(h)};
        case Function::asinh:
            return {std::asinh(h), 1.0 / sqrt(1.0 + h * h)};
        case Function::cos:
            return {std::cos(h), -std::sin(h)};
        case Function::acos:
            return {std::acos(h), -1.0 / sqrt(1.0 - h * h)};
        case Function::cosh:
            return {std::cosh(h), std::sinh(h)};
        case Function::acosh:
            return {std::acosh(h), 1.0 / (sqrt(h - 1.0) * sqrt(h + 1.0))};
        case Function::tan: {
            const std::complex<double> t = std::tan(h);
            return {t, 1.0 + t * t};
        }
        case Function::atan:
            return {std::atan(h), 1.0 / (1.0 + h * h)};
        case Function::tanh: {
            const std::complex<double> t = std::tanh(h);
            return {t, 1.0 - t * t};
        }
        case Function::atanh:
            return {std::atanh(h), 1.0 / (1.0 - h * h)};
        case Function::ln:
            return {std::log(h), 1.0 / h};
        case Function::pwr: {
            const std::complex<double> p = std::pow(h, exponent);
            return {p, exponent * p / h};
        }
    }
    return {h, 1.0};
}

}  // namespace sundog::solids
