// SPDX-License-Identifier: Apache-2.0
// The scene's materials, one for each texture and place that it lies in.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "import/pov/build_texture.h"
#include "scene/scene.h"

namespace sundog::pov {

/// What is inside an object, where its media lie, and which light it gets. Nothing: air.
struct PlacedInterior {
    InteriorPointer interior{};
    Affine3d world_from_interior{};
    bool hollow = false;
    bool double_illuminate = false;
    std::uint32_t light_set = 0;  ///< As scene::PatternedSurface's.
};

/// Makes materials of textures. Textures that look the same everywhere share one, wherever they are used.
class MaterialTable {
public:
    explicit MaterialTable(scene::Scene& scene) : scene_(scene) {}

    /// The material of a texture that lies in the world as `world_from_texture` says.
    scene::Index of(const TexturePointer& texture, const Affine3d& world_from_texture, const PlacedInterior& inside);

private:
    /// A texture as materials have it: those that are a colour and a finish share one, and keep their colour.
    struct Look {
        TexturePointer texture;
        std::optional<scene::PigmentColor> color;
    };
    Look look_of(const TexturePointer& texture);
    scene::Index append(const Look& look, const SourceLocation& where, const Affine3d& world_from_texture,
                        const PlacedInterior& inside);

    scene::Scene& scene_;
    std::unordered_map<std::string, scene::Index> known_;
    std::unordered_map<std::string, TexturePointer> colorless_;     // By bytes_of() their finish.
    std::unordered_map<InteriorPointer, std::uint32_t> interiors_;  // Their numbers, from 1.
    TexturePointer last_texture_;                                   // Of the last material that is the same everywhere.
    const scene::Interior* last_interior_ = nullptr;
    bool last_hollow_ = false, last_double_illuminate_ = false;
    std::uint32_t last_light_set_ = 0;
    scene::Index last_ = 0;
};

}  // namespace sundog::pov
