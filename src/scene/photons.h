// SPDX-License-Identifier: Apache-2.0
// Photon maps as POV-Ray describes them (its reference, section 3.4.4.4 "Photons", whose names and defaults these are).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/diagnostics.h"
#include "base/photons.h"

namespace sundog::scene {

/// A property that a light and an object have a say in: it is there if neither says off and one of them says on.
enum class PhotonSwitch : std::uint8_t { unset, on, off };

/// What an object does with photons.
struct ObjectPhotons {
    bool target = false;  ///< Lights shoot at it.
    float spacing = 1;    ///< Times the scene's, between photons that are shot at it.
    PhotonSwitch refraction = PhotonSwitch::unset, reflection = PhotonSwitch::unset;
    bool collect = true;               ///< Photons are stored and seen on it.
    std::optional<bool> pass_through;  ///< Photons don't see it on their way to a target; none: if it casts no shadow.
    std::uint32_t whole = 0;           ///< Objects with the same number, unless 0, are shot at as one.
    friend bool operator==(const ObjectPhotons&, const ObjectPhotons&) = default;
};

/// What a light does with photons.
struct LightPhotons {
    PhotonSwitch refraction = PhotonSwitch::unset, reflection = PhotonSwitch::unset;
    bool area_light = false;  ///< Each of an area's lights shoots; else one in its middle.
};

/// Settings for the whole scene.
struct Photons {
    SourceLocation where;
    float spacing = 0;  ///< Between photons on what they are shot at; 0: as `count` says.
    int count = 0;      ///< How many photons are shot; 0: as `spacing` says.
    /// Where no object is marked as a target: all that mirror or refract light are targets, by their materials.
    bool find_targets = false;
    int gather_min = 20, gather_max = 100;
    int media_steps = 0;  ///< Most photons along a stretch of a medium; 0: none are stored there.
    float media_factor = 1;
    float jitter = 0.4F;
    std::optional<int> max_depth;     ///< Surfaces on a photon's way; none: as the picture's rays.
    std::optional<float> min_weight;  ///< Share below which a photon is dropped; none: as the picture's rays.
    float autostop = 1;               ///< Share of a target's bounds behind which a ring that misses it is the last.
    float expand_increase = 0.2F;
    int expand_min = 40;
    float radius = 0, radius_factor = 1;              ///< Within which photons are gathered; 0: guessed.
    float media_radius = 0, media_radius_factor = 1;  ///< The same in media.
    std::shared_ptr<const StoredPhotons> loaded;      ///< Instead of shooting.
    std::shared_ptr<const PhotonStore> store;         ///< Where what was shot is kept; null: nowhere.
};

}  // namespace sundog::scene
