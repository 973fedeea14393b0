// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_materials.h"

#include <algorithm>

#include "import/pov/byte_key.h"

namespace sundog::pov {
namespace {

/// True if moving the texture changes how it looks: some layer's pigment, share or normal follows space, not uv
/// coordinates.
bool follows_space(const scene::LayeredTexture& texture) {
    return std::any_of(texture.layers.begin(), texture.layers.end(), [](const scene::TextureLayer& layer) {
        const bool has_pattern = layer.pigment->kind != scene::Pigment::Kind::solid || layer.share;
        return (has_pattern && !layer.pigment->uv_mapping) || (layer.normal && !layer.normal->uv_mapping);
    });
}

/// How many materials are kept in mind at a time.
constexpr std::size_t kMostRemembered = 4096;

}  // namespace

MaterialTable::Look MaterialTable::look_of(const TexturePointer& texture) {
    const scene::TextureLayer& layer = texture->layers.front();
    const bool plain = texture->layers.size() == 1 && !texture->blended && !is_positional(*texture) &&
                       !layer.first_part && !layer.parts_end;
    if (!plain) return {texture, {}};
    if (colorless_.size() >= kMostRemembered) colorless_.clear();
    return {colorless_.try_emplace(bytes_of(layer.finish), texture).first->second, layer.pigment->color};
}

scene::Index MaterialTable::append(const Look& look, const SourceLocation& where, const Affine3d& world_from_texture,
                                   const PlacedInterior& inside) {
    scene::Material material;
    material.name = "texture";
    material.where = where;
    scene::PatternedSurface& surface = material.patterned.emplace();
    surface.texture = look.texture;
    surface.color = look.color;
    if (follows_space(*look.texture)) surface.texture_from_world = inverse(world_from_texture);
    surface.hollow = inside.hollow;
    surface.light_set = inside.light_set;
    surface.double_illuminate = inside.double_illuminate;
    if (const InteriorPointer& interior = inside.interior) {
        surface.interior = interior;
        // The table holds on to interiors, so that none comes to lie where another one was.
        const auto number = static_cast<std::uint32_t>(interiors_.size() + 1);
        surface.interior_number = interiors_.try_emplace(interior, number).first->second;
        if (interior->media) surface.interior_from_world = inverse(inside.world_from_interior);
    }
    scene_.materials.push_back(std::move(material));
    return static_cast<scene::Index>(scene_.materials.size() - 1);
}

scene::Index MaterialTable::of(const TexturePointer& texture, const Affine3d& world_from_texture,
                               const PlacedInterior& inside) {
    const scene::Interior* const interior = inside.interior.get();
    const bool has_media = interior != nullptr && interior->media;
    if (texture == last_texture_ && interior == last_interior_ && inside.hollow == last_hollow_ &&
        inside.double_illuminate == last_double_illuminate_ && inside.light_set == last_light_set_)
        return last_;
    const bool follows = follows_space(*texture);
    const Look look = look_of(texture);
    // Materials and colorless_ hold on to textures, so an address is one texture's for good.
    std::string key;
    append_bytes(key, look.texture.get(), interior, inside.hollow, inside.double_illuminate, inside.light_set);
    if (look.color)
        append_bytes(key, look.color->r, look.color->g, look.color->b, look.color->filter, look.color->transmit);
    if (has_media) append_bytes(key, inside.world_from_interior);
    if (follows) append_bytes(key, world_from_texture);
    // As for textures: what comes again does so soon.
    if (known_.size() >= kMostRemembered) known_.clear();
    const auto [known, is_new] = known_.try_emplace(std::move(key), 0);
    if (is_new) known->second = append(look, texture->layers.front().pigment->where, world_from_texture, inside);
    if (!follows && !has_media) {
        last_texture_ = texture, last_interior_ = interior, last_hollow_ = inside.hollow;
        last_double_illuminate_ = inside.double_illuminate, last_light_set_ = inside.light_set;
        last_ = known->second;
    }
    return known->second;
}

}  // namespace sundog::pov
