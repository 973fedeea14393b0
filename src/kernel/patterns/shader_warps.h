// SPDX-License-Identifier: Apache-2.0
// Warps for shaders, one point at a time: the CPU asks the host, which computes the same in double precision
// (fields/warps.cpp). The words that they read are written by fields/shader_words.cpp.
#ifndef SUNDOG_KERNEL_PATTERNS_SHADER_WARPS_H
#define SUNDOG_KERNEL_PATTERNS_SHADER_WARPS_H

#include "kernel/patterns/code.h"
#include "kernel/patterns/noise.h"

KERNEL_BEGIN

/// Words: the axis (0 to 2), the width of a copy along it (0: there are none), axes along which every second copy is
/// mirrored as bits, what each copy is moved by.
FN real3 repeated_point(SCENE uint at, real3 p) {
    uint axis = AT(code, at);
    float width = code_float(SCENE_ at + 1u);
    if (width == 0.0f) return p;
    real along = axis == 0u ? p.x : axis == 1u ? p.y : p.z;
    real copy = floor(along / width);
    real within = along - copy * width;
    real3 result = real3(axis == 0u ? within : p.x, axis == 1u ? within : p.y, axis == 2u ? within : p.z);
    real size = abs(copy);
    if (size - 2.0f * floor(size * 0.5f) == 1.0f) {
        uint flip = AT(code, at + 2u);
        if ((flip & 1u) != 0u) result.x = (axis == 0u ? width : 0.0f) - result.x;
        if ((flip & 2u) != 0u) result.y = (axis == 1u ? width : 0.0f) - result.y;
        if ((flip & 4u) != 0u) result.z = (axis == 2u ? width : 0.0f) - result.z;
    }
    return result + code_vec3(SCENE_ at + 3u) * copy;
}

/// Where the block of size `size` begins that x lies in; 0 where blocks don't repeat.
FN real block_start(real x, float size) { return size == 0.0f ? 0.0f : floor(x / size) * size; }

/// Words: the hole's centre, radius, falloff and strength, the sizes of blocks that each have one (0: one along the
/// axis), 1 if it pushes, 1 if holes stray in their blocks, and by how much.
FN real3 black_hole_point(SCENE uint at, real3 p) {
    real3 corner = real3(block_start(p.x, code_float(SCENE_ at + 6u)), block_start(p.y, code_float(SCENE_ at + 7u)),
                         block_start(p.z, code_float(SCENE_ at + 8u)));
    real3 center = code_vec3(SCENE_ at) + corner;
    if (AT(code, at + 10u) != 0u) {
        // A hair more, for what would be whole but for rounding.
        real3 place = corner * 16.0f + real3(0.001f);
        word hash = cell_hash(real3(floor(place.x), floor(place.y), floor(place.z)), 0x35u);
        real3 random = real3(real_from_word(hash & 1023u), real_from_word((hash >> 10u) & 1023u),
                             real_from_word((hash >> 20u) & 1023u)) *
                       (1.0f / 1023.0f);
        center = center + code_vec3(SCENE_ at + 11u) * random;
    }
    real3 from_center = p - center;
    real distance = length(from_center);
    float radius = code_float(SCENE_ at + 3u);
    if (!(distance < radius)) return p;
    float strength = code_float(SCENE_ at + 5u);
    real closeness = power(1.0f - distance / radius, code_float(SCENE_ at + 4u));
    real force = min(strength * closeness, 1.0f);
    return p + from_center * (AT(code, at + 9u) != 0u ? -force : force);
}

/// A cube's net of four faces in a row, with the upper and the lower one at the second.
FN real3 cubic_point(real3 p) {
    real3 a = abs(p);
    real size = largest(a);
    if (size == 0.0f) return p;
    real column = 1.0f;
    real row = 1.0f;
    real u = p.x;
    real v = p.y;
    if (a.x >= a.y && a.x >= a.z) {
        column = p.x >= 0.0f ? 2.0f : 0.0f;
        u = p.x >= 0.0f ? -p.z : p.z;
    } else if (a.y >= a.z) {
        row = p.y >= 0.0f ? 2.0f : 0.0f;
        v = p.y >= 0.0f ? -p.z : p.z;
    } else if (p.z < 0.0f) {
        column = 3.0f;
        u = -p.x;
    }
    return real3((column + (u / size + 1.0f) * 0.5f) * 0.25f, (row + (v / size + 1.0f) * 0.5f) * 0.333333333f, size);
}

/// An angle as a share of the circle: 0 to 1.
FN real turn_share(real y, real x) {
    real share = angle_of(y, x) * 0.159154943f;
    return share < 0.0f ? share + 1.0f : share;
}

/// Words: MAPPING_*, what z becomes (unit), the distance along a plane's normal, the exponent of distances, the
/// major radius.
FN real3 mapped_point(SCENE uint at, real3 p) {
    uint kind = AT(code, at);
    if (kind == MAPPING_CUBIC) return cubic_point(p);
    real3 q = real3(p.x, p.y, code_float(SCENE_ at + 4u));
    if (kind != MAPPING_PLANAR) {
        real from_axis = sqrt(p.x * p.x + p.z * p.z);
        real outwards = from_axis - code_float(SCENE_ at + 6u);
        real radius = from_axis;
        if (kind == MAPPING_SPHERICAL) radius = length(p);
        if (kind == MAPPING_TOROIDAL) radius = sqrt(outwards * outwards + p.y * p.y);
        if (radius == 0.0f && kind != MAPPING_TOROIDAL) return p;
        if (from_axis == 0.0f && kind == MAPPING_TOROIDAL) return p;
        real size = power(radius, code_float(SCENE_ at + 5u));
        q = real3(turn_share(p.z, p.x), p.y, radius);
        if (radius == 0.0f) {
            q.y = 0.0f;
        } else {
            q.x = q.x * size;
            if (kind == MAPPING_SPHERICAL) q.y = (angle_of(p.y, from_axis) * 0.318309886f + 0.5f) * size;
            if (kind == MAPPING_TOROIDAL) q.y = turn_share(-p.y, -outwards) * size;
        }
    }
    vec3 o = code_vec3(SCENE_ at + 1u);
    return real3(q.x * (o.y + o.z) + q.z * o.x, q.y * (o.x + o.z) - q.z * o.y, q.y * o.y - q.x * o.x + q.z * o.z);
}

/// p warped as instruction `op` (OP_REPEAT, OP_BLACK_HOLE, OP_MAPPING) does by the words of `code` from `at` on.
FN real3 shader_warped_point(SCENE uint op, uint at, real3 p) {
    if (PROGRAMS_HAVE(OP_REPEAT) && op == OP_REPEAT) return repeated_point(SCENE_ at, p);
    if (PROGRAMS_HAVE(OP_BLACK_HOLE) && op == OP_BLACK_HOLE) return black_hole_point(SCENE_ at, p);
    if (PROGRAMS_HAVE(OP_MAPPING) && op == OP_MAPPING) return mapped_point(SCENE_ at, p);
    return p;
}

KERNEL_END

#endif
