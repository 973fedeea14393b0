// SPDX-License-Identifier: Apache-2.0
#include "fields/noise.h"

#include <algorithm>
#include <cmath>

#include "kernel/patterns/noise.h"

namespace sundog::fields {
namespace {

constexpr double kSlopeShare = 1;
const double kValueShare = static_cast<double>(kernel::NOISE_VALUE_SHARE);

double part_of(std::uint32_t hash, std::uint32_t part) {
    return static_cast<double>(kernel::lattice_part(hash, part)) / static_cast<double>(kernel::LATTICE_SCALE);
}

double mean_of(std::uint32_t generator) { return static_cast<double>(kernel::noise_mean(generator)); }
double factor_of(std::uint32_t generator) {
    return static_cast<double>(kernel::noise_deviation(generator)) * static_cast<double>(kernel::NOISE_SUM_SCALE);
}

std::uint32_t lattice_number(double cell) {
    const double number = cell + 8388608.0;
    // So that what is no number has a cell, too.
    return number > 0 ? static_cast<std::uint32_t>(std::min(number, 16777214.0)) : 0;
}

NoiseCell make_cell(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    NoiseCell cell;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const std::uint32_t hash = kernel::lattice_hash(x + (corner & 1U), y + (corner >> 1U & 1U), z + (corner >> 2U));
        for (std::uint32_t axis = 0; axis < 3; ++axis) cell.slope[axis][corner] = part_of(hash, axis) * kSlopeShare;
        cell.value[corner] = part_of(hash, 3) * kValueShare;
    }
    return cell;
}

/// Where a point lies: its cell, and within it.
struct Place {
    Vec3d cell, within;
    explicit Place(Vec3d p) : cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)}, within(p - cell) {}
    const NoiseCell& find(NoiseCells& cells) const {
        return cells.at(lattice_number(cell.x), lattice_number(cell.y), lattice_number(cell.z));
    }
};

/// The eight corners' terms at a place.
std::array<double, 8> corner_terms(const NoiseCell& cell, Vec3d f) {
    std::array<double, 8> h;
    for (std::size_t i = 0; i < 8; ++i)
        h[i] = cell.value[i] + cell.slope[0][i] * (f.x - static_cast<double>(i & 1U)) +
               cell.slope[1][i] * (f.y - static_cast<double>(i >> 1U & 1U)) +
               cell.slope[2][i] * (f.z - static_cast<double>(i >> 2U));
    return h;
}

/// The sum over the corners' terms, blended along x, y and z in turn, and its gradient.
NoiseSample blended(const NoiseCell& cell, Vec3d f) {
    const std::array<double, 8> h = corner_terms(cell, f);
    const Vec3d s = f * f * (Vec3d{3, 3, 3} - 2 * f);
    const Vec3d ds = 6 * f * (Vec3d{1, 1, 1} - f);
    const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
    std::array<double, 4> along_x, x_slope;
    std::array<std::array<double, 4>, 3> slopes;
    for (std::size_t i = 0; i < 4; ++i) {
        along_x[i] = mix(h[2 * i], h[2 * i + 1], s.x);
        x_slope[i] = h[2 * i + 1] - h[2 * i];
        for (std::size_t axis = 0; axis < 3; ++axis)
            slopes[axis][i] = mix(cell.slope[axis][2 * i], cell.slope[axis][2 * i + 1], s.x);
    }
    std::array<double, 2> along_y, xs, ys;
    std::array<std::array<double, 2>, 3> slopes_y;
    for (std::size_t i = 0; i < 2; ++i) {
        along_y[i] = mix(along_x[2 * i], along_x[2 * i + 1], s.y);
        xs[i] = mix(x_slope[2 * i], x_slope[2 * i + 1], s.y);
        ys[i] = along_x[2 * i + 1] - along_x[2 * i];
        for (std::size_t axis = 0; axis < 3; ++axis)
            slopes_y[axis][i] = mix(slopes[axis][2 * i], slopes[axis][2 * i + 1], s.y);
    }
    NoiseSample out;
    out.value = mix(along_y[0], along_y[1], s.z);
    out.gradient = {ds.x * mix(xs[0], xs[1], s.z) + mix(slopes_y[0][0], slopes_y[0][1], s.z),
                    ds.y * mix(ys[0], ys[1], s.z) + mix(slopes_y[1][0], slopes_y[1][1], s.z),
                    ds.z * (along_y[1] - along_y[0]) + mix(slopes_y[2][0], slopes_y[2][1], s.z)};
    return out;
}

