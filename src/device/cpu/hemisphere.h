// SPDX-License-Identifier: Apache-2.0
// Directions over a point of a surface, and what the light along them adds up to.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "device/cpu/irradiance_cache.h"
#include "device/cpu/ray_batch.h"

namespace sundog::cpu {

/// Rings and sectors of equal weight under the cosine, each with a direction in its middle. The same ones at every
/// point: what they miss then changes smoothly over a surface, rather than as grain.
class Hemisphere {
public:
    /// Axes around a unit normal, which is z.
    struct Frame {
        explicit Frame(Vec3 normal);
        [[nodiscard]] Vec3 to_world(Vec3 d) const { return x * d.x + y * d.y + z * d.z; }
        Vec3 x, y, z;
    };

    /// About `count` directions: as many as fill whole packets of rays.
    explicit Hemisphere(int count);

    /// Unit vectors around z, sector by sector, from the middle outwards.
    [[nodiscard]] const std::vector<Vec3>& directions() const { return directions_; }
    /// Sets light, gradients and reach (harmonic mean of distances) of a sample by what came along the directions.
    void integrate(std::span<const BatchAnswer> answers, const Frame& axes, IrradianceSample& sample) const;

private:
    int rings_, sectors_ = 1;
    std::vector<Vec3> directions_;
};

}  // namespace sundog::cpu
