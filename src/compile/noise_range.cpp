// SPDX-License-Identifier: Apache-2.0
#include "compile/noise_range.h"

#include <cmath>

#include "kernel/patterns/noise.h"

// Within a cell of the lattice the noise is a polynomial of degree 4 along each axis. Its coefficients in Bernstein's
// basis for a part of the cell bound it there, tightly where the part is small (Farouki, The Bernstein polynomial
// basis: A centennial retrospective, 2012).

namespace sundog {
namespace {

/// Coefficients of degree 4, and the last one again: a row that vector instructions like.
using Row = std::array<float, 8>;
constexpr std::size_t kCoefficients = 5;

/// Along one axis, for the lower and the upper corner: its weight, and its weight times the offset from it.
struct AxisWeights {
    std::array<Row, 2> weight, offset;
};

AxisWeights weights_over(double a, double b) {
    const std::array as{1.0, a, a * a, a * a * a, a * a * a * a};
    const std::array bs{1.0, b, b * b, b * b * b, b * b * b * b};
    AxisWeights out;
    for (std::size_t i = 0; i < 8; ++i) {
        // The blossoms of x, x^2, x^3 and x^4 where j of the four arguments are b, the others a.
        const std::size_t j = std::min(i, kCoefficients - 1);
        const auto ones = static_cast<double>(j), others = 4 - ones;
        const double ones2 = ones * (ones - 1) / 2, others2 = others * (others - 1) / 2;
        const double ones3 = ones2 * (ones - 2) / 3, others3 = others2 * (others - 2) / 3;
        const double x = (ones * b + others * a) / 4;
        const double x2 = (ones2 * bs[2] + ones * others * a * b + others2 * as[2]) / 6;
        const double x3 =
            (ones3 * bs[3] + ones2 * others * bs[2] * a + ones * others2 * b * as[2] + others3 * as[3]) / 4;
        const double x4 = bs[j] * as[4 - j];
        const double upper = 3 * x2 - 2 * x3;
        out.weight[0][i] = static_cast<float>(1 - upper);
        out.weight[1][i] = static_cast<float>(upper);
        out.offset[0][i] = static_cast<float>(x - 3 * x3 + 2 * x4);
        out.offset[1][i] = static_cast<float>(5 * x3 - 3 * x2 - 2 * x4);
    }
    return out;
}

Row sum_of(const Row& a, float x, const Row& b, float y) {
    Row out;
    for (std::size_t i = 0; i < 8; ++i) out[i] = a[i] * x + b[i] * y;
    return out;
}
Row sum_of(const Row& a, const Row& b) {
    Row out;
    for (std::size_t i = 0; i < 8; ++i) out[i] = a[i] + b[i];
    return out;
}

/// Numbers of a lattice cell's lower corner.
using Cell = std::array<std::uint32_t, 3>;

/// lattice_sum() over a part of a cell, of the lattice points' word `number`.
Range sum_in_cell(const Cell& cell, const std::array<AxisWeights, 3>& axes, std::uint32_t number, float slope_share,
                  float value_share) {
    const auto& [x, y, z] = axes;
    // Along x first; then rows are blended along y, then along z.
    std::array<Row, 4> sums, y_slopes, z_slopes;
    for (std::uint32_t edge = 0; edge < 4; ++edge) {
        std::array<std::array<float, 4>, 2> corner;
        for (std::uint32_t side = 0; side < 2; ++side) {
            const std::uint32_t hash =
                kernel::lattice_hash(cell[0] + side, cell[1] + (edge & 1U), cell[2] + (edge >> 1U));
            const std::uint32_t bits = kernel::lattice_word(hash, number);
            const auto part = [&](std::uint32_t i) { return kernel::lattice_part(bits, i) / kernel::LATTICE_SCALE; };
            corner[side] = {part(3) * value_share, part(0) * slope_share, part(1) * slope_share, part(2) * slope_share};
        }
        const auto& [low, high] = corner;
        sums[edge] = sum_of(sum_of(x.weight[0], low[0], x.weight[1], high[0]),
                            sum_of(x.offset[0], low[1], x.offset[1], high[1]));
        y_slopes[edge] = sum_of(x.weight[0], low[2], x.weight[1], high[2]);
        z_slopes[edge] = sum_of(x.weight[0], low[3], x.weight[1], high[3]);
    }
    Row lower, upper;
    lower.fill(INFINITY), upper.fill(-INFINITY);
    for (std::size_t j = 0; j < kCoefficients; ++j) {
        std::array<Row, 2> along_y, slope;
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t e = 2 * side;
            along_y[side] = sum_of(sum_of(sums[e], y.weight[0][j], sums[e + 1], y.weight[1][j]),
                                   sum_of(y_slopes[e], y.offset[0][j], y_slopes[e + 1], y.offset[1][j]));
            slope[side] = sum_of(z_slopes[e], y.weight[0][j], z_slopes[e + 1], y.weight[1][j]);
        }
        for (std::size_t k = 0; k < kCoefficients; ++k) {
            const Row row = sum_of(sum_of(along_y[0], z.weight[0][k], along_y[1], z.weight[1][k]),
                                   sum_of(slope[0], z.offset[0][k], slope[1], z.offset[1][k]));
            for (std::size_t i = 0; i < 8; ++i) {
                lower[i] = row[i] < lower[i] ? row[i] : lower[i];
                upper[i] = row[i] > upper[i] ? row[i] : upper[i];
            }
        }
    }
    Range out{INFINITY, -INFINITY};
    for (std::size_t i = 0; i < kCoefficients; ++i)
        out = either(out, {static_cast<double>(lower[i]), static_cast<double>(upper[i])});
    return out;
}

/// Larger boxes have the bound of all.
constexpr int kMostCells = 8;
/// More than rounding adds to a sum, here and in the kernel; relatively, to a place.
constexpr double kSumRounding = 1e-5, kPlaceRounding = 1e-6;

/// lattice_sum() over a box, once for each of N of the lattice points' words, from number `first_word` on.
template <std::size_t N>
std::array<Range, N> sums_over(const RangeBox& box, std::uint32_t first_word, float slope_share, float value_share) {
    // Of all slopes and values at their most: in a cell's middle.
    const double limit = 1.5 * static_cast<double>(slope_share) + static_cast<double>(value_share) + kSumRounding;
    std::array<Range, N> out;
    out.fill({-limit, limit});
    RangeBox wide;
    double cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Range& r = box[axis];
        const double slack = kPlaceRounding * r.most() + 1e-9;
        wide[axis] = {r.lower - slack, r.upper + slack};
        // Out there the lattice ends.
        constexpr double kFar = 8e6;
        if (!(wide[axis].lower > -kFar && wide[axis].upper < kFar)) return out;
        cells *= std::floor(wide[axis].upper) - std::floor(wide[axis].lower) + 1;
    }
    if (cells > kMostCells) return out;
    std::array<Range, N> found;
    found.fill({INFINITY, -INFINITY});
    const auto first = [&](std::size_t axis) { return static_cast<int>(std::floor(wide[axis].lower)); };
    const auto last = [&](std::size_t axis) { return static_cast<int>(std::floor(wide[axis].upper)); };
    const auto part = [&](std::size_t axis, int cell) {
        return weights_over(std::max(wide[axis].lower - cell, 0.0), std::min(wide[axis].upper - cell, 1.0));
    };
    constexpr std::uint32_t kOrigin = 8388608;
    for (int z = first(2); z <= last(2); ++z) {
        for (int y = first(1); y <= last(1); ++y) {
            for (int x = first(0); x <= last(0); ++x) {
                const std::array axes{part(0, x), part(1, y), part(2, z)};
                const Cell cell{kOrigin + static_cast<std::uint32_t>(x), kOrigin + static_cast<std::uint32_t>(y),
                                kOrigin + static_cast<std::uint32_t>(z)};
                for (std::uint32_t i = 0; i < N; ++i)
                    found[i] = either(found[i], sum_in_cell(cell, axes, first_word + i, slope_share, value_share));
            }
        }
    }
    for (std::size_t i = 0; i < N; ++i)
        out[i] = clamped({found[i].lower - kSumRounding, found[i].upper + kSumRounding}, -limit, limit);
    return out;
}

}  // namespace

Range noise_over(const RangeBox& box, std::uint32_t generator) {
    const Range sum = sums_over<1>(box, 0, 1, kernel::NOISE_VALUE_SHARE)[0];
    const auto mean = static_cast<double>(kernel::noise_mean(generator));
    const double factor =
        static_cast<double>(kernel::noise_deviation(generator)) * static_cast<double>(kernel::NOISE_SUM_SCALE);
    return clamped(Range{mean, mean} + sum * factor, 0, 1);
}

std::array<Range, 3> noise_vector_over(const RangeBox& box) {
    return sums_over<3>(box, 1, kernel::NOISE_VECTOR_SHARE, 0);
}

}  // namespace sundog
