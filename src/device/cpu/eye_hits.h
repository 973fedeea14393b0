// SPDX-License-Identifier: Apache-2.0
// What rasterising (device/cpu/raster) knows of a packet of eye rays.
#pragma once

#include "kernel/shared.h"

namespace sundog::kernel {

/// A ray's triangle isn't known: it has to be traced.
inline constexpr uint EYE_UNKNOWN = NONE - 1U;

/// For the rays of one packet, by lane.
struct EyeHits {
    const uint* triangles;   ///< Index into SceneView::triangles, NONE where the ray meets none, or EYE_UNKNOWN.
    const uint* geometries;  ///< For all of SceneView::triangles: whose it is.
};

}  // namespace sundog::kernel
