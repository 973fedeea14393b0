// SPDX-License-Identifier: Apache-2.0
// Matt light that surfaces send each other. Who knows how much arrives where is the device's own: a host class behind
// the interface below, asked for all lanes at once. The CPU's alone; shaders never see this header.
#ifndef SUNDOG_KERNEL_LIGHTS_INDIRECT_H
#define SUNDOG_KERNEL_LIGHTS_INDIRECT_H

#include <array>
#include <cstring>

#include "kernel/materials/material.h"

namespace sundog::kernel {

/// Points at which irradiance is asked for, lane by lane, and the answers.
struct IndirectQuery {
    static constexpr int kMostLanes = 16;
    using Lanes = std::array<float, kMostLanes>;
    int lanes = 0;                          ///< Of the arrays' places, how many there are.
    std::array<uint, kMostLanes> wanted{};  ///< 1 where an answer is wanted.
    Lanes x, y, z;                          ///< Position, world space.
    Lanes normal_x, normal_y, normal_z;     ///< Unit; the side that is lit is the one it points to.
    Lanes face_x, face_y, face_z;           ///< Unit normal of the surface itself, to the same side.
    Lanes error;                            ///< How far off the surface a ray starts.
    Lanes red, green, blue;                 ///< The answer: what a white surface sends back of it.
};

/// Knows how much light arrives from other surfaces. Called by several threads at once.
class IndirectLight {
public:
    IndirectLight() = default;
    IndirectLight(const IndirectLight&) = delete;
    IndirectLight& operator=(const IndirectLight&) = delete;
    virtual ~IndirectLight() = default;
    /// Answers for the lanes that are wanted; others may hold anything.
    virtual void answer(const SceneView& scene, IndirectQuery& query) const = 0;
    /// True if bent normals count, not the surface's smooth ones.
    [[nodiscard]] virtual bool uses_bent_normals() const = 0;
};

}  // namespace sundog::kernel

KERNEL_BEGIN

/// Copies varying numbers to memory, lane by lane.
template <class T, class Place>
FN void store_lanes(T value, Place& place) {
    static_assert(sizeof(value) <= sizeof(place));
    std::memcpy(place.data(), &value, sizeof(value));
}
FN real load_lanes(const IndirectQuery::Lanes& place) {
    real value;
    std::memcpy(&value, place.data(), sizeof(value));
    return value;
}

/// The matt light that the lanes of `found` send back of what other surfaces send them; black in other lanes.
/// `smooth_normal` is the surface's before patterns bent it; `weight` is what counts of the answer.
inline real3 indirect_light(SCENE LARGE(Surface) s, real3 smooth_normal, LARGE(Lobes) lobes, real3 weight, mask found) {
    real3 black = real3(real(0.0f));
    real3 share = weight * lobes.albedo;
    mask wanted = mask_and(found, largest(share) > real(0.0f));
    if (!any_lane(wanted)) return black;
    real3 normal = scene.indirect->uses_bent_normals() ? s.normal : smooth_normal;
    // One that turns to the surface's other side is seen at a grazing angle at most.
    real3 lifted = normal - s.geometric_normal * dot(normal, s.geometric_normal);
    lifted = normalize(lifted + s.geometric_normal * 1.0e-3f);
    normal = select(dot(normal, s.geometric_normal) <= real(0.0f), lifted, normal);
    IndirectQuery query;
    query.lanes = static_cast<int>(sizeof(real) / sizeof(float));  // NOLINT(bugprone-sizeof-expression): or is a float
    store_lanes(select(wanted, word(1u), word(0u)), query.wanted);
    store_lanes(s.position.x, query.x);
    store_lanes(s.position.y, query.y);
    store_lanes(s.position.z, query.z);
    store_lanes(normal.x, query.normal_x);
    store_lanes(normal.y, query.normal_y);
    store_lanes(normal.z, query.normal_z);
    store_lanes(s.geometric_normal.x, query.face_x);
    store_lanes(s.geometric_normal.y, query.face_y);
    store_lanes(s.geometric_normal.z, query.face_z);
    store_lanes(s.error, query.error);
    scene.indirect->answer(scene, query);
    real3 irradiance = real3(load_lanes(query.red), load_lanes(query.green), load_lanes(query.blue));
    return select(wanted, lobes.albedo * irradiance, black);
}

KERNEL_END

#endif
