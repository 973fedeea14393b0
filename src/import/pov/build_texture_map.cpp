// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_texture_map.h"

#include <algorithm>

#include "import/pov/build_normal.h"
#include "import/pov/build_pattern.h"
#include "import/pov/build_pigment.h"

namespace sundog::pov {
namespace {

using scene::Finish;

/// As many as devices draw (kernel::MAX_LAYERS); more are blended.
constexpr std::size_t kMostLayers = 8;

Finish mean(const std::vector<Finish>& finishes) {
    Finish result = finishes.front();
    const float share = 1 / static_cast<float>(finishes.size());
    const auto average = [&](auto member) {
        auto sum = finishes.front().*member * 0.0F;
        for (const Finish& f : finishes) sum = sum + f.*member * share;
        result.*member = sum;
    };
    for (const auto member :
         {&Finish::ambient, &Finish::emission, &Finish::reflection_min, &Finish::reflection_max, &Finish::translucency})
        average(member);
    for (const auto member : {&Finish::diffuse, &Finish::diffuse_back, &Finish::brilliance, &Finish::phong,
                              &Finish::phong_size, &Finish::specular, &Finish::roughness, &Finish::metallic,
                              &Finish::reflection_falloff, &Finish::reflection_exponent, &Finish::reflection_metallic,
                              &Finish::crand, &Finish::irid, &Finish::irid_thickness, &Finish::irid_turbulence})
        average(member);
    return result;
}

std::shared_ptr<const scene::Pigment> clear_pigment() {
    scene::Pigment clear;
    clear.color = {1, 1, 1, 0, 1};
    return std::make_shared<const scene::Pigment>(clear);
}

}  // namespace

namespace {

/// The share of entry `index` of a pattern's, times the share that it has already.
std::shared_ptr<const scene::Pigment> share_of(const scene::Pattern& pattern, const std::vector<TextureEntry>& entries,
                                               std::size_t index, const scene::TextureLayer& layer,
                                               SourceLocation where) {
    auto share = std::make_shared<scene::Pigment>();
    share->where = std::move(where);
    share->pattern = pattern;
    share->kind = choice_count(pattern.kind) > 0 ? scene::Pigment::Kind::choice : scene::Pigment::Kind::mapped;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const float value = i == index ? 1.0F : 0.0F;
        share->entries.push_back({entries[i].at, {value, value, value, 0, 0}, i == index ? layer.share : nullptr});
    }
    return share;
}

/// True for a texture that is nothing but parts side by side, or has none.
bool can_be_part(const scene::LayeredTexture& texture) {
    const auto& layers = texture.layers;
    const auto has_share = [](const scene::TextureLayer& layer) { return layer.share != nullptr; };
    if (std::none_of(layers.begin(), layers.end(), has_share)) return true;
    return layers.back().first_part && layers.front().parts_end &&
           std::count_if(layers.begin(), layers.end(), [](const auto& layer) { return layer.first_part; }) == 1;
}

/// The entries side by side, each with its share: finishes and normals are exactly theirs.
scene::LayeredTexture textures_side_by_side(BuildContext& context, Place where, const scene::Pattern& pattern,
                                            const std::vector<TextureEntry>& entries) {
    scene::LayeredTexture result;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        std::vector<scene::TextureLayer> layers = entries[i].texture->layers;
        if (!layers.back().share) layers.back().share = share_of(pattern, entries, i, {}, context.location(where));
        else
            for (scene::TextureLayer& layer : layers)
                if (layer.share) layer.share = share_of(pattern, entries, i, layer, context.location(where));
        for (scene::TextureLayer& layer : layers) {
            layer.first_part = layer.parts_end = false;
            result.layers.push_back(std::move(layer));
        }
    }
    result.layers.front().parts_end = true;
    result.layers.back().first_part = true;
    return result;
}

/// Layer by layer, the pigments blended and the finishes averaged.
scene::LayeredTexture textures_blended(BuildContext& context, Place where, const scene::Pattern& pattern,
                                       const std::vector<TextureEntry>& entries, bool finishes_equal) {
    std::size_t layer_count = 0;
    for (const TextureEntry& entry : entries) layer_count = std::max(layer_count, entry.texture->layers.size());
    scene::LayeredTexture result;
    for (std::size_t i = 0; i < layer_count; ++i) {
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->where = context.location(where);
        pigment->pattern = pattern;
        pigment->kind = choice_count(pattern.kind) > 0 ? scene::Pigment::Kind::choice : scene::Pigment::Kind::mapped;
        std::vector<Finish> finishes;
        std::vector<NormalEntry> normals;
        for (const TextureEntry& entry : entries) {
            const bool has_layer = i < entry.texture->layers.size();
            pigment->entries.push_back({entry.at, {}, has_layer ? entry.texture->layers[i].pigment : clear_pigment()});
            normals.push_back({entry.at, has_layer ? entry.texture->layers[i].normal : nullptr});
            if (has_layer) finishes.push_back(entry.texture->layers[i].finish);
        }
        result.layers.push_back({std::move(pigment), finishes_equal ? finishes.front() : mean(finishes),
                                 blend_normals(pattern, std::move(normals))});
    }
    return result;
}

}  // namespace

