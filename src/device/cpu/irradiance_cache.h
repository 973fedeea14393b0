// SPDX-License-Identifier: Apache-2.0
// Irradiance at points of surfaces, found again near them (Ward, Rubinstein and Clear, A Ray Tracing Solution for
// Diffuse Interreflection, SIGGRAPH 1988).
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/vec.h"

namespace sundog::cpu {

/// Light that arrives at a point, as what a white surface there sends back of it (irradiance over pi).
struct IrradianceSample {
    Vec3 position;
    Vec3 normal;      ///< Unit; the side on which the light arrives.
    Vec3 light;       ///< Linear RGB.
    float reach = 0;  ///< Distance at which the estimated error is 1: mean distance of what sends the light.
};

/// What is asked of a cache.
struct IrradianceLookup {
    Vec3 light;        ///< Weighted mean of the samples near by.
    float weight = 0;  ///< 0: there are none, `light` is black.
    int count = 0;     ///< Samples near by.
};

/// Samples by place. Answers depend on the samples and the order in which they were added alone. Threads may ask at
/// once while nobody adds.
class IrradianceCache {
public:
    /// Samples are found where their error is under `error_bound`.
    explicit IrradianceCache(float error_bound) : error_bound_(error_bound) {}

    void add(const IrradianceSample& sample);
    /// The mean of the samples whose error at a point is under `bound`, at most that of the cache.
    [[nodiscard]] IrradianceLookup lookup(Vec3 position, Vec3 normal, float bound) const;
    [[nodiscard]] std::size_t size() const { return samples_.size(); }

private:
    /// Cubes of side 2^exponent, each with the samples that reach into it.
    [[nodiscard]] static std::uint64_t key_of(int exponent, std::int64_t x, std::int64_t y, std::int64_t z);

    float error_bound_;
    std::vector<IrradianceSample> samples_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
    std::vector<int> exponents_;  ///< Of the cells in use, ascending.
};

}  // namespace sundog::cpu
