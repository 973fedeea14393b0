// SPDX-License-Identifier: Apache-2.0
// Pavements of triangles, squares and hexagons for shaders: the CPU asks the host (fields/pavement.cpp, where their
// geometry is told).
#ifndef SUNDOG_KERNEL_PATTERNS_SHADER_PAVEMENT_H
#define SUNDOG_KERNEL_PATTERNS_SHADER_PAVEMENT_H

#include "kernel/math.h"
#include "kernel/patterns/code.h"
#include "kernel/patterns/noise.h"

KERNEL_BEGIN

/// a / b, rounded down; b > 0.
FN int floored_quotient(int a, int b) { return int(floor((float(a) + 0.5f) / float(b))); }

/// Which sides of the cell (i, j) are between two tiles, as bits.
FN uint pavement_sides(SCENE uint at, int i, int j) {
    int width = int(AT(code, at + 4u));
    int height = int(AT(code, at + 5u));
    int k = floored_quotient(j, height);
    int along = i - k * int(AT(code, at + 6u));
    int column = along - floored_quotient(along, width) * width;
    uint digit = uint((j - k * height) * width + column);
    return (AT(code, at + 7u + (digit >> 3u)) >> ((digit & 7u) * 4u)) & 7u;
}

/// A side of squares or triangles: from a corner along an axis, 0: x; 1: z, or 60 degrees from x; 2: 120 degrees.
struct PavementSide {
    int i, j, axis;
};

/// From a corner of triangles, the side that is `direction` times 60 degrees from x.
FN PavementSide triangle_side(int i, int j, int direction) {
    int d = direction - floored_quotient(direction, 6) * 6;
    PavementSide side;
    side.i = d == 2 || d == 3 ? i - 1 : i;
    side.j = d == 4 || d == 5 ? j - 1 : j;
    side.axis = d > 2 ? d - 3 : d;
    return side;
}

/// From a corner of squares, one of four sides: along x from there and towards there, then along z.
FN PavementSide square_side(int i, int j, int number) {
    PavementSide side;
    side.i = number == 1 ? i - 1 : i;
    side.j = number == 3 ? j - 1 : j;
    side.axis = number < 2 ? 0 : 1;
    return side;
}

/// Whether there are two tiles on both sides of it.
FN bool is_pavement_border(SCENE uint at, PavementSide side) {
    int axis = side.axis;
    int i = side.i;
    int j = side.j;
    uint bit = axis == 0 ? 2u : axis == 1 ? 1u : 4u;
    bool is_side = true;
    if (AT(code, at) == 6u) {
        // The hexagon above the side, if it is one of a hexagon: its centre is the corner of triangles at (a, b).
        int a = axis == 0 ? i : axis == 1 ? i - 1 : i + 1;
        int thirds = j + 2 - a;
        j = floored_quotient(thirds, 3);
        is_side = thirds == j * 3;
        i = a - 1 + j;
        bit = axis == 0 ? 2u : axis == 1 ? 4u : 1u;
    }
    return is_side && (pavement_sides(SCENE_ at, i, j) & bit) != 0u;
}

/// Whether a corner of triangles or squares lies on a border.
FN bool is_pavement_corner(SCENE uint at, int i, int j) {
    bool squares = AT(code, at) == 4u;
    int count = squares ? 4 : 6;
    bool found = false;
    for (int d = 0; d < count; d = d + 1) {
        PavementSide side = triangle_side(i, j, d);
        if (squares) side = square_side(i, j, d);
        found = found || is_pavement_border(SCENE_ at, side);
    }
    return found;
}

FN real border_shade(real depth, float width) { return clamp(1.0f - depth / width, real(0.0f), real(1.0f)); }
FN real flat_length(real x, real z) { return sqrt(x * x + z * z); }

const float TRIANGLE_HEIGHT = 0.866025404f;
const float TRIANGLE_INRADIUS = 0.288675135f;
const float ROOT_THIRD = 0.577350269f;