/// The sum alone.
double value_in(const NoiseCell& cell, Vec3d f) {
    const std::array<double, 8> h = corner_terms(cell, f);
    const Vec3d s = f * f * (Vec3d{3, 3, 3} - 2 * f);
    std::array<double, 4> along_x;
    for (std::size_t i = 0; i < 4; ++i) along_x[i] = h[2 * i] + s.x * (h[2 * i + 1] - h[2 * i]);
    const double low = along_x[0] + s.y * (along_x[1] - along_x[0]);
    const double high = along_x[2] + s.y * (along_x[3] - along_x[2]);
    return low + s.z * (high - low);
}

/// Bounds of the blended sum's second derivatives within a part of a cell: f +- r, as far as it lies in the cell.
/// The sum is over corners of weight(x) weight(y) weight(z) times a linear term h; with s the blend 3f^2 - 2f^3 its
/// derivatives are differences of h along edges times s' or s'', and differences of slopes times s'.
struct Curvature {
    std::array<double, 3> pure{}, mixed{};  ///< mixed: yz, xz, xy.
};
Curvature curvature_of(const NoiseCell& cell, Vec3d f, Vec3d r) {
    std::array<double, 3> lower, upper, slope, bend;  // of each axis: the part's ends, max |s'|, max |s''|
    std::array<std::array<double, 2>, 3> reach;       // the most that the offset from the lower and upper side can be
    for (std::size_t axis = 0; axis < 3; ++axis) {
        lower[axis] = std::max(f[axis] - r[axis], 0.0);
        upper[axis] = std::min(f[axis] + r[axis], 1.0);
        const double nearest = std::clamp(0.5, std::min(lower[axis], upper[axis]), std::max(lower[axis], upper[axis]));
        slope[axis] = 6 * nearest * (1 - nearest);
        bend[axis] = 6 * std::max(std::abs(1 - 2 * lower[axis]), std::abs(1 - 2 * upper[axis]));
        reach[axis] = {upper[axis], 1 - lower[axis]};
    }
    Curvature out;
    std::array<std::array<double, 3>, 3> slope_change{};  // along an axis, of a slope
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t step = std::size_t{1} << axis;
        const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
        double difference = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            if ((i & step) != 0) continue;
            const std::size_t j = i + step;
            const std::size_t side2 = i >> second & 1U, side3 = i >> third & 1U;
            const double change2 = std::abs(cell.slope[second][j] - cell.slope[second][i]);
            const double change3 = std::abs(cell.slope[third][j] - cell.slope[third][i]);
            // Linear in the place along the axis: largest at an end of the part.
            const double at_lower = cell.slope[axis][j] * (lower[axis] - 1) - cell.slope[axis][i] * lower[axis];
            const double at_upper = cell.slope[axis][j] * (upper[axis] - 1) - cell.slope[axis][i] * upper[axis];
            const double values = cell.value[j] - cell.value[i];
            difference = std::max(difference, std::max(std::abs(values + at_lower), std::abs(values + at_upper)) +
                                                  change2 * reach[second][side2] + change3 * reach[third][side3]);
            slope_change[axis][axis] =
                std::max(slope_change[axis][axis], std::abs(cell.slope[axis][j] - cell.slope[axis][i]));
            slope_change[axis][second] = std::max(slope_change[axis][second], change2);
            slope_change[axis][third] = std::max(slope_change[axis][third], change3);
        }
        out.pure[axis] = bend[axis] * difference + 2 * slope[axis] * slope_change[axis][axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const std::size_t du = std::size_t{1} << u, dv = std::size_t{1} << v, da = std::size_t{1} << axis;
        double twist = 0;
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t i = side * da;
            const auto& g = cell.slope;
            const auto twisted = [&](const std::array<double, 8>& h) {
                return h[i + du + dv] - h[i + du] - h[i + dv] + h[i];
            };
            const double along_u =
                std::max(std::abs(g[u][i] - g[u][i + dv]), std::abs(g[u][i + du + dv] - g[u][i + du]));
            const double along_v =
                std::max(std::abs(g[v][i] - g[v][i + du]), std::abs(g[v][i + du + dv] - g[v][i + dv]));
            twist = std::max(twist, std::abs(twisted(cell.value)) + along_u + along_v +
                                        std::abs(twisted(g[axis])) * reach[axis][side]);
        }
        out.mixed[axis] = slope[u] * slope[v] * twist + slope[u] * slope_change[u][v] + slope[v] * slope_change[v][u];
    }
    return out;
}

