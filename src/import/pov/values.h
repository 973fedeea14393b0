// SPDX-License-Identifier: Apache-2.0
// Arithmetic of POV-Ray's floats, vectors and colours, with their promotions (manual, 3.3.1.6.4).
#pragma once

#include <cmath>
#include <optional>

#include "import/pov/entity.h"

namespace sundog::pov {

/// Numbers nearer to each other than this are equal in comparisons, and nearer to zero false (manual, 3.3.1.5).
inline constexpr double kEpsilon = 1e-10;
inline constexpr std::uint8_t kColorComponents = 5;

inline bool is_true(double number) { return std::fabs(number) > kEpsilon; }

inline Value number_value(double number) {
    Value value;
    value.v[0] = number;
    return value;
}

inline Value vector_value(double x, double y, double z) {
    Value value;
    value.v = {x, y, z, 0, 0};
    value.count = 3;
    return value;
}

/// The value with `count` components or more: a float gives all of them its value, a shorter vector gets zeros.
inline Value promoted(const Value& value, std::uint8_t count) {
    Value result = value;
    if (value.count >= count) return result;
    if (value.count == 1)
        for (std::uint8_t i = 1; i < count; ++i) result.v[i] = value.v[0];
    result.count = count;
    return result;
}

/// Computes component by component, both sides promoted to the longer of them; a colour on either side makes a colour.
template <typename Operation>
Value combined(const Value& a, const Value& b, Operation operation) {
    if (a.count == 1 && b.count == 1) return number_value(operation(a.v[0], b.v[0]));
    const std::uint8_t count = a.count > b.count ? a.count : b.count;
    Value result = promoted(a, count);
    const Value right = promoted(b, count);
    for (std::uint8_t i = 0; i < count; ++i) result.v[i] = operation(result.v[i], right.v[i]);
    result.is_color = a.is_color || b.is_color;
    return result;
}

template <typename Operation>
Value each_component(const Value& a, Operation operation) {
    Value result = a;
    for (std::uint8_t i = 0; i < a.count; ++i) result.v[i] = operation(a.v[i]);
    return result;
}

/// A colour's grey as POV-Ray weighs it.
inline double gray_of(const Value& color) { return 0.297 * color.v[0] + 0.589 * color.v[1] + 0.114 * color.v[2]; }

/// Which component `.keyword` names: 0 to 4, or kGrayComponent; nothing for other words.
std::optional<std::uint8_t> component_of(Keyword keyword);

/// One component as component_of() numbers it.
inline double component(const Value& value, std::uint8_t index) { return index < 5 ? value.v[index] : gray_of(value); }

/// The colour that an rgb keyword (rgb, rgbf, …, srgbft) makes of a vector; sRGB is decoded (IEC 61966-2-1) into the
/// working space of `assumed_gamma`.
Value color_of(Keyword form, const Value& vector, double assumed_gamma);

/// Rotation about the x, then the y, then the z axis, in degrees, left-handed, as `rotate` does.
Value rotated(const Value& point, const Value& degrees);

/// Rotation about an axis through the origin.
Value rotated_about(const Value& point, const Value& axis, double degrees);

}  // namespace sundog::pov
