// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/materials.h"

#include <algorithm>

namespace sundog::import::gltf {

using scene::PrincipledSurface;

namespace {

/// The texture coordinates that the maps go by; from then on these are the first or the second ones. Most files have
/// one set, few two, and none more.
UvSets take_uv_sets(Asset& asset, const Json& material, PrincipledSurface& surface) {
    UvSets sets;
    bool any = false;
    for (scene::TextureUse* use : scene::maps_of(surface)) {
        if (use->texture == scene::kNone) continue;
        if (!any) sets.first = use->uv_set, any = true;
        const bool second = use->uv_set != sets.first;
        if (second && !sets.second) sets.second = use->uv_set;
        if (second && use->uv_set != *sets.second)
            asset.warn_once("three uv sets", material, "the maps go by three sets of texture coordinates; two are used",
                            "TEXCOORD_" + std::to_string(*sets.second) + " stands in for the others");
        use->uv_set = second ? 1 : 0;
    }
    return sets;
}

}  // namespace

scene::PrincipledSurface read_surface(const Json& material, TextureReader& textures) {
    PrincipledSurface surface;
    if (const Json pbr = material.member("pbrMetallicRoughness")) {
        if (const Json color = pbr.member("baseColorFactor")) {
            const std::vector<float> c = color.numbers(4);
            surface.base_color = max(Vec3{c[0], c[1], c[2]}, {0, 0, 0});
            surface.alpha = std::clamp(c[3], 0.0F, 1.0F);
        }
        surface.base_color_map = textures.read(pbr.member("baseColorTexture"), TextureMeaning::color);
        surface.metallic = pbr.share_or("metallicFactor", 1);
        surface.roughness = pbr.share_or("roughnessFactor", 1);
        surface.metallic_roughness_map = textures.read(pbr.member("metallicRoughnessTexture"), TextureMeaning::data);
    }
    const Json normal = material.member("normalTexture");
    surface.normal_map = textures.read(normal, TextureMeaning::data);
    if (normal) surface.normal_map.strength = normal.number_or("scale", 1);
    const Json occlusion = material.member("occlusionTexture");
    surface.occlusion_map = textures.read(occlusion, TextureMeaning::data);
    if (occlusion) surface.occlusion_map.strength = occlusion.share_or("strength", 1);
    surface.emission = max(material.vec3_or("emissiveFactor", {0, 0, 0}), {0, 0, 0});
    surface.emission_map = textures.read(material.member("emissiveTexture"), TextureMeaning::color);
    surface.double_sided = material.boolean_or("doubleSided", false);
    if (const Json mode = material.member("alphaMode")) {
        const std::string_view name = mode.string();
        if (name == "MASK") surface.alpha_mode = PrincipledSurface::Alpha::mask;
        else if (name == "BLEND") surface.alpha_mode = PrincipledSurface::Alpha::blend;
        else if (name != "OPAQUE") mode.fail("unknown mode " + in_quotes(name), "expected one of: OPAQUE, MASK, BLEND");
    }
    surface.alpha_cutoff = std::max(material.number_or("alphaCutoff", 0.5F), 0.0F);
    return surface;
}

std::vector<UvSets> read_materials(Asset& asset) {
    TextureReader textures(asset);
    std::vector<UvSets> uv_sets;
    const Json list = asset.list("materials");
    const std::vector<SourceLocation> places = list.element_locations();
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Json json = list[i];
        scene::Material material;
        material.name = json.string_or("name", "materials[" + std::to_string(i) + "]");
        material.where = places[i];
        scene::PrincipledSurface surface = read_surface(json, textures);
        read_extensions(json, textures, surface);
        uv_sets.push_back(take_uv_sets(asset, json, surface));
        material.principled = std::move(surface);
        asset.scene().materials.push_back(std::move(material));
    }
    return uv_sets;
}

}  // namespace sundog::import::gltf
