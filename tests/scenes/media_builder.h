// SPDX-License-Identifier: Apache-2.0
// Media for small scenes written in code.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "scenes/scene_builder.h"

namespace sundog::test {

/// Lets all light pass, unbent, into media.
inline scene::Material clear_material(std::vector<scene::Medium> media, bool hollow = true) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->color = {1, 1, 1, 0, 1};
    auto texture = std::make_shared<scene::LayeredTexture>();
    texture->layers.push_back({pigment, {}});
    scene::Material material;
    material.patterned->texture = texture;
    material.patterned->hollow = hollow;
    if (!media.empty()) {
        scene::Interior interior;
        interior.media = std::make_shared<const std::vector<scene::Medium>>(std::move(media));
        material.patterned->interior = std::make_shared<const scene::Interior>(std::move(interior));
    }
    return material;
}

inline scene::Medium absorbing(float amount) {
    scene::Medium medium;
    medium.absorption = {amount, amount, amount};
    return medium;
}

inline scene::Medium emitting(float amount) {
    scene::Medium medium;
    medium.emission = {amount, amount, amount};
    return medium;
}

/// Scatters all that it takes.
inline scene::Medium scattering(float amount, int type = 1, float eccentricity = 0) {
    scene::Medium medium;
    medium.scattering = {amount, amount, amount};
    medium.scattering_type = type;
    medium.eccentricity = eccentricity;
    return medium;
}

}  // namespace sundog::test
