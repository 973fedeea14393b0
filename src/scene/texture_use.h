// SPDX-License-Identifier: Apache-2.0
// How materials use textures.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace sundog::scene {

/// Index into one of the Scene's vectors; kNone for "not set".
using Index = std::uint32_t;
inline constexpr Index kNone = 0xffffffffU;

/// How a material uses a texture (MTL options -s -o -clamp -bm -imfchan and the like, already resolved).
struct TextureUse {
    Index texture = kNone;
    Vec2 scale{1, 1};
    Vec2 offset{0, 0};
    bool clamp = false;        ///< Outside 0..1: clamp instead of repeat.
    float strength = 1;        ///< Bump multiplier.
    std::uint8_t channel = 0;  ///< For scalar maps: 0 r, 1 g, 2 b, 3 alpha (matte), 4 luminance.
};

}  // namespace sundog::scene
