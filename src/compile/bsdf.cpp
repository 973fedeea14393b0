// SPDX-License-Identifier: Apache-2.0
#include "compile/bsdf.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compile/convert.h"
#include "compile/material.h"

namespace sundog {
namespace {

using scene::PrincipledSurface;

constexpr Vec3 kWhite{1, 1, 1};

Vec3 clamp01(Vec3 c) { return min(max(c, {0, 0, 0}), kWhite); }
float clamp01(float x) { return std::clamp(x, 0.0F, 1.0F); }

/// A white dielectric without anything on it.
kernel::Bsdf plain() {
    kernel::Bsdf out{};
    out.kind = kernel::BSDF_PRINCIPLED;
    out.color = {1, 1, 1};
    out.alpha_x = out.alpha_y = 1;
    out.n = {1, 1, 1};
    out.ior = 1.5F;
    out.roughness = 1;
    out.specular = 1;
    out.specular_color = {1, 1, 1};
    out.film_ior = 1.3F;
    out.opacity = 1;
    out.maps = kernel::NONE;
    return out;
}

/// Light of `color` is left after `distance`: exp(-rate * distance) = color.
Vec3 attenuation_rate(Vec3 color, float distance) {
    if (!(distance > 0)) return {0, 0, 0};
    const auto rate = [&](float c) { return -std::log(std::clamp(c, 1e-4F, 1.0F)) / distance; };
    return {rate(color.x), rate(color.y), rate(color.z)};
}

/// What alpha leaves of a surface, apart from its map.
float opacity_of(const PrincipledSurface& s, bool tinted) {
    switch (s.alpha_mode) {
        case PrincipledSurface::Alpha::opaque:
            return 1;
        case PrincipledSurface::Alpha::mask:
            // With a map or colours of vertices, these are cut off where their product with alpha is.
            return tinted || s.base_color_map.texture != scene::kNone || s.alpha >= s.alpha_cutoff ? 1.0F : 0.0F;
        case PrincipledSurface::Alpha::blend:
            return clamp01(s.alpha);
    }
    return 1;
}

std::uint32_t kind_of(scene::ReflectionModel::Kind kind) {
    using Kind = scene::ReflectionModel::Kind;
    switch (kind) {
        case Kind::oren_nayar:
            return kernel::BSDF_OREN_NAYAR;
        case Kind::phong:
            return kernel::BSDF_PHONG;
        case Kind::blinn_phong:
            return kernel::BSDF_BLINN_PHONG;
        case Kind::ward:
            return kernel::BSDF_WARD;
        case Kind::cook_torrance:
            return kernel::BSDF_COOK_TORRANCE;
        case Kind::beckmann:
            return kernel::BSDF_BECKMANN;
        case Kind::ggx:
            return kernel::BSDF_CONDUCTOR;
        case Kind::glass:
            return kernel::BSDF_DIELECTRIC;
    }
    return kernel::BSDF_OREN_NAYAR;
}

/// Matt surfaces have the colour Kd, others Ks; metals and glass are white where that is black.
kernel::Bsdf named_model(const scene::MtlSurface& s) {
    using Kind = scene::ReflectionModel::Kind;
    const scene::ReflectionModel& model = *s.model;
    kernel::Bsdf out = plain();
    out.kind = kind_of(model.kind);
    out.alpha_x = model.first;
    out.alpha_y = model.second;
    out.n = to_kernel(model.n);
    out.k = to_kernel(model.k);
    if (s.ior > 1) out.ior = s.ior;
    const bool tints = model.kind >= Kind::cook_torrance;
    Vec3 color = model.kind == Kind::oren_nayar ? s.diffuse : s.specular;
    if (tints && color == Vec3{}) color = kWhite;
    out.color = to_kernel(clamp01(color));
    out.opacity = model.kind == Kind::glass ? 1 : clamp01(s.opacity);
    return out;
}

}  // namespace

std::optional<kernel::Bsdf> compile_bsdf(const PrincipledSurface& s, bool tinted) {
    if (s.unlit) return std::nullopt;
    kernel::Bsdf out = plain();
    out.color = to_kernel(clamp01(s.base_color));
    out.metallic = clamp01(s.metallic);
    out.roughness = clamp01(s.roughness);
    // An index of 0 stands for a dielectric that reflects all light.
    out.ior = s.ior > 0 ? std::max(s.ior, 1.0F) : 1e4F;
    out.specular = clamp01(s.specular);
    out.specular_color = to_kernel(max(s.specular_color, {0, 0, 0}));
    out.transmission = clamp01(s.transmission);
    out.thin = s.thickness > 0 ? 0 : 1;
    if (s.thickness > 0) out.attenuation = to_kernel(attenuation_rate(s.attenuation_color, s.attenuation_distance));
    out.coat = clamp01(s.clearcoat);
    out.coat_roughness = clamp01(s.clearcoat_roughness);
    out.sheen = to_kernel(clamp01(s.sheen_color));
    out.sheen_roughness = clamp01(s.sheen_roughness);
    out.film = clamp01(s.iridescence);
    out.film_ior = std::max(s.iridescence_ior, 1.0F);
    out.film_least_nm = std::max(s.iridescence_thickness_least_nm, 0.0F);
    out.film_most_nm = std::max(s.iridescence_thickness_most_nm, 0.0F);
    // Without a map of it the thickness is the most.
    if (s.iridescence_thickness_map.texture == scene::kNone) out.film_least_nm = out.film_most_nm;
    out.anisotropy = clamp01(s.anisotropy);
    out.anisotropy_rotation = s.anisotropy_rotation_rad;
    // A wall without thickness refracts nothing.
    out.dispersion = s.thickness > 0 ? std::max(s.dispersion, 0.0F) : 0;
    out.opacity = opacity_of(s, tinted);
    return out;
}

std::optional<kernel::Bsdf> compile_bsdf(const scene::MtlSurface& s) {
    if (s.model) return named_model(s);
    if (!s.roughness && !s.metallic && !s.clearcoat) return std::nullopt;
    kernel::Bsdf out = plain();
    out.color = to_kernel(clamp01(s.diffuse));
    out.metallic = clamp01(s.metallic.value_or(0));
    // As in compile/material.cpp: a highlight's exponent says how rough a surface is that doesn't.
    const float from_highlight = std::pow(2 / (std::max(s.shininess, 0.0F) + 2), 0.25F);
    out.roughness = clamp01(s.roughness.value_or(from_highlight));
    out.coat = clamp01(s.clearcoat.value_or(0));
    out.coat_roughness = 0.03F;
    if (s.ior > 1) out.ior = s.ior;
    out.opacity = clamp01(s.opacity);
    return out;
}

kernel::BsdfMaps compile_bsdf_maps(const kernel::MaterialMaps& maps) {
    kernel::BsdfMaps out{};
    for (kernel::TextureRef& ref : out.map) ref = no_maps().diffuse;
    out.map[kernel::BSDF_MAP_COLOR] = maps.diffuse;
    out.map[kernel::BSDF_MAP_OPACITY] = maps.opacity;
    return out;
}

kernel::BsdfMaps compile_bsdf_maps(const PrincipledSurface& s, std::span<const scene::Texture> textures,
                                   const kernel::MaterialMaps& material_maps) {
    kernel::BsdfMaps maps = compile_bsdf_maps(material_maps);
    const auto set = [&](std::uint32_t which, const scene::TextureUse& use) {
        maps.map[which] = compile_use(use, textures);
    };
    set(kernel::BSDF_MAP_METALLIC_ROUGHNESS, s.metallic_roughness_map);
    set(kernel::BSDF_MAP_SPECULAR, s.specular_map);
    set(kernel::BSDF_MAP_SPECULAR_COLOR, s.specular_color_map);
    set(kernel::BSDF_MAP_TRANSMISSION, s.transmission_map);
    set(kernel::BSDF_MAP_COAT, s.clearcoat_map);
    set(kernel::BSDF_MAP_COAT_ROUGHNESS, s.clearcoat_roughness_map);
    set(kernel::BSDF_MAP_SHEEN_COLOR, s.sheen_color_map);
    set(kernel::BSDF_MAP_SHEEN_ROUGHNESS, s.sheen_roughness_map);
    set(kernel::BSDF_MAP_FILM, s.iridescence_map);
    set(kernel::BSDF_MAP_FILM_THICKNESS, s.iridescence_thickness_map);
    set(kernel::BSDF_MAP_ANISOTROPY, s.anisotropy_map);
    set(kernel::BSDF_MAP_COAT_NORMAL, s.clearcoat_normal_map);
    maps.map[kernel::BSDF_MAP_COAT_NORMAL].flags |= kernel::TEXTURE_TURNS_OVER;
    return maps;
}

bool any_map(const kernel::BsdfMaps& maps) {
    return std::any_of(std::begin(maps.map), std::end(maps.map),
                       [](const kernel::TextureRef& ref) { return ref.texture != kernel::NONE; }) ||
           (maps.map[kernel::BSDF_MAP_OPACITY].flags & kernel::TEXTURE_CUTOFF) != 0;
}

}  // namespace sundog
