// SPDX-License-Identifier: Apache-2.0
// What is known of shadows before any ray is traced: the light buffer (Haines and Greenberg, IEEE Computer Graphics and
// Applications 6(9), 1986), read by units that hold a kernel.
#pragma once

#include "kernel/rays.h"

namespace sundog::kernel {

/// Directions from one light, as cells on the sides of a cube around it.
struct LightCells {
    /// For each cell of six sides of side*side: the triangle that hides all others from all of it, with
    /// LIGHT_CELL_BLOCKS if no light passes through it; or NONE. Null: nothing is known of this light.
    const uint* cells = nullptr;
    uint side = 0;
    float nearest = 0;  ///< Points nearer to the light than this, along the cube's axis, aren't asked about.
};
inline constexpr uint LIGHT_CELL_BLOCKS = 0x80000000U;

}  // namespace sundog::kernel

KERNEL_BEGIN

/// The lanes of `lit` of which light number `light` and a shadow ray from `origin`, on triangle `primitive`, aren't
/// known to see or to miss each other; and in `dark` those of which it is known that they don't see each other.
FN mask unknown_shadows(SCENE uint light, real3 origin, word primitive, mask lit, OUT(mask) dark) {
    dark = mask_and(lit, mask_not(lit));
    const LightCells& buffer = scene.light_cells[light];
    if (buffer.cells == nullptr) return lit;
    const real3 v = origin - real3(scene.lights[light].place);
    const real ax = abs(v.x), ay = abs(v.y), az = abs(v.z);
    const mask along_x = mask_and(ax >= ay, ax >= az);
    const mask along_y = mask_and(mask_not(along_x), ay >= az);
    const real way = select(along_x, v.x, select(along_y, v.y, v.z));
    const real across = select(along_x, v.y, v.x), down = select(mask_or(along_x, along_y), v.z, v.y);
    const mask far = abs(way) > real(buffer.nearest);
    const real scale = float(buffer.side) * 0.5f / select(far, abs(way), real(1.0f));
    const float middle = float(buffer.side) * 0.5f, last = float(buffer.side - 1u);
    const word column = word_from_real(clamp(across * scale + middle, real(0.0f), real(last)));
    const word row = word_from_real(clamp(down * scale + middle, real(0.0f), real(last)));
    word face = select(along_x, word(0u), select(along_y, word(2u), word(4u)));
    face = face + select(way < real(0.0f), word(1u), word(0u));
    const word at = (face * word(buffer.side) + row) * word(buffer.side) + column;
    const word cell = load(buffer.cells, sizeof(uint), valid_index(mask_and(lit, far), at));
    const mask known = mask_and(mask_and(lit, far), cell != word(NONE));
    const mask own = (cell & word(~LIGHT_CELL_BLOCKS)) == primitive;
    dark = mask_and(mask_and(known, mask_not(own)), (cell & word(LIGHT_CELL_BLOCKS)) != word(0u));
    return mask_and(lit, mask_not(mask_or(mask_and(known, own), dark)));
}

KERNEL_END
