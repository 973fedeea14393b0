// SPDX-License-Identifier: Apache-2.0
// What is computed once before the film starts.
#pragma once

#include "stage/world.h"

namespace sundog::intro {

inline constexpr uint kPaletteSize = 256;

inline constexpr uint kVolumeBits = 7;
inline constexpr uint kVolumeSide = 1U << kVolumeBits;
inline constexpr uint kVolumeVoxels = kVolumeSide * kVolumeSide * kVolumeSide;

/// Pointers to memory that outlives all frames.
struct Tables {
    const uint* noise;     ///< trace/noise_volume.h.
    const uint* palettes;  ///< kPaletteSize entries each: square roots of linear red, green and blue, 10 bits each.
};

}  // namespace sundog::intro
