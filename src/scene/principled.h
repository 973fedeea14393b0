// SPDX-License-Identifier: Apache-2.0
// A physically based surface: glTF 2.0's metallic-roughness material with the extensions that Khronos has ratified,
// whose names, defaults and meanings these are.
#pragma once

#include <array>

#include "base/vec.h"
#include "scene/texture_use.h"

namespace sundog::scene {

/// Colours are linear RGB; maps multiply what they stand beside, in the channels that glTF gives them.
struct PrincipledSurface {
    enum class Alpha : std::uint8_t { opaque, mask, blend };

    Vec3 base_color{1, 1, 1};
    float alpha = 1;
    Alpha alpha_mode = Alpha::opaque;
    float alpha_cutoff = 0.5F;  ///< mask: what has less is not there.
    TextureUse base_color_map;  ///< RGB, and alpha.

    float metallic = 1, roughness = 1;
    TextureUse metallic_roughness_map;  ///< Roughness in green, metallic in blue.

    TextureUse normal_map;     ///< Tangent space; `strength` scales x and y.
    TextureUse occlusion_map;  ///< Of ambient light, in red; `strength` is its share. Path tracing finds its own.

    Vec3 emission{0, 0, 0};  ///< Radiance.
    TextureUse emission_map;

    bool double_sided = false;  ///< Else its back can't be seen, unless light passes through.
    bool unlit = false;         ///< KHR_materials_unlit: the base colour is its radiance.

    float ior = 1.5F;    ///< KHR_materials_ior
    float specular = 1;  ///< KHR_materials_specular
    Vec3 specular_color{1, 1, 1};
    TextureUse specular_map;        ///< In alpha.
    TextureUse specular_color_map;  ///< RGB

    float transmission = 0;       ///< KHR_materials_transmission
    TextureUse transmission_map;  ///< In red.

    float thickness = 0;             ///< KHR_materials_volume; 0: a thin wall, behind which nothing is refracted.
    TextureUse thickness_map;        ///< In green.
    float attenuation_distance = 0;  ///< Of light of attenuation_color; 0: no attenuation.
    Vec3 attenuation_color{1, 1, 1};
    float dispersion = 0;  ///< KHR_materials_dispersion: 20 over the Abbe number.

    float clearcoat = 0, clearcoat_roughness = 0;  ///< KHR_materials_clearcoat
    TextureUse clearcoat_map;                      ///< In red.
    TextureUse clearcoat_roughness_map;            ///< In green.
    TextureUse clearcoat_normal_map;

    Vec3 sheen_color{0, 0, 0};  ///< KHR_materials_sheen
    float sheen_roughness = 0;
    TextureUse sheen_color_map;      ///< RGB
    TextureUse sheen_roughness_map;  ///< In alpha.

    float iridescence = 0, iridescence_ior = 1.3F;  ///< KHR_materials_iridescence
    float iridescence_thickness_least_nm = 100, iridescence_thickness_most_nm = 400;
    TextureUse iridescence_map;            ///< In red.
    TextureUse iridescence_thickness_map;  ///< In green: 0 the least, 1 the most.

    float anisotropy = 0, anisotropy_rotation_rad = 0;  ///< KHR_materials_anisotropy
    TextureUse anisotropy_map;                          ///< Direction in red and green, strength in blue.
};

/// All maps of a surface.
template <class Surface>
auto maps_of(Surface& s) {
    return std::array{&s.base_color_map,
                      &s.metallic_roughness_map,
                      &s.normal_map,
                      &s.occlusion_map,
                      &s.emission_map,
                      &s.specular_map,
                      &s.specular_color_map,
                      &s.transmission_map,
                      &s.thickness_map,
                      &s.clearcoat_map,
                      &s.clearcoat_roughness_map,
                      &s.clearcoat_normal_map,
                      &s.sheen_color_map,
                      &s.sheen_roughness_map,
                      &s.iridescence_map,
                      &s.iridescence_thickness_map,
                      &s.anisotropy_map};
}

}  // namespace sundog::scene