scene::LayeredTexture blend_textures(BuildContext& context, Place where, const scene::Pattern& pattern,
                                     std::vector<TextureEntry> entries) {
    if (choice_count(pattern.kind) == 0)
        std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    // Plain ones, alike but for their pigments, are a texture with a blended pigment: that is quicker.
    const Finish& finish = entries.front().texture->layers.front().finish;
    std::size_t layer_count = 0;
    bool finishes_equal = true, can_be_parts = true, any_normal = false;
    for (const TextureEntry& entry : entries) {
        layer_count += entry.texture->layers.size();
        can_be_parts = can_be_parts && can_be_part(*entry.texture);
        for (const scene::TextureLayer& layer : entry.texture->layers) {
            finishes_equal = finishes_equal && same_finishes(layer.finish, finish) && !layer.share;
            any_normal = any_normal || layer.normal;
        }
    }
    const bool simple = finishes_equal && !any_normal && layer_count == entries.size();
    const bool parts = !simple && can_be_parts && layer_count <= kMostLayers;
    std::vector<TextureEntry> plain = entries;
    for (TextureEntry& entry : plain)
        if (entry.texture->blended) entry.texture = entry.texture->blended;
    if (!parts && !finishes_equal)
        context.warn_once("texture_map finishes", where, "the finishes of a texture's parts are averaged",
                          "pigments are drawn as written");
    scene::LayeredTexture blended = textures_blended(context, where, pattern, plain, finishes_equal);
    if (!parts) return blended;
    scene::LayeredTexture result = textures_side_by_side(context, where, pattern, entries);
    result.blended = std::make_shared<const scene::LayeredTexture>(std::move(blended));
    return result;
}

bool same_finishes(const Finish& a, const Finish& b) {
    return a.ambient == b.ambient && a.emission == b.emission && a.diffuse == b.diffuse &&
           a.diffuse_back == b.diffuse_back && a.brilliance == b.brilliance && a.phong == b.phong &&
           a.phong_size == b.phong_size && a.specular == b.specular && a.roughness == b.roughness &&
           a.metallic == b.metallic && a.reflection_min == b.reflection_min && a.reflection_max == b.reflection_max &&
           a.reflection_falloff == b.reflection_falloff && a.reflection_exponent == b.reflection_exponent &&
           a.reflection_metallic == b.reflection_metallic && a.reflection_fresnel == b.reflection_fresnel &&
           a.conserve_energy == b.conserve_energy && a.crand == b.crand && a.irid == b.irid &&
           a.irid_thickness == b.irid_thickness && a.irid_turbulence == b.irid_turbulence &&
           a.translucency == b.translucency;
}

std::optional<scene::LayeredTexture> textures_by_shares(const std::vector<SharedTexture>& textures,
                                                        const SourceLocation& where) {
    scene::LayeredTexture result;
    for (const SharedTexture& part : textures) {
        if (!can_be_part(*part.texture)) return std::nullopt;
        std::vector<scene::TextureLayer> layers = part.texture->layers;
        const bool has_parts = layers.back().share != nullptr;
        for (scene::TextureLayer& layer : layers) {
            layer.first_part = layer.parts_end = false;
            if (has_parts ? !layer.share : &layer != &layers.back()) continue;
            auto share = std::make_shared<scene::Pigment>();
            share->where = where;
            share->kind = scene::Pigment::Kind::mapped;
            share->pattern.kind = scene::Pattern::Kind::share;
            share->pattern.share = part.share;
            share->entries = {{0, {0, 0, 0, 0, 0}, nullptr}, {1, {1, 1, 1, 0, 0}, layer.share}};
            layer.share = std::move(share);
        }
        for (scene::TextureLayer& layer : layers) result.layers.push_back(std::move(layer));
    }
    if (result.layers.empty() || result.layers.size() > kMostLayers) return std::nullopt;
    result.layers.front().parts_end = true;
    result.layers.back().first_part = true;
    return result;
}

}  // namespace sundog::pov
