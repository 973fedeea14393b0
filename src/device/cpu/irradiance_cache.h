// SPDX-License-Identifier: Apache-2.0
// Irradiance at points of surfaces, found again near them (Ward, Rubinstein and Clear, A Ray Tracing Solution for
// Diffuse Interreflection, SIGGRAPH 1988).
#pragma once

#include <cstdint>
#include <vector>

#include "base/irradiance.h"

namespace sundog::cpu {

/// What is asked of a cache.
struct IrradianceLookup {
    Vec3 light;     ///< Weighted mean of what the samples near by say.
    int count = 0;  ///< Samples near by; 0: `light` is black.
};

/// Samples by place. Answers depend on the samples and the order in which they were added alone. Threads may ask at
/// once while nobody adds.
class IrradianceCache {
public:
    /// Samples are found where their error is under `error_bound`.
    explicit IrradianceCache(float error_bound);

    void add(const IrradianceSample& sample);
    /// The mean of the samples whose error at a point is under `bound`, at most that of the cache.
    [[nodiscard]] IrradianceLookup lookup(Vec3 position, Vec3 normal, float bound) const;
    /// True if there are at least `count` of them.
    [[nodiscard]] bool has(int count, Vec3 position, Vec3 normal, float bound) const;
    [[nodiscard]] std::size_t size() const { return samples_.size(); }
    [[nodiscard]] const std::vector<IrradianceSample>& samples() const { return samples_; }

private:
    /// What tells whether a sample is near, side by side with others of its cell.
    struct Entry {
        Vec3 position;
        float reach;
        Vec3 normal;
        std::uint32_t sample;
    };
    /// All cells of one size: cubes of side 2^exponent, each with the samples that reach into it.
    struct Grid {
        int exponent;
        double per_length;  ///< 2^-exponent
    };
    /// A place of the table of all cells: which cell is under a key; empty where `entries` is 0.
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t entries = 0;  ///< Index into cells_, plus 1.
    };

    [[nodiscard]] static std::uint64_t key_of(const Grid& grid, std::int64_t x, std::int64_t y, std::int64_t z);
    [[nodiscard]] const std::vector<Entry>* cell_at(std::uint64_t key) const;
    std::vector<Entry>& make_cell(std::uint64_t key);
    void grow();
    /// Calls visit(entry, error) for each sample near by until it returns false.
    template <class Visit>
    void for_each_near(Vec3 position, Vec3 normal, float bound, const Visit& visit) const;

    float error_bound_;
    std::vector<IrradianceSample> samples_;
    std::vector<Grid> grids_;  ///< Ascending.
    std::vector<std::vector<Entry>> cells_;
    std::vector<Slot> slots_;  ///< A power of two of them, at most half of them taken; searched one by one.
};

}  // namespace sundog::cpu
