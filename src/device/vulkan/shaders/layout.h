// SPDX-License-Identifier: Apache-2.0
// What the Vulkan host and its shaders share beyond kernel/shared.h: bindings, and the structs of the device's own
// buffers.
#ifndef SUNDOG_DEVICE_VULKAN_LAYOUT_H
#define SUNDOG_DEVICE_VULKAN_LAYOUT_H

#ifdef __cplusplus
#include "device/bvh/node.h"
#include "kernel/shared.h"
namespace sundog::kernel {
#define LAYOUT_CONST constexpr
#else
#define LAYOUT_CONST const
#endif

// Bindings of set 0: the frame's arrays as kernel/arrays.h numbers them, then the device's own.
LAYOUT_CONST uint BINDING_LIGHTS = 14u;
LAYOUT_CONST uint BINDING_INSTANCES = 15u;
LAYOUT_CONST uint BINDING_EMITTERS = 25u;
LAYOUT_CONST uint BINDING_NODES = 26u;
LAYOUT_CONST uint BINDING_LEAF_SHAPES = 27u;
LAYOUT_CONST uint BINDING_LEAF_REFS = 28u;
LAYOUT_CONST uint BINDING_TOP_REFS = 29u;
/// Sums of radiance, after the ray counters.
LAYOUT_CONST uint BINDING_RADIANCE = 30u;
LAYOUT_CONST uint BINDING_AOVS = 31u;
/// No more than 32 storage buffers before it: Mesa's software driver has no more.
LAYOUT_CONST uint BINDING_FRAME = 32u;
LAYOUT_CONST uint BINDING_COUNT = 33u;

/// Sides of a workgroup, in pixels.
LAYOUT_CONST uint GROUP_WIDTH = 8u;
LAYOUT_CONST uint GROUP_HEIGHT = 8u;

/// Shape of a primitive, copied into the order of the leaves so that a leaf's lie side by side. Triangle: its corners.
/// Sphere: a is the centre, b.x the radius. Box: a is the lower corner, b the upper.
struct LeafShape {
    vec3 a, b, c;
};

/// Which primitive a LeafShape is.
struct LeafRef {
    uint primitive;  ///< Into triangles, spheres or boxes.
    uint geometry;
};

/// A leaf of the top level, which holds hierarchies.
struct TopRef {
    uint root;      ///< Into nodes.
    uint instance;  ///< Where the hierarchy stands; NONE: its boxes are in world space.
};

/// Auxiliary values of a pixel, from sample 0 (not written by others); the cost is that of the dispatch's samples.
struct PixelAovs {
    float depth;
    vec3 normal;
    vec3 albedo;
    uint object, primitive, material;
    float cost;
};

/// Push constants of one dispatch: which pixels of the image, which samples.
struct Dispatch {
    uint x0, y0;         ///< The first pixel.
    uint width, height;  ///< How many; the buffers hold them row by row.
    uint first_sample, sample_count;
};

#ifdef __cplusplus
}  // namespace sundog::kernel
#endif
#undef LAYOUT_CONST
#endif
