// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "import/gltf/materials.h"

namespace sundog::import::gltf {
namespace {

constexpr float kMost = std::numeric_limits<float>::max();

Vec3 color_or(const Json& json, const char* name, Vec3 otherwise) {
    return max(json.vec3_or(name, otherwise), {0, 0, 0});
}

void read_clearcoat(const Json& json, TextureReader& textures, scene::PrincipledSurface& s) {
    s.clearcoat = json.share_or("clearcoatFactor", 0);
    s.clearcoat_map = textures.read(json.member("clearcoatTexture"), TextureMeaning::data);
    s.clearcoat_roughness = json.share_or("clearcoatRoughnessFactor", 0);
    s.clearcoat_roughness_map = textures.read(json.member("clearcoatRoughnessTexture"), TextureMeaning::data);
    const Json normal = json.member("clearcoatNormalTexture");
    s.clearcoat_normal_map = textures.read(normal, TextureMeaning::data);
    if (normal) s.clearcoat_normal_map.strength = normal.number_or("scale", 1);
}

void read_volume(const Json& json, TextureReader& textures, scene::PrincipledSurface& s) {
    s.thickness = json.share_or("thicknessFactor", 0, 0, kMost);
    s.thickness_map = textures.read(json.member("thicknessTexture"), TextureMeaning::data);
    s.attenuation_distance = json.share_or("attenuationDistance", 0, 0, kMost);
    s.attenuation_color = min(color_or(json, "attenuationColor", {1, 1, 1}), {1, 1, 1});
}

void read_iridescence(const Json& json, TextureReader& textures, scene::PrincipledSurface& s) {
    s.iridescence = json.share_or("iridescenceFactor", 0);
    s.iridescence_map = textures.read(json.member("iridescenceTexture"), TextureMeaning::data);
    s.iridescence_ior = json.share_or("iridescenceIor", 1.3F, 1, kMost);
    s.iridescence_thickness_least_nm = json.share_or("iridescenceThicknessMinimum", 100, 0, kMost);
    s.iridescence_thickness_most_nm = json.share_or("iridescenceThicknessMaximum", 400, 0, kMost);
    s.iridescence_thickness_map = textures.read(json.member("iridescenceThicknessTexture"), TextureMeaning::data);
}

void read_sheen(const Json& json, TextureReader& textures, scene::PrincipledSurface& s) {
    s.sheen_color = color_or(json, "sheenColorFactor", {0, 0, 0});
    s.sheen_color_map = textures.read(json.member("sheenColorTexture"), TextureMeaning::color);
    s.sheen_roughness = json.share_or("sheenRoughnessFactor", 0);
    s.sheen_roughness_map = textures.read(json.member("sheenRoughnessTexture"), TextureMeaning::data);
}

void read_specular(const Json& json, TextureReader& textures, scene::PrincipledSurface& s) {
    s.specular = json.share_or("specularFactor", 1);
    s.specular_map = textures.read(json.member("specularTexture"), TextureMeaning::data);
    s.specular_map.channel = 3;
    s.specular_color = color_or(json, "specularColorFactor", {1, 1, 1});
    s.specular_color_map = textures.read(json.member("specularColorTexture"), TextureMeaning::color);
}

}  // namespace

void read_extensions(const Json& material, TextureReader& textures, scene::PrincipledSurface& s) {
    if (const Json json = material.extension("KHR_materials_anisotropy")) {
        s.anisotropy = json.share_or("anisotropyStrength", 0);
        s.anisotropy_rotation_rad = json.number_or("anisotropyRotation", 0);
        s.anisotropy_map = textures.read(json.member("anisotropyTexture"), TextureMeaning::data);
    }
    if (const Json json = material.extension("KHR_materials_clearcoat")) read_clearcoat(json, textures, s);
    if (const Json json = material.extension("KHR_materials_dispersion"))
        s.dispersion = json.share_or("dispersion", 0, 0, kMost);
    if (const Json json = material.extension("KHR_materials_emissive_strength"))
        s.emission *= json.share_or("emissiveStrength", 1, 0, kMost);
    if (const Json json = material.extension("KHR_materials_ior")) {
        const float ior = json.number_or("ior", 1.5F);
        if (ior != 0 && ior < 1) json.required("ior").fail("expected 0, or 1 and more");
        s.ior = ior;
    }
    if (const Json json = material.extension("KHR_materials_iridescence")) read_iridescence(json, textures, s);
    if (const Json json = material.extension("KHR_materials_sheen")) read_sheen(json, textures, s);
    if (const Json json = material.extension("KHR_materials_specular")) read_specular(json, textures, s);
    if (const Json json = material.extension("KHR_materials_transmission")) {
        s.transmission = json.share_or("transmissionFactor", 0);
        s.transmission_map = textures.read(json.member("transmissionTexture"), TextureMeaning::data);
    }
    if (material.extension("KHR_materials_unlit")) s.unlit = true;
    if (const Json json = material.extension("KHR_materials_volume")) read_volume(json, textures, s);
}

}  // namespace sundog::import::gltf
