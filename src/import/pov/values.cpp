// SPDX-License-Identifier: Apache-2.0
#include "import/pov/values.h"

#include <numbers>
#include <utility>

#include "base/srgb.h"
#include "import/pov/functions.h"

namespace sundog::pov {
namespace {

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

}  // namespace

std::optional<std::uint8_t> component_of(Keyword keyword) {
    switch (keyword) {
        case Keyword::x:
        case Keyword::u:
        case Keyword::red:
            return 0;
        case Keyword::y:
        case Keyword::v:
        case Keyword::green:
            return 1;
        case Keyword::z:
        case Keyword::blue:
            return 2;
        case Keyword::t:
        case Keyword::filter:
            return 3;
        case Keyword::transmit:
            return 4;
        case Keyword::gray:
            return kGrayComponent;
        default:
            return std::nullopt;
    }
}

Value color_of(Keyword form, const Value& vector, double assumed_gamma) {
    using K = Keyword;
    const bool has_filter = form == K::rgbf || form == K::rgbft || form == K::srgbf || form == K::srgbft;
    const bool has_transmit = form == K::rgbt || form == K::rgbft || form == K::srgbt || form == K::srgbft;
    const auto needed = static_cast<std::uint8_t>(3 + (has_filter ? 1 : 0) + (has_transmit ? 1 : 0));
    Value color = promoted(vector, needed);
    // A colour in the place of the vector has its transmit where it belongs already.
    if (has_transmit && !has_filter && color.count < kColorComponents) std::swap(color.v[3], color.v[4]);
    if (form == K::srgb || form == K::srgbf || form == K::srgbt || form == K::srgbft)
        for (std::size_t i = 0; i < 3; ++i) {
            color.v[i] = linear_from_srgb(color.v[i]);
            if (assumed_gamma != 1 && color.v[i] > 0) color.v[i] = std::pow(color.v[i], 1 / assumed_gamma);
        }
    color.count = kColorComponents;
    color.is_color = true;
    return color;
}

Value rotated(const Value& point, const Value& degrees) {
    const Value p = promoted(point, 3);
    const Value angles = promoted(degrees, 3);
    double x = p.v[0], y = p.v[1], z = p.v[2];
    const auto turn = [](double& a, double& b, double angle_deg) {
        const double c = std::cos(radians(angle_deg)), s = std::sin(radians(angle_deg));
        const double turned = c * a - s * b;
        b = s * a + c * b;
        a = turned;
    };
    turn(y, z, angles.v[0]);
    turn(z, x, angles.v[1]);
    turn(x, y, angles.v[2]);
    return vector_value(x, y, z);
}

Value rotated_about(const Value& point, const Value& axis, double degrees) {
    // Rodrigues 1840: p cos a + (k x p) sin a + k (k . p)(1 - cos a).
    const Value p = promoted(point, 3);
    const Value k = promoted(axis, 3);
    const double length = std::sqrt(k.v[0] * k.v[0] + k.v[1] * k.v[1] + k.v[2] * k.v[2]);
    if (length == 0) return vector_value(p.v[0], p.v[1], p.v[2]);
    const double kx = k.v[0] / length, ky = k.v[1] / length, kz = k.v[2] / length;
    const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    const double along = (kx * p.v[0] + ky * p.v[1] + kz * p.v[2]) * (1 - c);
    return vector_value(p.v[0] * c + (ky * p.v[2] - kz * p.v[1]) * s + kx * along,
                        p.v[1] * c + (kz * p.v[0] - kx * p.v[2]) * s + ky * along,
                        p.v[2] * c + (kx * p.v[1] - ky * p.v[0]) * s + kz * along);
}

}  // namespace sundog::pov
