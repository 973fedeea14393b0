// SPDX-License-Identifier: Apache-2.0
// Normals bent by patterns (POV-Ray's reference, section 3.4.6.2 "Normal"). Patterns are heights, of which the slope is
// found by differences; bumps, dents, wrinkles, ripples and waves have formulas of their own. Amounts are those that
// POV-Ray 3.7's pictures show.
#ifndef SUNDOG_KERNEL_MATERIALS_NORMAL_H
#define SUNDOG_KERNEL_MATERIALS_NORMAL_H

#include "kernel/materials/surface.h"
#include "kernel/patterns/program.h"
#if !defined(__cplusplus) && defined(KERNEL_RARE_PATTERNS)
#include "kernel/patterns/shader_normals.h"
#endif

KERNEL_BEGIN

/// A corner of a tetrahedron of radius 1.
FN vec3 tetrahedron_corner(uint i) {
    if (i == 0u) return vec3(0.0f, 1.0f, 0.0f);
    if (i == 1u) return vec3(0.942809042f, -0.333333333f, 0.0f);
    return vec3(-0.471404521f, -0.333333333f, i == 2u ? 0.816496581f : -0.816496581f);
}

/// The slope of a program's heights, the grey of its colours. Of an image, rightwards and upwards, a texel (`step_u`
/// and `step_v`): that of the plane through the texel itself and those to the left and right below it, as povray's
/// pictures show it. Else a fifteenth of twice the slope, by differences between the corners of a tetrahedron of radius
/// `step_u`.
FN real3 height_slope(SCENE uint program, PatternPoint at, bool image, float step_u, float step_v) {
    real3 p = at.position;
    real heights[4];
    uint count = image ? 3u : 4u;
    for (uint i = 0u; i < count; i = i + 1u) {
        real3 offset = real3(tetrahedron_corner(i)) * real(step_u);
        float beside = i == 0u ? 0.0f : i == 1u ? -step_u : step_u;
        if (image) offset = real3(vec3(beside, i == 0u ? 0.0f : -step_v, 0.0f));
        at.position = p + offset;
        heights[i] = gray_of(run_program_at(SCENE_ program, at).rgb);
    }
    if (image) {
        real rise = heights[0] - (heights[1] + heights[2]) * 0.5f;
        return real3((heights[2] - heights[1]) * 0.5f, rise, real(0.0f));
    }
    real3 sum = real3(real(0.0f));
    for (uint i = 0u; i < 4u; i = i + 1u) sum = sum + real3(tetrahedron_corner(i)) * heights[i];
    return sum * real(0.1f / step_u);
}

/// A slope rightwards and upwards on a surface of normal n (unit): the picture turns with the surface, as povray's
/// pictures show it, and stands upright.
FN real3 slope_on_surface(real3 slope, real3 n) {
    mask level = n.x * n.x + n.z * n.z < real(1e-12f);
    real3 right = normalize(real3(select(level, real(1.0f), -n.z), real(0.0f), select(level, real(0.0f), n.x)));
    return right * slope.x + cross(right, n) * slope.y;
}

/// Ripples (all of one wavelength, 1) or waves (each of another, the longer the steeper) from ten places near the
/// origin.
FN real3 rings_slope(real3 p, bool one_wavelength, float frequency, float phase) {
    real3 sum = real3(real(0.0f));
    for (uint i = 0u; i < 10u; i = i + 1u) {
        word hash = hash_word(word(i * 7919u + 101u));
        real3 from_source = p - random_vector(hash);
        real distance = max(length(from_source), real(1e-6f));
        float own = one_wavelength ? 1.0f : 0.2f + 0.08f * float(i);
        float amount = one_wavelength ? 0.08f : 0.125f;
        real height = sine(fraction(distance * (frequency * own) + phase) * 6.28318531f) * (amount / own);
        sum = sum + from_source * (height / distance);
    }
    return sum;
}

