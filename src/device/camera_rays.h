// SPDX-License-Identifier: Apache-2.0
// Cameras whose rays the kernel doesn't make (lenses, meshes, functions): the host makes them one by one.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "base/vec.h"
#include "kernel/shared.h"

namespace sundog {

/// Immutable: any number of threads may ask at once.
class CameraRays {
public:
    CameraRays() = default;
    CameraRays(const CameraRays&) = delete;
    CameraRays& operator=(const CameraRays&) = delete;
    virtual ~CameraRays() = default;

    /// Which ray is asked for: number `ray` of those that make up sample `sample` of pixel (x, y), which goes through
    /// (x + dx, y + dy).
    struct Place {
        std::uint32_t x = 0, y = 0;
        float dx = 0.5F, dy = 0.5F;
        std::uint32_t sample = 0, ray = 0;
    };
    struct Ray {
        Vec3 origin, direction;  ///< The direction is a unit vector.
        float reach = std::numeric_limits<float>::infinity();
    };

    /// A sample is the mean of at most this many rays.
    [[nodiscard]] virtual std::uint32_t most_rays() const { return 1; }
    /// Fewer rays than most_rays() will do from this many on, where they vary so little that their variance in each
    /// channel is under enough_variance().
    [[nodiscard]] virtual std::uint32_t least_rays() const { return most_rays(); }
    [[nodiscard]] virtual float enough_variance(std::uint32_t /*rays*/) const { return 0; }
    /// The ray; none where there is no such ray, so that it doesn't count. A function of its arguments alone.
    [[nodiscard]] virtual std::optional<Ray> ray(const kernel::FrameParams& frame, const Place& place) const = 0;
};

}  // namespace sundog
