// SPDX-License-Identifier: Apache-2.0
// How materials use textures.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace sundog::scene {

/// Index into one of the Scene's vectors; kNone for "not set".
using Index = std::uint32_t;
inline constexpr Index kNone = 0xffffffffU;

/// How a material uses a texture: MTL's options -s -o -clamp -bm -imfchan and the like, or glTF's sampler and texture
/// transform, already resolved. Looked up at (u*scale.x + v*shear.x + offset.x, v*scale.y + u*shear.y + offset.y), v
/// upwards.
struct TextureUse {
    /// What lies outside 0..1: the picture again, its border, or the picture turned back and forth.
    enum class Wrap : std::uint8_t { repeat, clamp, mirror };
    Index texture = kNone;
    Vec2 scale{1, 1};
    Vec2 shear{0, 0};  ///< Not 0 where the picture is turned.
    Vec2 offset{0, 0};
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool nearest = false;      ///< One texel, not a mean of four.
    float strength = 1;        ///< Bump multiplier.
    std::uint8_t channel = 0;  ///< For scalar maps: 0 r, 1 g, 2 b, 3 alpha (matte), 4 luminance.
    std::uint8_t uv_set = 0;   ///< 0: looked up by a mesh's texture coordinates; 1: by its second ones.
};

}  // namespace sundog::scene
