// SPDX-License-Identifier: Apache-2.0
// How an MTL surface becomes the kernel's lobes. The illumination models are those of the MTL appendix of the
// Wavefront Advanced Visualizer manual (1995); the PBR keys those of Clara.io's extension.
//
// illum       highlight   mirror (weight Ks)        passes through
// 0           no          no                        1-d, straight; the colour is constant (Kd + Ke)
// 1           no          no                        1-d, straight
// 2, 10       Ks, Ns      no                        1-d, straight
// 3, 8        Ks, Ns      yes                       1-d, straight
// 5           Ks, Ns      yes, Fresnel (Schlick)    1-d, straight
// 4           Ks, Ns      yes                       Tf*(1-d), refracted by Ni
// 6           Ks, Ns      yes                       Tf*(1-d), refracted by Ni
// 7           Ks, Ns      yes, Fresnel              Tf*(1-d), refracted by Ni
// 9           Ks, Ns      no                        Tf*(1-d), refracted by Ni
//
// Two habits of real files are met halfway. Glass written with d 1: models 6 and 7 then let Tf pass if Ni is not 1
// or Tf is not white (the manual's formulas for them don't speak of d), models 4 and 9 only if Tf is not white
// (Maya writes "illum 4, Tf 1 1 1" for every opaque surface). And Ks 1 on glass: what passes through has precedence,
// the mirror gets at most what it leaves (with Fresnel both may be 1, F and 1-F share them out).
//
// Pr, Pm, Pc (any of them given; Pr follows from Ns where absent, so that the highlights agree): the part Pm is
// metal, which has no diffuse colour and mirrors Kd*(1-Pr)^2; the rest is a dielectric of 4% reflectance. Surfaces
// smoother than Pr 0.3 mirror with Schlick's Fresnel term, rougher dielectrics only have a highlight, of
// Ns = 2/max(Pr^4, 1e-4) - 2. Pc adds a mirror of 4%*Pc, with Schlick's term from Pc 0.5 on.
#pragma once

#include <span>

#include "kernel/shared.h"
#include "scene/scene.h"

namespace sundog {

/// Of the illumination models above: those that refract what passes, and those that mirror.
bool mtl_refracts(int illum);
bool mtl_mirrors(int illum);
/// How much light passes through a surface, before any Fresnel share; 0 for opaque ones.
Vec3 mtl_transmittance(const scene::MtlSurface& m);

/// The maps of a material without textures.
kernel::MaterialMaps no_maps();
bool any_map(const kernel::MaterialMaps& maps);

/// The kernel's form of a texture's use; those of textures without pixels are dropped.
kernel::TextureRef compile_use(const scene::TextureUse& use, std::span<const scene::Texture> textures);

/// The textures of `material`. They keep their index into Scene::textures; those of textures without pixels are
/// dropped.
kernel::MaterialMaps compile_maps(const scene::MtlSurface& material, std::span<const scene::Texture> textures);

/// The kernel's material of `material`, whose compile_maps() are `maps`; where they stand is left to the caller.
kernel::Material compile_material(const scene::MtlSurface& material, const kernel::MaterialMaps& maps);

/// FEATURE_* bits that a surface of this material with these maps needs.
std::uint32_t material_features(const kernel::Material& material, const kernel::MaterialMaps& maps);

}  // namespace sundog