FN real triangle_pavement(SCENE uint at, real x, real z) {
    uint exterior = AT(code, at + 1u);
    uint interior = AT(code, at + 2u);
    uint form = AT(code, at + 3u);
    real v = z / TRIANGLE_HEIGHT;
    real u = x - v * 0.5f;
    int i = int(floor(u));
    int j = int(floor(v));
    real fu = u - floor(u);
    real fv = v - floor(v);
    // The nearest corner, and the direction of the triangle's first side from there.
    int first = 0;
    if (fu + fv <= 1.0f) {
        real rest = 1.0f - fu - fv;
        if (fu > fv && fu > rest) {
            i = i + 1;
            first = 2;
        } else if (fv >= fu && fv > rest) {
            j = j + 1;
            first = 4;
        }
    } else {
        real rest = fu + fv - 1.0f;
        if (1.0f - fu > 1.0f - fv && 1.0f - fu > rest) {
            j = j + 1;
            first = 5;
        } else if (1.0f - fv >= 1.0f - fu && 1.0f - fv > rest) {
            i = i + 1;
            first = 1;
        } else {
            i = i + 1;
            j = j + 1;
            first = 3;
        }
    }
    real rx = x - (float(i) + float(j) * 0.5f);
    real rz = z - float(j) * TRIANGLE_HEIGHT;
    // The direction's cosine and sine.
    float cosine_first = first == 0 ? 1.0f : first == 3 ? -1.0f : first == 1 || first == 5 ? 0.5f : -0.5f;
    float sine_first = first == 0 || first == 3 ? 0.0f : first < 3 ? TRIANGLE_HEIGHT : -TRIANGLE_HEIGHT;
    real along_first = rx * cosine_first + rz * sine_first;
    real from_first = rz * cosine_first - rx * sine_first;
    real along_second = along_first * 0.5f + from_first * TRIANGLE_HEIGHT;
    real from_second = along_first * TRIANGLE_HEIGHT - from_first * 0.5f;
    real along_middle = (along_first + along_second) * ROOT_THIRD;
    bool on_first = is_pavement_border(SCENE_ at, triangle_side(i, j, first));
    bool on_second = is_pavement_border(SCENE_ at, triangle_side(i, j, first + 1));
    if (on_first && on_second) {
        real plain = border_shade(min(from_first, from_second), TRIANGLE_INRADIUS);
        real to_middle = ROOT_THIRD - along_middle;
        if (exterior == 1u) return max(plain, min(to_middle / TRIANGLE_INRADIUS, 1.0f));
        if (exterior == 2u)
            return min(flat_length((from_first - from_second) * ROOT_THIRD, to_middle) / TRIANGLE_INRADIUS, 1.0f);
        return plain;
    }
    if (on_first || on_second) {
        real plain = border_shade(on_first ? from_first : from_second, TRIANGLE_INRADIUS);
        if (form == 0u || form == 3u) return plain;
        int beyond = on_first ? first + 2 : first - 1;
        if (!is_pavement_border(SCENE_ at, triangle_side(i, j, beyond))) return plain;
        real along_shared = on_first ? along_second : along_first;
        real from_shared = on_first ? from_second : from_first;
        if (form == 1u) return max(plain, clamp(2.0f - 4.0f * along_shared, 0.0f, 1.0f));
        return border_shade(TRIANGLE_HEIGHT - flat_length(1.0f - along_shared, from_shared), TRIANGLE_INRADIUS);
    }
    if (!is_pavement_corner(SCENE_ at, i, j)) return 0.0f;
    if (interior == 1u) return border_shade(TRIANGLE_HEIGHT * max(along_first, along_second), TRIANGLE_INRADIUS);
    return border_shade(interior == 2u ? TRIANGLE_HEIGHT * flat_length(rx, rz) : along_middle, TRIANGLE_INRADIUS);
}

FN real square_pavement(SCENE uint at, real x, real z) {
    uint exterior = AT(code, at + 1u);
    uint interior = AT(code, at + 2u);
    uint form = AT(code, at + 3u);
    int i = int(floor(x));
    int j = int(floor(z));
    uint own = pavement_sides(SCENE_ at, i, j);
    bool left = (own & 1u) != 0u;
    bool lower = (own & 2u) != 0u;
    bool right = (pavement_sides(SCENE_ at, i + 1, j) & 1u) != 0u;
    bool upper = (pavement_sides(SCENE_ at, i, j + 1) & 2u) != 0u;
    bool on_right = !(x - floor(x) < 0.5f);
    bool on_upper = !(z - floor(z) < 0.5f);
    int corner_i = on_right ? i + 1 : i;
    int corner_j = on_upper ? j + 1 : j;
    real dx = abs(x - float(corner_i));
    real dz = abs(z - float(corner_j));
    if (left != right && lower != upper && form != 3u) {
        // Where a tile turns: outer and inner corner have a form of their own.
        int inner_i = left ? i + 1 : i;
        int inner_j = lower ? j + 1 : j;
        if (is_pavement_corner(SCENE_ at, inner_i, inner_j)) {
            real px = abs(x - float(inner_i));
            real pz = abs(z - float(inner_j));
            real from_inner = form == 1u ? px + pz : flat_length(px, pz);
            if (form != 0u) return min(1.0f, abs(2.0f * from_inner - 1.0f));
            exterior = 0u;
            interior = 0u;
        }
    }
    bool on_x = on_right ? right : left;
    bool on_z = on_upper ? upper : lower;
    if (on_x && on_z) {
        if (exterior == 1u) return min(1.0f, 2.0f - 2.0f * (dx + dz));
        if (exterior == 2u) return min(1.0f, 2.0f * flat_length(0.5f - dx, 0.5f - dz));
        return border_shade(min(dx, dz), 0.5f);
    }
    if (on_x || on_z) return border_shade(on_x ? dx : dz, 0.5f);
    if (!is_pavement_corner(SCENE_ at, corner_i, corner_j)) return 0.0f;
    if (interior == 1u) return border_shade(dx + dz, 0.5f);
    return border_shade(interior == 2u ? flat_length(dx, dz) : max(dx, dz), 0.5f);
}

/// 1 at the tiles' borders, falling to 0 within. Words: the number of sides, forms of exterior, interior and where a
/// tile turns, after how many cells the tiles repeat (width, height and shift), and eight cells' borders a word.
FN real pavement_field(SCENE uint at, real x, real z) {
    if (AT(code, at) == 4u) return square_pavement(SCENE_ at, x, z);
    return triangle_pavement(SCENE_ at, x, z);
}

KERNEL_END

#endif
