// SPDX-License-Identifier: Apache-2.0
// The inner loop of the raw Embree measurement, compiled once for each packet width. Plain pointers only: the units are
// built for processors that the rest of the program may not run on, so they share no inline code with it.
#pragma once

#include <cstdint>

#include "kernel/shared.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace sundog::bench {

/// One Embree geometry: what a primitive of it is made of, by Embree's primitive number.
struct RawGeometry {
    const std::uint32_t* materials;
    const kernel::TriangleCorners* normals;  ///< Null where the geometry is flat or not of triangles.
};

/// What the rays are made from. `opaque` holds the geometry that blocks shadow rays, `all` everything.
struct RawView {
    RTCScene all;
    RTCScene opaque;
    const RawGeometry* geometries;
    const kernel::Material* materials;
    const kernel::vec3* normals;
    const kernel::Light* lights;
    kernel::FrameParams frame;
};

/// What was traced. `blocked` depends on every shadow ray's answer, so that none can be left out.
struct RawCounts {
    std::uint64_t rays = 0;
    std::uint64_t shadow_rays = 0;
    std::uint64_t blocked = 0;
};

/// Traces all rays of pixels [x0, x1) x [y0, y1): primary rays; a shadow ray to each light that the surface faces;
/// mirrored and refracted rays up to frame.max_depth, with their shadow rays. Adds to `counts`.
template <int lanes>
void trace_tile(const RawView& view, int x0, int y0, int x1, int y1, RawCounts& counts);
template <>
void trace_tile<4>(const RawView& view, int x0, int y0, int x1, int y1, RawCounts& counts);
template <>
void trace_tile<8>(const RawView& view, int x0, int y0, int x1, int y1, RawCounts& counts);
template <>
void trace_tile<16>(const RawView& view, int x0, int y0, int x1, int y1, RawCounts& counts);

}  // namespace sundog::bench
