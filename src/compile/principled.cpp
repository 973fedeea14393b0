// SPDX-License-Identifier: Apache-2.0
#include "compile/principled.h"

#include <algorithm>
#include <cmath>

#include "compile/convert.h"
#include "compile/material.h"

namespace sundog {
namespace {

using scene::PrincipledSurface;

constexpr Vec3 kWhite{1, 1, 1};
constexpr float kSmoothest = 0.3F;  // Rougher dielectrics show no mirror image.
constexpr std::uint8_t kAlphaChannel = 3;

Vec3 clamp01(Vec3 c) { return min(max(c, {0, 0, 0}), kWhite); }

/// A map's mean in one channel, 0 to 1; 1 without a map.
float mean_of(const scene::TextureUse& use, unsigned channel, std::span<const scene::Texture> textures) {
    if (use.texture >= textures.size() || textures[use.texture].rgba8.empty()) return 1;
    double sum = 0;
    for (const std::uint32_t texel : textures[use.texture].rgba8) sum += (texel >> (8 * channel)) & 255U;
    return static_cast<float>(sum / 255 / static_cast<double>(textures[use.texture].rgba8.size()));
}

/// The share of light that passes, apart from Fresnel's, before the alpha map.
Vec3 transmittance_of(const PrincipledSurface& s, float metallic, float transmission) {
    Vec3 filter = s.base_color;
    if (s.thickness > 0 && s.attenuation_distance > 0) {
        // Light passes two surfaces on its way through: each takes half.
        const float depth = s.thickness / s.attenuation_distance / 2;
        for (std::size_t i = 0; i < 3; ++i) filter[i] *= std::pow(s.attenuation_color[i], depth);
    }
    return clamp01(filter) * (transmission * (1 - metallic));
}

float shininess_of(float roughness) {
    const float roughness2 = roughness * roughness;
    return 2 / std::max(roughness2 * roughness2, 1e-4F) - 2;
}

/// A matt colour that is `color` once what is mirrored or passes has been taken from it: the kernel thins matt light by
/// that (docs/conventions.md, "Whitted's sum"), channel by channel, which would leave the complementary colour.
Vec3 unthinned(Vec3 color, Vec3 taken) {
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = color[i] / std::max(1 - taken[i], 0.05F);
    return out;
}

/// Mirror, matt and highlight of a surface.
void set_reflection(const PrincipledSurface& s, float metallic, float roughness, kernel::Material& out) {
    const float root = (s.ior - 1) / (s.ior + 1);
    // An ior of 0 stands for a dielectric that reflects all.
    const float at_normal = s.ior > 0 ? root * root : 1;
    const Vec3 dielectric = clamp01(s.specular_color * at_normal) * s.specular;
    const Vec3 color = clamp01(s.base_color);
    const float gloss = (1 - roughness) * (1 - roughness);
    const bool smooth = roughness < kSmoothest;
    const float coat_gloss = (1 - s.clearcoat_roughness) * (1 - s.clearcoat_roughness);
    Vec3 reflectance = color * (metallic * gloss);
    if (smooth) reflectance += dielectric * ((1 - metallic) * gloss);
    reflectance += kWhite * (0.04F * s.clearcoat * coat_gloss);
    reflectance = clamp01(reflectance);
    out.reflectance = to_kernel(reflectance);
    if (smooth || s.clearcoat >= 0.5F) out.flags |= kernel::MATERIAL_FRESNEL;
    out.diffuse = out.ambient = to_kernel(unthinned(s.base_color * (1 - metallic * gloss), reflectance));
    const float sharpest = s.clearcoat > 0 ? std::min(roughness, s.clearcoat_roughness) : roughness;
    out.shininess = shininess_of(sharpest);
    // As bright as a lobe of that width has to be to hold what is reflected (Blinn's, normalised), but never brighter
    // than the light. What is rough enough has its highlight in its matt part.
    const float peak = (1 - sharpest) * (out.shininess + 8) / 8;
    const Vec3 coat = kWhite * (0.04F * s.clearcoat);
    out.specular = to_kernel(clamp01((color * metallic + dielectric * (1 - metallic) + coat) * peak));
}

/// The alpha of `mask` and `blend`.
void set_alpha(const PrincipledSurface& s, bool varies, kernel::Material& out) {
    const bool mask = s.alpha_mode == PrincipledSurface::Alpha::mask;
    if (s.alpha_mode == PrincipledSurface::Alpha::opaque || (mask && (varies || s.alpha >= s.alpha_cutoff))) return;
    const float alpha = mask ? 0 : s.alpha;
    const Vec3 passes{out.transmittance.x, out.transmittance.y, out.transmittance.z};
    out.transmittance = to_kernel(kWhite - (kWhite - passes) * alpha);
    for (kernel::vec3* part : {&out.reflectance, &out.specular})
        *part = {part->x * alpha, part->y * alpha, part->z * alpha};
}

/// What colours of vertices multiply beside the matt part.
std::uint32_t tint_flags(const PrincipledSurface& s, float metallic) {
    std::uint32_t flags = kernel::MATERIAL_TEXTURED;
    if (s.alpha_mode != PrincipledSurface::Alpha::opaque) flags |= kernel::MATERIAL_VERTEX_ALPHA;
    else flags |= kernel::MATERIAL_VERTEX_PASSES;
    if (s.unlit) flags |= kernel::MATERIAL_VERTEX_EMISSION;
    // A metal's colour is that of its reflection.
    else if (metallic > 0.5F) flags |= kernel::MATERIAL_VERTEX_SPECULAR;
    return flags;
}

}  // namespace

kernel::MaterialMaps compile_maps(const PrincipledSurface& s, std::span<const scene::Texture> textures, bool tinted) {
    kernel::MaterialMaps maps = no_maps();
    const float metallic = s.metallic * mean_of(s.metallic_roughness_map, 2, textures);
    maps.diffuse = compile_use(s.base_color_map, textures);
    // A metal's colour is that of its reflection.
    if (metallic > 0.5F) maps.specular = maps.diffuse;
    maps.emission = compile_use(s.unlit ? s.base_color_map : s.emission_map, textures);
    if (!s.unlit) {
        maps.normal = compile_use(s.normal_map, textures);
        maps.normal.flags |= kernel::TEXTURE_TURNS_OVER;
        maps.occlusion = compile_use(s.occlusion_map, textures);
    }
    if (s.alpha_mode != PrincipledSurface::Alpha::opaque) {
        scene::TextureUse alpha = s.base_color_map;
        alpha.channel = kAlphaChannel;
        maps.opacity = compile_use(alpha, textures);
        const bool varies = tinted || maps.opacity.texture != kernel::NONE;
        if (varies && s.alpha_mode == PrincipledSurface::Alpha::mask) {
            maps.opacity.flags |= kernel::TEXTURE_CUTOFF;
            maps.opacity.strength = s.alpha > 0 ? s.alpha_cutoff / s.alpha : 2;
        }
    }
    return maps;
}

kernel::Material compile_material(const PrincipledSurface& s, const kernel::MaterialMaps& maps,
                                  std::span<const scene::Texture> textures, bool tinted) {
    kernel::Material out{};
    out.ior = 1;
    const float metallic = std::clamp(s.metallic * mean_of(s.metallic_roughness_map, 2, textures), 0.0F, 1.0F);
    if (s.unlit) {
        out.emission = to_kernel(s.base_color);
    } else {
        const float roughness = std::clamp(s.roughness * mean_of(s.metallic_roughness_map, 1, textures), 0.0F, 1.0F);
        const float transmission = s.transmission * mean_of(s.transmission_map, 0, textures);
        set_reflection(s, metallic, roughness, out);
        out.emission = to_kernel(s.emission);
        const Vec3 passes = transmittance_of(s, metallic, transmission);
        if (passes.x > 0 || passes.y > 0 || passes.z > 0) {
            // With Fresnel, what is not refracted is reflected; a thin wall reflects at both of its sides.
            const bool refracts = s.thickness > 0 && s.ior > 0 && s.ior != 1;
            const float root = (s.ior - 1) / (s.ior + 1);
            const float both_sides = 2 * root * root / (1 + root * root);
            out.flags = refracts ? out.flags | kernel::MATERIAL_FRESNEL : out.flags & ~kernel::MATERIAL_FRESNEL;
            out.ior = refracts ? s.ior : 1;
            out.transmittance = to_kernel(refracts ? passes : passes * (1 - both_sides));
            const float mirrored = refracts ? 1 : both_sides;
            out.reflectance = {mirrored, mirrored, mirrored};
            const Vec3 matt = s.base_color * ((1 - transmission) * (1 - metallic));
            out.diffuse = out.ambient = to_kernel(unthinned(matt, passes));
        }
    }
    const bool varies = maps.opacity.texture != kernel::NONE || tinted;
    set_alpha(s, varies, out);
    const auto black = [](const kernel::vec3& c) { return !(c.x > 0 || c.y > 0 || c.z > 0); };
    if (!black(out.specular) && out.shininess > 0) out.flags |= kernel::MATERIAL_HIGHLIGHT;
    if (any_map(maps)) out.flags |= kernel::MATERIAL_TEXTURED;
    if (tinted) out.flags |= tint_flags(s, metallic);
    const bool fades = s.alpha_mode != PrincipledSurface::Alpha::opaque && varies;
    if (!black(out.transmittance) || fades) out.flags |= kernel::MATERIAL_TRANSPARENT;
    // What light goes through is seen from inside, too.
    if (!s.double_sided && !(s.transmission > 0)) out.flags |= kernel::MATERIAL_ONE_SIDED;
    return out;
}

}  // namespace sundog
