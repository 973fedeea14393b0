// SPDX-License-Identifier: Apache-2.0
// Fields for shaders, one point at a time: the CPU asks the host, which computes the same in double precision
// (fields/host_fields.cpp). The words that they read are written by fields/shader_words.cpp.
#ifndef SUNDOG_KERNEL_PATTERNS_SHADER_FIELDS_H
#define SUNDOG_KERNEL_PATTERNS_SHADER_FIELDS_H

#include "kernel/patterns/code.h"
#include "kernel/patterns/host.h"
#include "kernel/patterns/noise.h"
#include "kernel/patterns/shader_fractals.h"
#include "kernel/patterns/shader_function.h"
#include "kernel/patterns/shader_pavement.h"

KERNEL_BEGIN

/// 1 for unit vectors alike, 0 for opposite ones, linear in the angle between them (by Kahan's formula, which is exact
/// for small angles, too).
FN real directions_alike(real3 a, real3 b) { return 1.0f - angle_of(length(a - b), length(a + b)) * 0.636619772f; }

/// Words: a direction, or a point to face if the next word is 1; the lower end and the width of the values' range; the
/// altitude's unit vector, its length (0: none), and its range likewise.
FN real slope_field(SCENE uint at, PatternPoint point, real3 p) {
    if (dot(point.normal, point.normal) == 0.0f) return 0.0f;
    real3 direction = code_vec3(SCENE_ at);
    if (AT(code, at + 3u) != 0u) direction = direction - point.world;
    real size = length(direction);
    if (size == 0.0f) return 0.0f;
    real value = directions_alike(point.normal, direction * (1.0f / size));
    value = (value - code_float(SCENE_ at + 4u)) / code_float(SCENE_ at + 5u);
    real altitude_size = code_float(SCENE_ at + 9u);
    if (altitude_size == 0.0f) return value;
    real altitude = dot(p, code_vec3(SCENE_ at + 6u));
    altitude = (altitude - code_float(SCENE_ at + 10u)) / code_float(SCENE_ at + 11u);
    return (size * value + altitude_size * altitude) / (size + altitude_size);
}

/// How a surface faces the ray that sees it.
FN real aoi_field(PatternPoint point) {
    if (dot(point.normal, point.normal) == 0.0f) return 0.0f;
    return directions_alike(point.normal, -point.direction);
}

/// From the middle of the cell of size 1 that p lies in.
FN real3 from_cell_middle(real3 p) { return real3(fraction(p.x) - 0.5f, fraction(p.y) - 0.5f, fraction(p.z) - 0.5f); }

/// A quilt's height at a distance from the middle of a cell.
FN real quilted_curve(float control0, float control1, real u) {
    return u * (0.666666667f * u * u + 2.0f * control0 * (1.0f - u) * (1.0f - u) + 2.0f * control1 * u * (1.0f - u));
}

/// Words: two control values.
FN real quilted_field(SCENE uint at, real3 p) {
    real3 d = from_cell_middle(p);
    return (abs(d.x) + abs(d.y) + abs(d.z)) * 0.577350269f *
           quilted_curve(code_float(SCENE_ at), code_float(SCENE_ at + 1u), length(d));
}

/// The field of kind `kind` (of OP_SHARED_FIELD) at p, by the words of `code` from `at` on.
FN real shader_field_value(SCENE uint kind, uint at, real3 p, PatternPoint point) {
    if (FIELDS_HAVE(FIELD_SLOPE) && kind == FIELD_SLOPE) return slope_field(SCENE_ at, point, p);
    if (FIELDS_HAVE(FIELD_AOI) && kind == FIELD_AOI) return aoi_field(point);
    if (FIELDS_HAVE(FIELD_QUILTED) && kind == FIELD_QUILTED) return quilted_field(SCENE_ at, p);
    if (FIELDS_HAVE(FIELD_PAVEMENT) && kind == FIELD_PAVEMENT) return pavement_field(SCENE_ at, p.x, p.z);
    if (FIELDS_HAVE(FIELD_FRACTAL) && kind == FIELD_FRACTAL) return fractal_field(SCENE_ at, p.x, p.y);
    if (FIELDS_HAVE(FIELD_FUNCTION) && kind == FIELD_FUNCTION) return function_field(SCENE_ at, p);
    return 0.0f;
}

KERNEL_END

#endif
