// SPDX-License-Identifier: Apache-2.0
// The yardstick of the CPU device: Embree's packets on the same rays, with nothing else.
#pragma once

#include <memory>
#include <string>

#include "device/render_scene.h"

namespace sundog::bench {

/// What one frame traced.
struct RawFrame {
    std::uint64_t rays = 0;         ///< Of all kinds.
    std::uint64_t shadow_rays = 0;  ///< Of them.
    std::uint64_t blocked = 0;      ///< Shadow rays that met something opaque.
};

/// Embree over a compiled scene of triangles and spheres that don't move.
class RawEmbree {
public:
    /// lanes: 4, 8 or 16 rays a packet; 0: the most that this processor runs. Errors: DeviceError for a scene with
    /// boxes, planes or moving geometry, or for too many lanes.
    RawEmbree(std::shared_ptr<const RenderScene> scene, int threads, int lanes = 0);
    ~RawEmbree();
    RawEmbree(const RawEmbree&) = delete;
    RawEmbree& operator=(const RawEmbree&) = delete;

    /// Traces the rays of a whole frame in tiles of 32x32 pixels.
    RawFrame trace(const Frame& frame);
    /// "Embree 3.13.5, packets of 16".
    [[nodiscard]] std::string name() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sundog::bench
