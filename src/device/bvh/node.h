// SPDX-License-Identifier: Apache-2.0
// The node of the wide bounding volume hierarchy, shared by the builder and the traversal in GLSL (scalar layout).
#ifndef SUNDOG_DEVICE_BVH_NODE_H
#define SUNDOG_DEVICE_BVH_NODE_H

#ifdef __cplusplus
#include "kernel/compat/types.h"
namespace sundog::kernel {
#define BVH_CONST constexpr
#else
#define BVH_CONST const
#endif

/// Children of a node at most.
BVH_CONST uint BVH_WIDTH = 8u;
/// Primitives of a leaf at most.
BVH_CONST uint BVH_MAX_LEAF = 3u;
/// Levels of a hierarchy at most, the root's counted: enough for 24 * 8^13 primitives.
BVH_CONST uint BVH_MAX_DEPTH = 14u;

/// Eight children in 80 bytes, after Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through
/// Compressed Wide BVHs" (2017). A child's box is lower_q * 2^e + origin to upper_q * 2^e + origin in each axis, one
/// byte a plane, rounded outwards. The slot of a child hints at its place: bit 0 is set where it lies towards +x of
/// its siblings, bit 1 towards +y, bit 2 towards +z, so that slots sort the children front to back for any ray.
struct WideNode {
    vec3 origin;
    uint exponents;       ///< Bytes 0 to 2: e + 127 of x, y and z. Byte 3: mask of the slots that hold inner nodes.
    uint child_base;      ///< The inner children are nodes child_base, child_base + 1, ... in the order of their slots.
    uint primitive_base;  ///< The leaves' primitives start here in the hierarchy's order.
    uint leaves[2];       ///< One byte a slot: bits 5 and 6 the number of primitives (0: no leaf), bits 0 to 4 the
                          ///< place of the first after primitive_base.
    uint lower_x[2], lower_y[2], lower_z[2];  ///< One byte a slot, slot 0 lowest.
    uint upper_x[2], upper_y[2], upper_z[2];
};

#ifdef __cplusplus
static_assert(sizeof(WideNode) == 80);
}  // namespace sundog::kernel
#endif
#undef BVH_CONST
#endif
