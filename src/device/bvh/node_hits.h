// SPDX-License-Identifier: Apache-2.0
// Which children of a wide node a ray may hit: the step that every traversal repeats, in C++ and in GLSL.
#ifndef SUNDOG_DEVICE_BVH_NODE_HITS_H
#define SUNDOG_DEVICE_BVH_NODE_HITS_H

#include "device/bvh/node.h"
#include "kernel/compat/compat.h"

KERNEL_BEGIN

/// A ray as box tests want it.
struct BoxRay {
    real3 origin;
    real3 inverse_direction;  ///< Finite.
    word octant;              ///< Bits 0 to 2: the direction is negative in x, y, z.
};

/// 1 / direction, with directions too small to invert replaced by a small number of the same sign.
FN real finite_inverse(real direction) {
    real smallest = select(direction < real(0.0f), real(-1e-18f), real(1e-18f));
    return 1.0f / select(abs(direction) < real(1e-18f), smallest, direction);
}

FN BoxRay box_ray(real3 origin, real3 direction) {
    BoxRay ray;
    ray.origin = origin;
    ray.inverse_direction =
        real3(finite_inverse(direction.x), finite_inverse(direction.y), finite_inverse(direction.z));
    ray.octant = select(direction.x < real(0.0f), word(1u), word(0u)) |
                 select(direction.y < real(0.0f), word(2u), word(0u)) |
                 select(direction.z < real(0.0f), word(4u), word(0u));
    return ray;
}

/// 2^e as the node stores it: the exponent field of a float.
FN real node_step(word exponents, uint axis) { return as_real(((exponents >> (8u * axis)) & word(255u)) << 23u); }

/// Tests the eight child boxes against the part of the ray in [t_min, t_max]. A child that the ray touches is never
/// missed; rounding may report one that it misses by a hair.
/// inner_hits: bit (slot ^ octant) for each inner child hit, so that the lowest bit is the one to visit first.
/// primitive_hits: bit i for primitive number i after primitive_base of each leaf hit.
FN void node_hits(WideNode node, BoxRay ray, real t_min, real t_max, OUT(word) inner_hits, OUT(word) primitive_hits) {
    // t = (origin + q * step - ray.origin) / direction = q * scale + offset
    real3 scale = real3(node_step(node.exponents, 0u), node_step(node.exponents, 1u), node_step(node.exponents, 2u)) *
                  ray.inverse_direction;
    real3 offset = (real3(node.origin) - ray.origin) * ray.inverse_direction;
    // Each of these operations rounds by at most 2^-24 of the largest number involved (division by 2.5 times that on
    // a GPU): 2^-20 of it bounds the error of t and leaves room.
    real3 slack = (abs(offset) + abs(scale) * 256.0f) * 9.5367432e-7f;
    real3 offset_near = offset - slack;
    real3 offset_far = offset + slack;
    mask negative_x = (ray.octant & word(1u)) != word(0u);
    mask negative_y = (ray.octant & word(2u)) != word(0u);
    mask negative_z = (ray.octant & word(4u)) != word(0u);
    inner_hits = word(0u);
    primitive_hits = word(0u);
    for (uint pair = 0u; pair < 2u; ++pair) {
        word near_x = select(negative_x, word(node.upper_x[pair]), word(node.lower_x[pair]));
        word near_y = select(negative_y, word(node.upper_y[pair]), word(node.lower_y[pair]));
        word near_z = select(negative_z, word(node.upper_z[pair]), word(node.lower_z[pair]));
        word far_x = select(negative_x, word(node.lower_x[pair]), word(node.upper_x[pair]));
        word far_y = select(negative_y, word(node.lower_y[pair]), word(node.upper_y[pair]));
        word far_z = select(negative_z, word(node.lower_z[pair]), word(node.upper_z[pair]));
        for (uint i = 0u; i < 4u; ++i) {
            uint shift = 8u * i;
            real enter_x = real_from_word((near_x >> shift) & word(255u)) * scale.x + offset_near.x;
            real enter_y = real_from_word((near_y >> shift) & word(255u)) * scale.y + offset_near.y;
            real enter_z = real_from_word((near_z >> shift) & word(255u)) * scale.z + offset_near.z;
            real leave_x = real_from_word((far_x >> shift) & word(255u)) * scale.x + offset_far.x;
            real leave_y = real_from_word((far_y >> shift) & word(255u)) * scale.y + offset_far.y;
            real leave_z = real_from_word((far_z >> shift) & word(255u)) * scale.z + offset_far.z;
            real enter = max(max(enter_x, enter_y), max(enter_z, t_min));
            real leave = min(min(leave_x, leave_y), min(leave_z, t_max));
            word hit = select(enter <= leave, word(1u), word(0u));
            uint slot = 4u * pair + i;
            inner_hits = inner_hits | (((word(node.exponents) >> (24u + slot)) & hit) << (slot ^ ray.octant));
            word leaf = (word(node.leaves[pair]) >> shift) & word(255u);
            word places = (word(1u) << (leaf >> 5u)) - 1u;
            primitive_hits = primitive_hits | ((places << (leaf & word(31u))) * hit);
        }
    }
}

KERNEL_END

#endif
