// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_texture_map.h"

#include <algorithm>

#include "import/pov/build_normal.h"
#include "import/pov/build_pattern.h"
#include "import/pov/build_pigment.h"

namespace sundog::pov {
namespace {

using scene::Finish;

bool same(const Finish& a, const Finish& b) {
    return a.ambient == b.ambient && a.emission == b.emission && a.diffuse == b.diffuse &&
           a.diffuse_back == b.diffuse_back && a.brilliance == b.brilliance && a.phong == b.phong &&
           a.phong_size == b.phong_size && a.specular == b.specular && a.roughness == b.roughness &&
           a.metallic == b.metallic && a.reflection_min == b.reflection_min && a.reflection_max == b.reflection_max &&
           a.reflection_falloff == b.reflection_falloff && a.reflection_exponent == b.reflection_exponent &&
           a.reflection_metallic == b.reflection_metallic && a.reflection_fresnel == b.reflection_fresnel &&
           a.conserve_energy == b.conserve_energy;
}

Finish mean(const std::vector<Finish>& finishes) {
    Finish result = finishes.front();
    const float share = 1 / static_cast<float>(finishes.size());
    const auto average = [&](auto member) {
        auto sum = finishes.front().*member * 0.0F;
        for (const Finish& f : finishes) sum = sum + f.*member * share;
        result.*member = sum;
    };
    for (const auto member : {&Finish::ambient, &Finish::emission, &Finish::reflection_min, &Finish::reflection_max})
        average(member);
    for (const auto member : {&Finish::diffuse, &Finish::diffuse_back, &Finish::brilliance, &Finish::phong,
                              &Finish::phong_size, &Finish::specular, &Finish::roughness, &Finish::metallic,
                              &Finish::reflection_falloff, &Finish::reflection_exponent, &Finish::reflection_metallic})
        average(member);
    return result;
}

std::shared_ptr<const scene::Pigment> clear_pigment() {
    scene::Pigment clear;
    clear.color = {1, 1, 1, 0, 1};
    return std::make_shared<const scene::Pigment>(clear);
}

}  // namespace

scene::LayeredTexture blend_textures(BuildContext& context, Place where, const scene::Pattern& pattern,
                                     const std::vector<TextureEntry>& entries) {
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
        sort_entries(pigment->entries);
        const bool equal =
            std::all_of(finishes.begin(), finishes.end(), [&](const Finish& f) { return same(f, finishes.front()); });
        if (!equal)
            context.warn_once("texture_map finishes", where, "the finishes of a texture's parts are averaged",
                              "pigments are drawn as written");
        result.layers.push_back({std::move(pigment), equal ? finishes.front() : mean(finishes),
                                 blend_normals(pattern, std::move(normals))});
    }
    return result;
}

}  // namespace sundog::pov