/// What a normal of kind `kind` adds to a unit normal at p, both in the pattern's space, for an amount of 1.
FN real3 normal_offset(SCENE uint kind, PatternPoint at, uint program, float first, float second) {
    bool image = kind == NORMAL_IMAGE;
    if (image || kind == NORMAL_PATTERN) return -height_slope(SCENE_ program, at, image, first, second);
    real3 p = at.position;
#ifdef __cplusplus
    if (kind == NORMAL_QUILTED || kind == NORMAL_FACETS) return ask_host(SCENE_ program, p, at, at.asking);
#elif defined(KERNEL_RARE_PATTERNS)
    if (FIELDS_HAVE(FIELD_QUILTED) && kind == NORMAL_QUILTED) return quilted_offset(p, first, second);
    if (FIELDS_HAVE(FIELD_FACETS) && kind == NORMAL_FACETS) return facets_offset(p, at.normal, first, second);
#endif
    if (kind == NORMAL_RIPPLES || kind == NORMAL_WAVES) return rings_slope(p, kind == NORMAL_RIPPLES, first, second);
    if (kind == NORMAL_BUMPS) return noise_vector(p) * real(0.97f);
    if (kind == NORMAL_DENTS) {
        real n = noise_value(p, program);
        return noise_vector(p) * (n * n * n * 1.13f);
    }
    real3 sum = real3(real(0.0f));  // wrinkles
    float scale = 1.0f;
    for (uint i = 0u; i < 10u; i = i + 1u) {
        sum = sum + abs(noise_vector(p * real(scale))) * real(1.01f / scale);
        scale = scale * 2.0f;
    }
    return sum;
}

/// The unit normal n, bent by the list of normals at `start` of the program code (NORMAL_WORDS each, see shared.h).
/// `at` and the columns of texture_from_world are where the texture lies.
FN_LARGE real3 perturbed_normal(SCENE uint start, PatternPoint at_point, vec3 texture_x, vec3 texture_y,
                                vec3 texture_z) {
    real3 n = at_point.normal;
    real3 point = at_point.position;
    real3 sum = real3(real(0.0f));
    uint count = AT(code, start);
    for (uint i = 0u; i < count; i = i + 1u) {
        uint at = start + 1u + i * NORMAL_WORDS;
        real weight = real(1.0f);
        real3 warped = point;
        // One place for both programs: shaders have a copy of all that programs may do for each place that runs one.
        for (uint k = 0u; k < 2u; k = k + 1u) {
            uint program = k == 0u ? AT(code, at) : AT(code, at + 25u);
            if (program == NONE || !any_lane(weight > real(0.0f))) continue;
            ProgramResult answer = run_whole_program(SCENE_ program, at_point);
            if (k == 0u) weight = answer.color.rgb.x;
            else warped = answer.point;
        }
        mask wanted = mask_and(at_point.asking, weight > real(0.0f));
        if (any_lane(wanted)) {
            real3 from_x = real3(code_vec3(SCENE_ at + 10u));
            real3 from_y = real3(code_vec3(SCENE_ at + 13u));
            real3 from_z = real3(code_vec3(SCENE_ at + 16u));
            real3 p = from_x * point.x + from_y * point.y + from_z * point.z + real3(code_vec3(SCENE_ at + 19u));
            uint octaves = AT(code, at + 9u);
            if (octaves > 0u) {
                real3 stirred = turbulence_vector(p, octaves, code_float(SCENE_ at + 7u), code_float(SCENE_ at + 8u));
                p = p + real3(code_vec3(SCENE_ at + 22u)) * stirred;
            }
            if (AT(code, at + 25u) != NONE) p = warped;
            PatternPoint placed = at_point;
            placed.position = p;
            placed.asking = wanted;
            // Normals go to the pattern's space by the inverse transposed of A = pattern_from_world, are made unit and
            // bent there and come back by the transposed: that is n + |A^-T n| A^T offset.
            real3 a_x = from_x * texture_x.x + from_y * texture_x.y + from_z * texture_x.z;
            real3 a_y = from_x * texture_y.x + from_y * texture_y.y + from_z * texture_y.z;
            real3 a_z = from_x * texture_z.x + from_y * texture_z.y + from_z * texture_z.z;
            uint kind = AT(code, at + 1u);
            real3 offset = normal_offset(SCENE_ kind, placed, AT(code, at + 4u), code_float(SCENE_ at + 5u),
                                         code_float(SCENE_ at + 6u)) *
                           real(code_float(SCENE_ at + 2u));
            real determinant = dot(a_x, cross(a_y, a_z));
            real3 inside = cross(a_y, a_z) * n.x + cross(a_z, a_x) * n.y + cross(a_x, a_y) * n.z;
            if (kind == NORMAL_IMAGE)
                offset = slope_on_surface(offset, normalize(select(determinant < real(0.0f), -inside, inside)));
            real3 back = real3(dot(a_x, offset), dot(a_y, offset), dot(a_z, offset));
            if (AT(code, at + 3u) == 2u) back = offset;
            if (AT(code, at + 3u) == 0u) back = back * (length(inside) / max(abs(determinant), real(1e-30f)));
            sum = sum + normalize(n + back) * weight;
        }
    }
    real length_squared = dot(sum, sum);
    return select(length_squared > real(1e-12f), sum * (1.0f / sqrt(max(length_squared, real(1e-12f)))), n);
}

KERNEL_END

#endif
