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
LAYOUT_CONST uint BINDING_LEAVES = 27u;
LAYOUT_CONST uint BINDING_SOLIDS = 28u;
LAYOUT_CONST uint BINDING_TOP_REFS = 29u;
/// Sums of radiance, after the ray counters.
LAYOUT_CONST uint BINDING_RADIANCE = 30u;
LAYOUT_CONST uint BINDING_AOVS = 31u;
/// No more than 32 storage buffers before it: Mesa's software driver has no more.
LAYOUT_CONST uint BINDING_FRAME = 32u;
LAYOUT_CONST uint BINDING_COUNT = 33u;

/// What dispatches count, at the beginning of the buffer of radiance: low and high halves of the number of rays, then
/// of shadow rays; workgroups' parts in which loops were cut short; nothing.
LAYOUT_CONST uint COUNTERS = 8u;
LAYOUT_CONST uint COUNTER_RAYS = 0u;
LAYOUT_CONST uint COUNTER_SHADOW_RAYS = 2u;
LAYOUT_CONST uint COUNTER_CUT_LOOPS = 4u;

/// Sides of a workgroup, in pixels.
LAYOUT_CONST uint GROUP_WIDTH = 8u;
LAYOUT_CONST uint GROUP_HEIGHT = 8u;

/// A primitive, with its shape, in the order of the hierarchies' leaves. Triangle: a, b and c are its corners. Sphere:
/// a is the centre, b.x the radius. Box: a is the lower corner, b the upper.
struct Leaf {
    vec3 a, b, c;
    uint primitive;  ///< Into triangles, spheres or boxes; of a solid: where in `solids` its first node is.
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
    uint probe_rounds;  ///< Of the loop that shows whether the driver cuts loops short: 2, which no compiler knows.
};

// Exact solids: slots of 64 bits, each a double or two words. A solid's tree stands in preorder, a node in
// SOLID_NODE_SLOTS:
//   flags, where the node after the node's subtree is;
//   where its parent is (NONE: it is the root), of a leaf: where its numbers are;
//   where its gate's six floats are (if SOLID_GATED), and nothing;
//   off which box there is no surface, six floats.
// A leaf's numbers: material and interior material (NONE: none), shape_from_world (columns x, y, z, t), then what
// solids/shape_numbers.h says.
LAYOUT_CONST uint SOLID_NODE_SLOTS = 6u;
LAYOUT_CONST uint SOLID_NODE_BOX = 3u;
LAYOUT_CONST uint SOLID_LEAF_NUMBERS = 13u;

// A node's flags: the lowest four bits say how its children are put together.
LAYOUT_CONST uint SOLID_COMBINATION = 15u;
LAYOUT_CONST uint SOLID_LEAF = 0u;
LAYOUT_CONST uint SOLID_COMBINED = 1u;
LAYOUT_CONST uint SOLID_MERGED = 2u;
LAYOUT_CONST uint SOLID_COMMON = 3u;
LAYOUT_CONST uint SOLID_CLIPPED = 4u;
LAYOUT_CONST uint SOLID_INVERTED = 16u;
LAYOUT_CONST uint SOLID_BEYOND = 32u;  ///< Off the box all is inside.
LAYOUT_CONST uint SOLID_UNBOUNDED = 64u;
LAYOUT_CONST uint SOLID_GATED = 128u;
LAYOUT_CONST uint SOLID_KIND_SHIFT = 8u;  ///< A leaf's SHAPE_* from there on.

// Numbers of solids::ShapeNumbers::Kind.
LAYOUT_CONST uint SHAPE_SPHERE = 1u;
LAYOUT_CONST uint SHAPE_BOX = 2u;
LAYOUT_CONST uint SHAPE_HALF_SPACE = 3u;
LAYOUT_CONST uint SHAPE_CONE = 4u;
LAYOUT_CONST uint SHAPE_QUADRIC = 5u;
LAYOUT_CONST uint SHAPE_DISC = 6u;
LAYOUT_CONST uint SHAPE_TORUS = 7u;
LAYOUT_CONST uint SHAPE_POLYNOMIAL = 8u;
LAYOUT_CONST uint SHAPE_POLYGON = 9u;
LAYOUT_CONST uint SHAPE_PRISM = 10u;
LAYOUT_CONST uint SHAPE_REVOLUTION = 11u;
LAYOUT_CONST uint SHAPE_LATHE = 12u;
LAYOUT_CONST uint SHAPE_BLOB = 13u;

#ifdef __cplusplus
}  // namespace sundog::kernel
#endif
#undef LAYOUT_CONST
#endif
