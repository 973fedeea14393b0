// SPDX-License-Identifier: Apache-2.0
// How a physically based surface becomes the lobes of Whitted tracing, which has mirrors, matt surfaces and highlights,
// but nothing blurred between them.
//
// Smoothness, (1 - roughness)^2, is the share of what a surface reflects that is seen as a mirror image: all of it for
// a metal, and for a dielectric, whose reflection is weak, only up to roughness 0.3. What a metal doesn't mirror it
// scatters like a matt surface in its colour. Highlights are Blinn's, of 2/max(roughness^4, 1e-4) - 2. Metalness and
// roughness from a map are the map's means. Clearcoat is one more dielectric mirror. What is transmitted goes through
// clearly: refracted where there is a volume, whose attenuation over its thickness colours it; else straight on.
// `mask` cuts at the map's alpha; `blend` lets light pass straight through by it. An unlit surface emits its colour.
// Colours of vertices multiply what the base colour does; occlusion dims ambient light. Sheen, iridescence, anisotropy
// and dispersion don't show.
#pragma once

#include <span>

#include "kernel/shared.h"
#include "scene/scene.h"

namespace sundog {

/// The textures of `surface`. `tinted`: some of its vertices have colours.
kernel::MaterialMaps compile_maps(const scene::PrincipledSurface& surface, std::span<const scene::Texture> textures,
                                  bool tinted = false);

/// The kernel's material of `surface`, whose compile_maps() are `maps`; where they stand is left to the caller.
kernel::Material compile_material(const scene::PrincipledSurface& surface, const kernel::MaterialMaps& maps,
                                  std::span<const scene::Texture> textures, bool tinted = false);

}  // namespace sundog
