// SPDX-License-Identifier: Apache-2.0
// The reflection models by which paths scatter at materials (kernel/bsdf).
#pragma once

#include <optional>
#include <span>

#include "kernel/shared.h"
#include "scene/scene.h"

namespace sundog {

/// The model of a physically based surface; none for unlit ones. Its `maps` are left to the caller. `tinted`: some of
/// its vertices have colours.
std::optional<kernel::Bsdf> compile_bsdf(const scene::PrincipledSurface& surface, bool tinted);

/// The model of a surface from an MTL file: one that it names, or by the PBR extension's keys; none where it has
/// neither.
std::optional<kernel::Bsdf> compile_bsdf(const scene::MtlSurface& surface);

/// The maps that compile_bsdf() leaves out, and whether there are any; `maps` are the material's own.
kernel::BsdfMaps compile_bsdf_maps(const scene::PrincipledSurface& surface, std::span<const scene::Texture> textures,
                                   const kernel::MaterialMaps& maps);
/// Likewise of a surface from an MTL file, which has no others.
kernel::BsdfMaps compile_bsdf_maps(const kernel::MaterialMaps& maps);
bool any_map(const kernel::BsdfMaps& maps);

}  // namespace sundog
