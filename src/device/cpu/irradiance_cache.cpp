// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/irradiance_cache.h"

#include <algorithm>
#include <cmath>

namespace sundog::cpu {
namespace {

/// How far in front of a point, over its reach, a sample may lie: surfaces are curved.
constexpr float kInFront = 0.01F;
/// Least cosine between the normals of a sample and of a point that uses it.
constexpr float kLeastCosine = 0.9F;

/// Of one coordinate, the cells' number; far away ones share the last.
std::int64_t cell_of(float coordinate, int exponent) {
    return static_cast<std::int64_t>(
        std::floor(std::clamp(std::ldexp(static_cast<double>(coordinate), -exponent), -9e15, 9e15)));
}

}  // namespace

std::uint64_t IrradianceCache::key_of(int exponent, std::int64_t x, std::int64_t y, std::int64_t z) {
    // Two cells that meet in one key only make for samples that are looked at in vain.
    const auto mix = [](std::uint64_t h, std::int64_t v) {
        h = (h ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15ULL;
        return h ^ (h >> 29U);
    };
    return mix(mix(mix(mix(0, exponent), x), y), z);
}

void IrradianceCache::add(const IrradianceSample& sample) {
    const auto index = static_cast<std::uint32_t>(samples_.size());
    samples_.push_back(sample);
    const float radius = std::max(sample.reach * error_bound_, 1e-30F);
    const int exponent = std::ilogb(radius) + 2;  // a side of two to four radii: at most two cells each way
    const auto at = std::lower_bound(exponents_.begin(), exponents_.end(), exponent);
    if (at == exponents_.end() || *at != exponent) exponents_.insert(at, exponent);
    const Vec3 r{radius, radius, radius};
    const Vec3 lower = sample.position - r;
    const Vec3 upper = sample.position + r;
    for (std::int64_t x = cell_of(lower.x, exponent); x <= cell_of(upper.x, exponent); ++x)
        for (std::int64_t y = cell_of(lower.y, exponent); y <= cell_of(upper.y, exponent); ++y)
            for (std::int64_t z = cell_of(lower.z, exponent); z <= cell_of(upper.z, exponent); ++z) {
                std::vector<std::uint32_t>& cell = cells_[key_of(exponent, x, y, z)];
                // Both of two cells may have one key.
                if (cell.empty() || cell.back() != index) cell.push_back(index);
            }
}

IrradianceLookup IrradianceCache::lookup(Vec3 position, Vec3 normal, float bound) const {
    IrradianceLookup found;
    for (const int exponent : exponents_) {
        const auto cell = cells_.find(key_of(exponent, cell_of(position.x, exponent), cell_of(position.y, exponent),
                                             cell_of(position.z, exponent)));
        if (cell == cells_.end()) continue;
        for (const std::uint32_t index : cell->second) {
            const IrradianceSample& s = samples_[index];
            const Vec3 offset = position - s.position;
            const float far = bound * s.reach;
            const float square = dot(offset, offset);
            if (square >= far * far) continue;
            const float cosine = dot(normal, s.normal);
            // By Ward's estimate alone a generous bound would let a wall light the floor.
            if (cosine < kLeastCosine) continue;
            const float error = std::sqrt(square) / s.reach + std::sqrt(std::max(1 - cosine, 0.0F));
            if (error >= bound) continue;
            // A sample in front of the point doesn't see what shades it.
            if (dot(offset, normal + s.normal) < -2 * kInFront * s.reach) continue;
            const float weight = 1 - error / bound;
            found.light += s.light * weight;
            found.weight += weight;
            ++found.count;
        }
    }
    if (found.weight > 0) found.light = found.light / found.weight;
    return found;
}

}  // namespace sundog::cpu
