// SPDX-License-Identifier: Apache-2.0
// Questions about photons. Who has them is a host class behind the interface below, asked for all lanes at once.
#ifndef SUNDOG_KERNEL_LIGHTS_PHOTON_QUERY_H
#define SUNDOG_KERNEL_LIGHTS_PHOTON_QUERY_H

#include <array>

#include "kernel/shared.h"

namespace sundog::kernel {

/// Points at which photons are gathered, lane by lane, and the answers.
struct PhotonQuery {
    static constexpr int kMostLanes = 16;
    using Lanes = std::array<float, kMostLanes>;
    int lanes = 0;                          ///< Of the arrays' places, how many there are.
    std::array<uint, kMostLanes> wanted{};  ///< 1 where an answer is wanted.
    Lanes x, y, z;                          ///< Position, world space.
    Lanes normal_x, normal_y, normal_z;     ///< On surfaces: unit; photons that arrive on this side count.
    Lanes red, green, blue;                 ///< The answer: flux per area on surfaces; in media as if from one light.
    Lanes from_x, from_y, from_z;           ///< Where most of it came from: a unit vector.
};

/// Knows where photons are. Called by several threads at once.
class PhotonLight {
public:
    PhotonLight() = default;
    PhotonLight(const PhotonLight&) = delete;
    PhotonLight& operator=(const PhotonLight&) = delete;
    virtual ~PhotonLight() = default;
    /// Answers for the lanes that are wanted: black where no photons are near. Others may hold anything.
    virtual void on_surface(PhotonQuery& query) const = 0;
    virtual void in_medium(PhotonQuery& query) const = 0;
    /// False if none were stored in media.
    [[nodiscard]] virtual bool has_media() const = 0;
};

}  // namespace sundog::kernel

#endif
