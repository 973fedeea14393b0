// SPDX-License-Identifier: Apache-2.0
#include "import/pov/math_functions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "import/pov/values.h"

namespace sundog::pov {
namespace {

std::int32_t to_integer(double number) {
    return static_cast<std::int32_t>(std::clamp(number, -2147483648.0, 2147483647.0));
}

}  // namespace

unsigned float_arity(Keyword keyword) {
    using enum Keyword;
    switch (keyword) {
        case abs:
        case acos:
        case acosh:
        case asin:
        case asinh:
        case atan:
        case atanh:
        case ceil:
        case cos:
        case cosh:
        case degrees:
        case exp:
        case floor:
        case int_:
        case ln:
        case log:
        case radians:
        case sin:
        case sinh:
        case sqr:
        case sqrt:
        case tan:
        case tanh:
            return 1;
        case atan2:
        case div:
        case mod:
        case pow:
            return 2;
        default:
            return 0;
    }
}

double float_function(Keyword keyword, std::span<const double> arguments) {
    using enum Keyword;
    const double a = arguments[0];
    const double b = arguments.size() > 1 ? arguments[1] : 0;
    switch (keyword) {
        case abs:
            return std::fabs(a);
        case acos:
            return std::acos(std::clamp(a, -1.0, 1.0));
        case acosh:
            return std::acosh(a);
        case asin:
            return std::asin(std::clamp(a, -1.0, 1.0));
        case asinh:
            return std::asinh(a);
        case atan:
            return std::atan(a);
            return std::atan(a) * (180 / std::numbers::pi);
        case atanh:
            return std::atanh(a);
        case ceil:
            return std::ceil(a);
        case cos:
            return std::cos(a);
        case cosh:
            return std::cosh(a);
        case degrees:
            return a * (180 / std::numbers::pi);
        case exp:
            return std::exp(a);
        case floor:
            return std::floor(a);
        case int_:
            return std::trunc(a);
        case ln:
            return std::log(a);
        case log:
            return std::log10(a);
        case radians:
            return a * (std::numbers::pi / 180);
        case sin:
            return std::sin(a);
        case sinh:
            return std::sinh(a);
        case sqr:
            return a * a;
        case sqrt:
            return std::sqrt(a);
        case tan:
            return std::tan(a);
        case tanh:
            return std::tanh(a);
        case atan2:
            return std::atan2(a, b);
        case div:
            return std::trunc(a / b);
        case mod:
            return std::fmod(a, b);
        case pow:
            return std::pow(a, b);
        default:
            return 0;
    }
}

double aggregate_function(Keyword keyword, std::span<const double> arguments) {
    if (keyword == Keyword::select) {
        const double a = arguments[0];
        if (arguments.size() == 3) return a < 0 ? arguments[1] : arguments[2];
        return a < 0 ? arguments[1] : a == 0 ? arguments[2] : arguments[3];
    }
    double result = arguments[0];
    for (const double next : arguments.subspan(1)) {
        switch (keyword) {
            case Keyword::min:
                result = std::min(result, next);
                break;
            case Keyword::max:
                result = std::max(result, next);
                break;
            case Keyword::bitwise_and:
                result = to_integer(result) & to_integer(next);
                break;
            case Keyword::bitwise_or:
                result = to_integer(result) | to_integer(next);
                break;
            default:
                result = to_integer(result) ^ to_integer(next);
                break;
        }
    }
    return result;
}

bool outside_domain(Keyword keyword, std::span<const double> arguments) {
    const double a = arguments[0];
    switch (keyword) {
        case Keyword::sqrt:
            return a < 0;
        case Keyword::ln:
        case Keyword::log:
            return a <= 0;
        case Keyword::acos:
        case Keyword::asin:
            return std::fabs(a) > 1 + kEpsilon;
        case Keyword::acosh:
            return a < 1;
        case Keyword::atanh:
            return std::fabs(a) >= 1;
        case Keyword::div:
        case Keyword::mod:
            return arguments[1] == 0;
        case Keyword::pow:
            return (a == 0 && arguments[1] < 0) || (a < 0 && arguments[1] != std::trunc(arguments[1]));
        default:
            return false;
    }
}

}  // namespace sundog::pov
