// SPDX-License-Identifier: Apache-2.0
// What shaders know of the fields and warps that they compute for themselves (kernel/patterns/shader_fields.h and
// shader_warps.h) where the CPU asks a HostField.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/pattern.h"

namespace sundog::fields {

struct ShaderField {
    std::uint32_t kind = 0;  ///< FIELD_*
    std::vector<std::uint32_t> words;
    std::uint32_t fields = 0;  ///< All FIELD_* that it needs, as bits.
};
/// Of a pattern that is a field of the host's; nothing where the host alone computes it.
std::optional<ShaderField> shader_field(const scene::Pattern& pattern);

/// A density file's voxels, two a word, from 0 to 65535.
std::vector<std::uint32_t> voxel_words(const scene::DensityGrid& grid);

struct ShaderWarp {
    std::uint32_t op = 0;  ///< OP_REPEAT, OP_BLACK_HOLE or OP_MAPPING.
    std::vector<std::uint32_t> words;
};
/// Of any warp but turbulence.
ShaderWarp shader_warp(const scene::Warp& warp);

}  // namespace sundog::fields
