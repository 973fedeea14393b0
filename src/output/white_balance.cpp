// SPDX-License-Identifier: Apache-2.0
#include "output/white_balance.h"

#include <algorithm>

namespace sundog::output {
namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

/// XYZ of linear sRGB (IEC 61966-2-1).
constexpr Matrix kXyzOfRgb{
    {{0.4123908, 0.3575843, 0.1804808}, {0.2126390, 0.7151687, 0.0721923}, {0.0193308, 0.1191948, 0.9505322}}};
/// Bradford's sharpened cone responses of XYZ (Lam, "Metamerism and Colour Constancy", 1985).
constexpr Matrix kConesOfXyz{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

Row times(const Matrix& m, const Row& v) {
    Row out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return out;
}

Matrix times(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    return out;
}

Matrix inverse(const Matrix& m) {
    Matrix out{};
    const auto minor = [&](std::size_t i, std::size_t j) {
        const std::size_t r0 = (i + 1) % 3, r1 = (i + 2) % 3, c0 = (j + 1) % 3, c1 = (j + 2) % 3;
        return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
    };
    const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) out[j][i] = minor(i, j) / determinant;
    return out;
}

Chromaticity daylight(double kelvin) {
    const double r = 1000 / kelvin;
    const double x = kelvin <= 7000 ? ((-4.6070 * r + 2.9678) * r + 0.09911) * r + 0.244063
                                    : ((-2.0064 * r + 1.9018) * r + 0.24748) * r + 0.237040;
    return {x, (-3.000 * x + 2.870) * x - 0.275};
}

Chromaticity black_body(double kelvin) {
    const double r = 1000 / kelvin;
    const double x = kelvin <= 4000 ? ((-0.2661239 * r - 0.2343589) * r + 0.8776956) * r + 0.179910
                                    : ((-3.0258469 * r + 2.1070379) * r + 0.2226347) * r + 0.240390;
    if (kelvin <= 2222) return {x, ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683};
    if (kelvin <= 4000) return {x, ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867};
    return {x, ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483};
}

Row cones_of(const Chromaticity& white) {
    return times(kConesOfXyz, Row{white.x / white.y, 1, (1 - white.x - white.y) / white.y});
}

}  // namespace

Chromaticity white_of_temperature(double kelvin) {
    const double t = std::clamp<double>(kelvin, kLeastKelvin, kMostKelvin);
    if (t <= 4000) return black_body(t);
    if (t >= 5000) return daylight(t);
    const Chromaticity warm = black_body(t), cool = daylight(t);
    const double share = (t - 4000) / 1000;
    return {warm.x + (cool.x - warm.x) * share, warm.y + (cool.y - warm.y) * share};
}

std::array<Vec3, 3> balance_matrix(double kelvin) {
    // Not by arithmetic, whose rounding would turn a few codes of a picture that is to stay as it is.
    if (kelvin == kNeutralKelvin) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const Row from = cones_of(white_of_temperature(kelvin)), to = cones_of(white_of_temperature(kNeutralKelvin));
    const Matrix cones_of_rgb = times(kConesOfXyz, kXyzOfRgb);
    Matrix scaled = cones_of_rgb;
    for (std::size_t i = 0; i < 3; ++i)
        for (double& entry : scaled[i]) entry *= to[i] / from[i];
    const Matrix map = times(inverse(cones_of_rgb), scaled);
    std::array<Vec3, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
        rows[i] = {static_cast<float>(map[i][0]), static_cast<float>(map[i][1]), static_cast<float>(map[i][2])};
    return rows;
}

}  // namespace sundog::output
