// SPDX-License-Identifier: Apache-2.0
#include "compile/material.h"

#include <algorithm>
#include <cmath>

#include "compile/convert.h"

namespace sundog {
namespace {

constexpr Vec3 kWhite{1, 1, 1};
constexpr float kDielectricReflectance = 0.04F;  // At normal incidence, of an index of refraction of 1.5.
constexpr float kSmoothest = 0.3F;               // Rougher dielectrics show no mirror image.

bool black(Vec3 c) { return !(c.x > 0 || c.y > 0 || c.z > 0); }
bool black(const kernel::vec3& c) { return !(c.x > 0 || c.y > 0 || c.z > 0); }
Vec3 clamp01(Vec3 c) { return min(max(c, {0, 0, 0}), kWhite); }

std::uint32_t wrap_flags(const scene::TextureUse& use) {
    using Wrap = scene::TextureUse::Wrap;
    if (use.wrap_u == Wrap::clamp && use.wrap_v == Wrap::clamp) return kernel::TEXTURE_CLAMP;
    return (use.wrap_u == Wrap::clamp ? kernel::TEXTURE_CLAMP_U : 0U) |
           (use.wrap_v == Wrap::clamp ? kernel::TEXTURE_CLAMP_V : 0U) |
           (use.wrap_u == Wrap::mirror ? kernel::TEXTURE_MIRROR_U : 0U) |
           (use.wrap_v == Wrap::mirror ? kernel::TEXTURE_MIRROR_V : 0U);
}

bool fresnel(int illum) { return illum == 5 || illum == 7; }

/// Mirror, diffuse and highlight of an opaque surface with the PBR extension's keys.
void set_pbr(const scene::MtlSurface& m, kernel::Material& out) {
    const float from_highlight = std::pow(2 / (std::max(m.shininess, 0.0F) + 2), 0.25F);
    const float roughness = std::clamp(m.roughness.value_or(from_highlight), 0.0F, 1.0F);
    const float metallic = std::clamp(m.metallic.value_or(0), 0.0F, 1.0F);
    const float clearcoat = std::clamp(m.clearcoat.value_or(0), 0.0F, 1.0F);
    const bool smooth = roughness < kSmoothest;

    const Vec3 color = clamp01(m.diffuse);
    const float gloss = (1 - roughness) * (1 - roughness);
    Vec3 reflectance = color * (metallic * gloss);
    if (smooth) reflectance += kWhite * ((1 - metallic) * kDielectricReflectance * gloss);
    reflectance += kWhite * (kDielectricReflectance * clearcoat);
    out.reflectance = to_kernel(clamp01(reflectance));
    if (smooth || clearcoat >= 0.5F) out.flags |= kernel::MATERIAL_FRESNEL;

    out.diffuse = to_kernel(m.diffuse * (1 - metallic));
    out.ambient = to_kernel(m.ambient.value_or(m.diffuse) * (1 - metallic));
    out.specular = to_kernel(color * metallic + m.specular * (1 - metallic));
    const float roughness4 = roughness * roughness * roughness * roughness;
    out.shininess = 2 / std::max(roughness4, 1e-4F) - 2;
}

}  // namespace

bool mtl_refracts(int illum) { return illum == 4 || illum == 6 || illum == 7 || illum == 9; }
bool mtl_mirrors(int illum) { return illum >= 3 && illum <= 8; }

Vec3 mtl_transmittance(const scene::MtlSurface& m) {
    const float passes = std::clamp(1 - m.opacity, 0.0F, 1.0F);
    if (!mtl_refracts(m.illum)) return kWhite * passes;
    const Vec3 filter = clamp01(m.transmission_filter);
    if (passes > 0) return filter * passes;
    const bool tinted = !(filter == kWhite);
    const bool glass_with_d_1 = tinted || ((m.illum == 6 || m.illum == 7) && m.ior != 1);
    return glass_with_d_1 ? filter : Vec3{};
}

kernel::TextureRef compile_use(const scene::TextureUse& use, std::span<const scene::Texture> textures) {
    kernel::TextureRef ref{};
    ref.texture = use.texture < textures.size() && !textures[use.texture].rgba8.empty() ? use.texture : kernel::NONE;
    ref.flags = wrap_flags(use) | (std::uint32_t{use.channel} << kernel::TEXTURE_CHANNEL_SHIFT) |
                (use.nearest ? kernel::TEXTURE_NEAREST : 0U) | (use.uv_set > 0 ? kernel::TEXTURE_SECOND_UV : 0U);
    ref.scale = to_kernel(use.scale);
    if (!(use.shear == Vec2{})) ref.flags |= kernel::TEXTURE_TURNED;
    ref.shear = to_kernel(use.shear);
    ref.offset = to_kernel(use.offset);
    ref.strength = use.strength;
    return ref;
}

kernel::MaterialMaps no_maps() {
    kernel::MaterialMaps maps{};
    for (kernel::TextureRef* map :
         {&maps.diffuse, &maps.specular, &maps.emission, &maps.opacity, &maps.bump, &maps.normal, &maps.occlusion})
        map->texture = kernel::NONE;
    return maps;
}

bool any_map(const kernel::MaterialMaps& maps) {
    return std::min({maps.diffuse.texture, maps.specular.texture, maps.emission.texture, maps.opacity.texture,
                     maps.bump.texture, maps.normal.texture, maps.occlusion.texture}) != kernel::NONE ||
           (maps.opacity.flags & kernel::TEXTURE_CUTOFF) != 0;
}

kernel::MaterialMaps compile_maps(const scene::MtlSurface& m, std::span<const scene::Texture> textures) {
    kernel::MaterialMaps maps = no_maps();
    maps.diffuse = compile_use(m.map_diffuse, textures);
    maps.specular = compile_use(m.map_specular, textures);
    maps.emission = compile_use(m.map_emission, textures);
    maps.opacity = compile_use(m.map_opacity, textures);
    maps.bump = compile_use(m.map_bump, textures);
    maps.normal = compile_use(m.map_normal, textures);
    // A constant colour (illum 0) is emitted, so its picture is too.
    if (m.illum == 0 && maps.emission.texture == kernel::NONE) maps.emission = maps.diffuse;
    return maps;
}

kernel::Material compile_material(const scene::MtlSurface& m, const kernel::MaterialMaps& maps) {
    kernel::Material out{};
    out.emission = to_kernel(m.emission);
    out.ambient = to_kernel(m.ambient.value_or(m.diffuse));
    out.diffuse = to_kernel(m.diffuse);
    out.specular = to_kernel(m.specular);
    out.shininess = m.shininess;
    out.flags = m.phong_highlight ? kernel::MATERIAL_PHONG : 0;

    const Vec3 transmittance = mtl_transmittance(m);
    const bool transparent = !black(transmittance);
    out.transmittance = to_kernel(transmittance);
    out.ior = transparent && mtl_refracts(m.illum) && m.ior > 0 ? m.ior : 1;

    if (m.illum == 0) {
        out.emission = to_kernel(m.emission + m.diffuse);
        out.ambient = out.diffuse = {0, 0, 0};
    } else if (!transparent && (m.roughness || m.metallic || m.clearcoat)) {
        set_pbr(m, out);
    } else if (mtl_mirrors(m.illum) && !black(m.specular)) {
        if (fresnel(m.illum)) out.flags |= kernel::MATERIAL_FRESNEL;
        const bool shared_by_fresnel = transparent && m.illum == 7;
        const Vec3 most = shared_by_fresnel ? kWhite : kWhite - transmittance;
        out.reflectance = to_kernel(min(clamp01(m.specular), most));
    } else if (transparent && m.illum == 7) {
        out.flags |= kernel::MATERIAL_FRESNEL;
    }
    if (m.illum >= 2 && !black(out.specular) && out.shininess > 0) out.flags |= kernel::MATERIAL_HIGHLIGHT;
    if (any_map(maps)) out.flags |= kernel::MATERIAL_TEXTURED;
    if (m.checker) {
        out.flags |= kernel::MATERIAL_CHECKER | kernel::MATERIAL_TEXTURED;
        out.checker_other = to_kernel(m.checker->other);
        out.checker_cells = {m.checker->cells_u, m.checker->cells_v};
    }
    if (transparent || maps.opacity.texture != kernel::NONE) out.flags |= kernel::MATERIAL_TRANSPARENT;
    return out;
}

std::uint32_t material_features(const kernel::Material& m, const kernel::MaterialMaps& maps) {
    std::uint32_t features = 0;
    if (m.flags & kernel::MATERIAL_TEXTURED) features |= kernel::FEATURE_TEXTURES;
    if (m.flags & kernel::MATERIAL_HIGHLIGHT) features |= kernel::FEATURE_HIGHLIGHTS;
    if (!black(m.reflectance)) features |= kernel::FEATURE_MIRRORS;
    const bool fades = maps.opacity.texture != kernel::NONE || (m.flags & kernel::MATERIAL_VERTEX_ALPHA) != 0;
    if (!black(m.transmittance) || fades) features |= kernel::FEATURE_TRANSPARENT;
    if (maps.bump.texture != kernel::NONE || maps.normal.texture != kernel::NONE) features |= kernel::FEATURE_BUMP;
    return features;
}

}  // namespace sundog
