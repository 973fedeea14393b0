// SPDX-License-Identifier: Apache-2.0
// The pattern in which a light shoots photons at a target: rings around the way to the target's middle, evenly spaced
// and evenly filled, each photon moved a little at random (POV-Ray's reference, section 3.4.4.4.9.1 "Autostop").
#pragma once

#include <cstdint>

#include "base/vec3d.h"
#include "device/cpu/photon_batch.h"

namespace sundog::cpu {

/// Rings of directions from a point, or of places for parallel rays.
class PhotonPattern {
public:
    /// From `place`, or parallel along `direction` and starting `ahead` before the target's middle; at a ball.
    static PhotonPattern from_point(Vec3 place, Vec3 center, float radius);
    static PhotonPattern parallel(Vec3 direction, float ahead, Vec3 center, float radius);

    /// What all rings together are, as an area where the target is.
    [[nodiscard]] double area() const;
    /// Sets how far apart photons are at the target, what moves them (a share of the way to the next one), and what
    /// makes their randomness differ from other patterns'.
    void set_spacing(double spacing, double jitter, std::uint32_t seed);

    [[nodiscard]] std::uint64_t count() const;
    [[nodiscard]] std::uint32_t ring_count() const { return rings_; }
    [[nodiscard]] std::uint32_t count_in(std::uint32_t ring) const;
    /// How far out a ring's inner rim is, of the whole pattern.
    [[nodiscard]] double progress(std::uint32_t ring) const;
    /// A photon of a ring; its power is the solid angle, or the area, that it stands for.
    [[nodiscard]] BatchPhoton photon(std::uint32_t ring, std::uint32_t number) const;

private:
    Vec3d origin_, axis_, side_, up_;
    bool is_parallel_ = false;
    double reach_ = 0;     ///< Of the rings: an angle in radians, or a length.
    double distance_ = 0;  ///< To the target's middle.
    double step_ = 1;      ///< From ring to ring.
    double jitter_ = 0;
    std::uint32_t rings_ = 0, seed_ = 0;
};

}  // namespace sundog::cpu