/// What no cell exceeds: all values and slopes at their most.
Curvature curvature_limit() {
    const double edge = 3 * kSlopeShare + 2 * kValueShare;
    const double twist = 6 * kSlopeShare + 4 * kValueShare;
    Curvature out;
    out.pure.fill(6 * edge);
    out.mixed.fill(2.25 * twist + 6 * kSlopeShare);
    return out;
}

}  // namespace

const NoiseCell& NoiseCells::at(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    const std::uint64_t key = static_cast<std::uint64_t>(x) << 32U | y;
    const std::size_t slot = (x ^ y * 5U ^ z * 11U) % kCount;
    if (keys_[slot] != key || z_[slot] != z) {
        cells_[slot] = make_cell(x, y, z);
        keys_[slot] = key;
        z_[slot] = z;
    }
    return cells_[slot];
}

double noise_at(NoiseCells& cells, Vec3d p, std::uint32_t generator) {
    const Place place(p);
    return std::clamp(mean_of(generator) + factor_of(generator) * value_in(place.find(cells), place.within), 0.0, 1.0);
}

NoiseSample noise_with_gradient(NoiseCells& cells, Vec3d p, std::uint32_t generator) {
    const Place place(p);
    const NoiseSample sum = blended(place.find(cells), place.within);
    return {mean_of(generator) + factor_of(generator) * sum.value, sum.gradient * factor_of(generator)};
}

NoiseOverBox noise_over_box(NoiseCells& cells, Vec3d centre, Vec3d half_size, std::uint32_t generator) {
    const Place place(centre);
    const NoiseSample sum = blended(place.find(cells), place.within);
    // The cells that the box touches: up to two of them are looked at, more have the bound of all.
    std::array<int, 3> first{}, last{};
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double below = place.within[axis] - half_size[axis], above = place.within[axis] + half_size[axis];
        if (!(below >= -1 && above <= 2)) count = 9;
        first[axis] = below < 0 ? -1 : 0;
        last[axis] = above > 1 ? 1 : 0;
        count *= static_cast<std::size_t>(last[axis] - first[axis] + 1);
    }
    // Out there the lattice ends, and the noise with it.
    constexpr double kFar = 8e6;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!(std::abs(centre[axis]) + half_size[axis] < kFar)) return {{}, INFINITY};
    Curvature worst;
    if (count > 2) {
        worst = curvature_limit();
    } else {
        for (int z = first[2]; z <= last[2]; ++z) {
            for (int y = first[1]; y <= last[1]; ++y) {
                for (int x = first[0]; x <= last[0]; ++x) {
                    const Vec3d shift{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                    const Vec3d cell = place.cell + shift;
                    const Curvature c =
                        curvature_of(cells.at(lattice_number(cell.x), lattice_number(cell.y), lattice_number(cell.z)),
                                     place.within - shift, half_size);
                    for (std::size_t i = 0; i < 3; ++i) {
                        worst.pure[i] = std::max(worst.pure[i], c.pure[i]);
                        worst.mixed[i] = std::max(worst.mixed[i], c.mixed[i]);
                    }
                }
            }
        }
    }
    const Vec3d r = half_size;
    // Taylor's remainder: half the quadratic form of the bounds.
    const double remainder = 0.5 * (worst.pure[0] * r.x * r.x + worst.pure[1] * r.y * r.y + worst.pure[2] * r.z * r.z) +
                             worst.mixed[0] * r.y * r.z + worst.mixed[1] * r.x * r.z + worst.mixed[2] * r.x * r.y;
    const double factor = factor_of(generator);
    NoiseOverBox out;
    out.centre = {mean_of(generator) + factor * sum.value, sum.gradient * factor};
    out.error = factor * remainder * (1 + 1e-12) + 1e-13;
    return out;
}

double noise_slope_limit(std::uint32_t generator) {
    return factor_of(generator) * (1.5 * (3 * kSlopeShare + 2 * kValueShare) + kSlopeShare);
}

Vec3d turbulence(Vec3d p, double lambda, double omega, double octaves) {
    const kernel::real3 at(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
    const auto count = static_cast<std::uint32_t>(std::clamp(octaves, 1.0, 10.0));
    const kernel::real3 v = kernel::turbulence_vector(at, count, static_cast<float>(lambda), static_cast<float>(omega));
    return {v.x, v.y, v.z};
}

}  // namespace sundog::fields
