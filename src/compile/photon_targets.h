// SPDX-License-Identifier: Apache-2.0
// What objects have to do with photons: which are shot at, which see them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics.h"
#include "device/render_scene.h"
#include "scene/scene.h"

namespace sundog {

/// Light::flags' bits of what a light does with photons.
std::uint32_t photon_flags(const scene::LightPhotons& photons);

/// Numbers what photons are shot at.
class PhotonTargets {
public:
    /// Both outlive this. `out` has its materials.
    PhotonTargets(const scene::Scene& scene, RenderScene& out);

    /// Geometry::photons of a scene's object; 0 in scenes without photons.
    [[nodiscard]] std::uint32_t photons_of(std::uint32_t object) const;
    /// Geometry::hidden_from's bits of photons that don't see it; likewise.
    [[nodiscard]] std::uint32_t hidden_from(std::uint32_t object) const;
    /// Takes note of the bounds of a part of the object, in its own space; empty where it has no end. `instance`: of
    /// the part, NONE where it rests.
    void add_bounds(std::uint32_t object, const Bounds3& bounds, std::uint32_t instance);
    /// Warns of targets without an end, which nothing is shot at, and where there is nothing to shoot, or to shoot at.
    void finish(const WarningSink& warn);

private:
    /// Whether the scene says what is shot at, or that is to be found.
    [[nodiscard]] bool finds_targets() const;
    void find_targets();
    [[nodiscard]] const scene::ObjectPhotons& photons_at(std::uint32_t object) const;
    /// Photons don't see such an object on their way to what they are shot at.
    [[nodiscard]] bool is_passed(std::uint32_t object) const;

    const scene::Scene& scene_;
    RenderScene& out_;
    std::vector<std::uint32_t> numbers_;       ///< For each object its target's, from 1; 0: none.
    std::vector<scene::ObjectPhotons> found_;  ///< What objects do; empty: what they say themselves.
    std::vector<std::uint8_t> material_uses_;  ///< If found_: for each material, what it does with light.
    std::vector<std::uint32_t> endless_;       ///< Objects that have no end.
};

}  // namespace sundog
