// SPDX-License-Identifier: Apache-2.0
// What radiosity gathers, as it is kept: by devices, and in files.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace sundog {

/// Light that arrives at a point, as what a white surface there sends back of it (irradiance over pi).
struct IrradianceSample {
    Vec3 position;
    Vec3 normal;      ///< Unit; the side on which the light arrives.
    Vec3 light;       ///< Linear RGB.
    float reach = 0;  ///< Distance at which the estimated error is 1: mean distance of what sends the light.
    /// How `light` changes as the point moves, and as the normal turns about an axis; one vector a channel (Ward and
    /// Heckbert, Irradiance Gradients, Eurographics Workshop on Rendering 1992).
    std::array<Vec3, 3> by_move{}, by_turn{};

    /// Keeps what the gradients say of points within the reach from going beyond the light itself.
    void limit_gradients();
};

/// A sample, and after how many bounces the eye sees its light.
struct StoredIrradiance {
    IrradianceSample sample;
    std::uint32_t bounce = 0;  ///< 0: what the eye sees is lit by it.
};
using StoredRadiosity = std::vector<StoredIrradiance>;

/// Where the samples of a picture are to be kept for later.
class RadiosityStore {
public:
    RadiosityStore() = default;
    RadiosityStore(const RadiosityStore&) = delete;
    RadiosityStore& operator=(const RadiosityStore&) = delete;
    virtual ~RadiosityStore() = default;
    /// Called once all is gathered, with what was loaded, too. Errors: those of the store, for what can't be written.
    virtual void keep(const StoredRadiosity& samples) const = 0;
};

}  // namespace sundog
