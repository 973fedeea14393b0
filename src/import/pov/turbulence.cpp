// SPDX-License-Identifier: Apache-2.0
#include "import/pov/turbulence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sundog::pov {
namespace {

/// Mixes a cell's coordinates (the finaliser of MurmurHash3, Appleby 2011).
std::uint32_t hash_of(std::int64_t x, std::int64_t y, std::int64_t z) {
    auto h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U ^ static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fU ^
             static_cast<std::uint64_t>(z) * 0x165667b19e3779f9U;
    h = (h ^ h >> 33U) * 0xff51afd7ed558ccdU;
    h = (h ^ h >> 33U) * 0xc4ceb9fe1a85ec53U;
    return static_cast<std::uint32_t>(h ^ h >> 33U);
}

/// The product with one of the twelve directions to the middles of a cube's edges.
double along_edge(std::uint32_t hash, double x, double y, double z) {
    const std::uint32_t edge = hash % 12;
    const double a = edge < 4 ? y : x;
    const double b = edge < 8 ? z : y;
    return ((hash >> 8U & 1U) != 0 ? a : -a) + ((hash >> 9U & 1U) != 0 ? b : -b);
}

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

double noise(Vec3d p) {
    const auto cell = [](double v) { return std::clamp(std::floor(v), -9e15, 9e15); };
    const double x0 = cell(p.x), y0 = cell(p.y), z0 = cell(p.z);
    const double x = std::clamp(p.x - x0, 0.0, 1.0), y = std::clamp(p.y - y0, 0.0, 1.0),
                 z = std::clamp(p.z - z0, 0.0, 1.0);
    const double u = fade(x), v = fade(y), w = fade(z);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const double weight = (i != 0 ? u : 1 - u) * (j != 0 ? v : 1 - v) * (k != 0 ? w : 1 - w);
        const std::uint32_t hash = hash_of(static_cast<std::int64_t>(x0) + i, static_cast<std::int64_t>(y0) + j,
                                           static_cast<std::int64_t>(z0) + k);
        sum += weight * along_edge(hash, x - i, y - j, z - k);
    }
    return std::clamp(0.5 + 0.5 * sum, 0.0, 1.0);
}

Vec3d vector_noise(Vec3d p) {
    const auto one = [&](double shift) { return 2 * noise(p + Vec3d{shift, 2 * shift, 3 * shift}) - 1; };
    return {one(0), one(1017.37), one(-2011.91)};
}

Vec3d turbulence(Vec3d point, double lambda, double omega, double octaves) {
    Vec3d sum;
    double frequency = 1, strength = 1;
    const int count = static_cast<int>(std::clamp(octaves, 1.0, 10.0));
    for (int i = 0; i < count; ++i) {
        sum += vector_noise(point * frequency) * strength;
        frequency *= lambda;
        strength *= omega;
    }
    return sum;
}

}  // namespace sundog::pov
