// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_materials.h"

#include <algorithm>

namespace sundog::pov {
namespace {

/// True if moving the texture changes how it looks: some layer's pigment or normal follows space, not uv coordinates.
bool follows_space(const scene::LayeredTexture& texture) {
    return std::any_of(texture.layers.begin(), texture.layers.end(), [](const scene::TextureLayer& layer) {
        return (layer.pigment->kind != scene::Pigment::Kind::solid && !layer.pigment->uv_mapping) ||
               (layer.normal && !layer.normal->uv_mapping);
    });
}

/// How many materials are kept in mind at a time.
constexpr std::size_t kMostRemembered = 65536;

template <class T>
void append_bytes(std::string& key, const T& value) {
    // Of addresses, too.
    key.append(reinterpret_cast<const char*>(&value), sizeof(value));  // NOLINT(bugprone-sizeof-expression)
}

}  // namespace

scene::Index MaterialTable::append(const TexturePointer& texture, const Affine3d& world_from_texture,
                                   const PlacedInterior& inside) {
    scene::Material material;
    material.name = "texture";
    material.where = texture->layers.front().pigment->where;
    material.patterned = scene::PatternedSurface{texture, inverse(world_from_texture), {}, {}, inside.hollow, 0};
    material.patterned->light_set = inside.light_set;
    material.patterned->double_illuminate = inside.double_illuminate;
    if (const InteriorPointer& interior = inside.interior) {
        material.patterned->interior = *interior;
        // The table holds on to interiors, so that none comes to lie where another one was.
        const auto number = static_cast<std::uint32_t>(interiors_.size() + 1);
        material.patterned->interior_number = interiors_.try_emplace(interior, number).first->second;
        if (interior->media) material.patterned->interior_from_world = inverse(inside.world_from_interior);
    }
    scene_.materials.push_back(std::move(material));
    return static_cast<scene::Index>(scene_.materials.size() - 1);
}

scene::Index MaterialTable::of(const TexturePointer& texture, const Affine3d& world_from_texture,
                               const PlacedInterior& inside) {
    const scene::Interior* const interior = inside.interior.get();
    const bool has_media = interior != nullptr && interior->media;
    if (texture.get() == last_texture_ && interior == last_interior_ && inside.hollow == last_hollow_ &&
        inside.double_illuminate == last_double_illuminate_ && inside.light_set == last_light_set_)
        return last_;
    const bool follows = follows_space(*texture);
    const Affine3d placed = follows ? world_from_texture : Affine3d{};
    std::string key;
    append_bytes(key, texture.get());
    append_bytes(key, interior);
    append_bytes(key, inside.hollow);
    append_bytes(key, inside.double_illuminate);
    append_bytes(key, inside.light_set);
    if (has_media) append_bytes(key, inside.world_from_interior);
    if (follows) append_bytes(key, placed);
    // As for textures: what comes again does so soon.
    if (known_.size() >= kMostRemembered) known_.clear();
    const auto [known, is_new] = known_.try_emplace(std::move(key), 0);
    if (is_new) known->second = append(texture, placed, inside);
    if (!follows && !has_media) {
        last_texture_ = texture.get(), last_interior_ = interior, last_hollow_ = inside.hollow;
        last_double_illuminate_ = inside.double_illuminate, last_light_set_ = inside.light_set;
        last_ = known->second;
    }
    return known->second;
}

}  // namespace sundog::pov
