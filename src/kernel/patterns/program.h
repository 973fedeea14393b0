// SPDX-License-Identifier: Apache-2.0
// Runs a pigment's program: the one switch that all procedural colours go through.
#ifndef SUNDOG_KERNEL_PATTERNS_PROGRAM_H
#define SUNDOG_KERNEL_PATTERNS_PROGRAM_H

#include "kernel/patterns/density_grid.h"
#include "kernel/patterns/fields.h"
#include "kernel/patterns/host.h"
#if !defined(__cplusplus) && defined(KERNEL_RARE_PATTERNS)
#include "kernel/patterns/shader_fields.h"
#include "kernel/patterns/shader_warps.h"
#endif
#include "kernel/patterns/texture.h"
#include "kernel/patterns/tiling.h"

KERNEL_BEGIN

/// Linear RGB, the share that passes tinted by it (filter), and the share that passes untinted (transmit).
struct PigmentColor {
    real3 rgb;
    real filtered;
    real transmitted;
};

FN PigmentColor no_color() {
    PigmentColor c;
    c.rgb = real3(real(0.0f));
    c.filtered = real(0.0f);
    c.transmitted = real(0.0f);
    return c;
}

/// sum + a colour of the program's words, weighted.
FN PigmentColor add_constant(SCENE PigmentColor sum, uint at, real weight) {
    sum.rgb = sum.rgb + real3(code_vec3(SCENE_ at)) * weight;
    sum.filtered = sum.filtered + weight * code_float(SCENE_ at + 3u);
    sum.transmitted = sum.transmitted + weight * code_float(SCENE_ at + 4u);
    return sum;
}

/// Share of a map's entry at position `at` for a value: it falls linearly to the neighbours' positions. The first and
/// the last entry name a neighbour beyond 0..1 and keep their share out there.
FN real entry_share(real value, float before, float at, float after) {
    mask rising = mask_and(value >= real(before), value < real(at));
    mask falling = mask_and(value >= real(at), value < real(after));
    float per_rise = at > before ? 1.0f / (at - before) : 0.0f;
    float per_fall = after > at ? 1.0f / (after - at) : 0.0f;
    real up = before < -1.0f ? real(1.0f) : (value - before) * per_rise;
    real down = after > 2.0f ? real(1.0f) : (after - value) * per_fall;
    return select(rising, up, select(falling, down, real(0.0f)));
}

/// Where a point of an image map falls on its picture, and whether there is one.
FN real2 image_position(uint map_type, real3 p) {
    if (map_type == 0u) return real2(p.x, p.y);
    real around = angle_of(p.z, p.x) * 0.159154943f;
    real u = select(around < real(0.0f), around + 1.0f, around);
    real radius = sqrt(p.x * p.x + p.z * p.z);
    if (map_type == 1u) return real2(u, angle_of(p.y, radius) * 0.318309886f + 0.5f);
    if (map_type == 2u) return real2(u, p.y);
    real tube = angle_of(p.y, radius - 1.0f) * 0.159154943f;  // toroidal: around a ring of radius 1
    return real2(u, select(tube < real(0.0f), tube + 1.0f, tube));
}

/// The texel that uv lies in; linear RGB and alpha.
FN real3 nearest_texel(SCENE uint texture, real2 uv, OUT(real) alpha) {
    TextureInfo info = AT(textures, texture);
    real w = real(float(info.width));
    real h = real(float(info.height));
    mask never = w < real(0.0f);
    word x = wrap_texel(floor(fraction(uv.x) * w), w, never);
    word y = wrap_texel(floor((1.0f - fraction(uv.y)) * h), h, mask_not(never));
    mask srgb = word(info.flags & TEXTURE_SRGB) != word(0u);
    return texel_at(SCENE_ word(info.first_texel), word(info.width), x, y, srgb, alpha);
}

FN PigmentColor image_color(SCENE uint at, real3 p) {
    uint texture = AT(code, at);
    uint flags = AT(code, at + 1u);
    uint map_type = AT(code, at + 2u);
    real2 uv = image_position(map_type, p);
    real alpha;
    PigmentColor c;
    if ((flags & IMAGE_SMOOTH) != 0u) {
        uint clamped = (flags & IMAGE_ONCE) != 0u ? TEXTURE_CLAMP : 0u;
        c.rgb = texture_lookup(SCENE_ word(texture), word(clamped), uv, alpha);
    } else {
        c.rgb = nearest_texel(SCENE_ texture, uv, alpha);
    }
    real opacity = alpha;
    c.filtered = real(code_float(SCENE_ at + 3u)) * opacity;
    c.transmitted = 1.0f - opacity * (1.0f - code_float(SCENE_ at + 4u));
    if ((flags & IMAGE_ONCE) != 0u) {
        mask outside = mask_or(mask_or(uv.x<real(0.0f), uv.x> real(1.0f)), mask_or(uv.y<real(0.0f), uv.y> real(1.0f)));
        c.rgb = select(outside, real3(real(0.0f)), c.rgb);
        c.filtered = select(outside, real(0.0f), c.filtered);
        c.transmitted = select(outside, real(1.0f), c.transmitted);
    }
    return c;
}

/// A point without a surface, asked for by all lanes.
FN PatternPoint free_point(real3 position) {
    PatternPoint at;
    at.position = position;
    at.normal = real3(real(0.0f));
    at.direction = real3(real(0.0f));
    at.world = position;
    at.asking = mask(true);
    return at;
}

/// What OP_GRAY takes of a colour.
FN real color_part(PigmentColor c, uint part) {
    if (part == 0u) return gray_of(c.rgb);
    if (part == 1u) return 1.0f - c.transmitted;
    if (part == 2u) return c.rgb.x;
    if (part == 3u) return c.rgb.y;
    if (part == 4u) return c.rgb.z;
    return part == 5u ? c.filtered : c.transmitted;
}

/// What a program leaves behind.
struct ProgramResult {
    PigmentColor color;  ///< Colour 0.
    real3 point;         ///< Point 1.
    real weight;         ///< What OP_WEIGHT says; 1 without it.
};

/// Runs the program at `start`.
FN_LARGE ProgramResult run_whole_program(SCENE uint start, PatternPoint at) {
    real3 points[PROGRAM_SLOTS];
    real values[PROGRAM_SLOTS];
    real shares[PROGRAM_SLOTS];
    mask asking[PROGRAM_SLOTS];
    PigmentColor colors[PROGRAM_SLOTS];
    points[0] = at.position;
    points[1] = at.position;
    colors[0] = no_color();
    asking[0] = at.asking;
    real weight = real(1.0f);
    uint pc = start;
    while (true) {
        uint instruction = AT(code, pc);
        uint op = instruction & 255u;
        uint target = (instruction >> 8u) & 255u;
        uint source = (instruction >> 16u) & 255u;
        uint source2 = instruction >> 24u;
        pc = pc + 1u;
        if (op == OP_END) break;
        if (PROGRAMS_HAVE(OP_SOLID) && op == OP_SOLID) {
            colors[target] = add_constant(SCENE_ no_color(), pc, real(1.0f));
            pc = pc + 5u;
        } else if (PROGRAMS_HAVE(OP_TRANSFORM) && op == OP_TRANSFORM) {
            real3 p = points[source];
            points[target] = real3(code_vec3(SCENE_ pc)) * p.x + real3(code_vec3(SCENE_ pc + 3u)) * p.y +
                             real3(code_vec3(SCENE_ pc + 6u)) * p.z + real3(code_vec3(SCENE_ pc + 9u));
            pc = pc + 12u;
        } else if (PROGRAMS_HAVE(OP_FIELD) && op == OP_FIELD) {
            values[target] = field_value(AT(code, pc), points[source], code_vec3(SCENE_ pc + 1u), AT(code, pc + 4u));
            pc = pc + 5u;
        } else if (PROGRAMS_HAVE(OP_WAVE) && op == OP_WAVE) {
            values[target] = wave_value(AT(code, pc), values[target], code_float(SCENE_ pc + 1u),
                                        code_float(SCENE_ pc + 2u), code_float(SCENE_ pc + 3u));
            pc = pc + 4u;
        } else if (PROGRAMS_HAVE(OP_MAP) && op == OP_MAP) {
            uint count = AT(code, pc);
            PigmentColor sum = no_color();
            for (uint i = 0u; i < count; i = i + 1u) {
                uint entry = pc + 1u + i * 6u;
                float before = -2.0f;
                if (i > 0u) before = code_float(SCENE_ entry - 6u);
                float after = 3.0f;
                if (i + 1u < count) after = code_float(SCENE_ entry + 6u);
                real share = entry_share(values[source], before, code_float(SCENE_ entry), after);
                if (any_lane(share > real(0.0f))) sum = add_constant(SCENE_ sum, entry + 1u, share);
            }
            colors[target] = sum;
            pc = pc + 1u + count * 6u;
        } else if (PROGRAMS_HAVE(OP_CHOICE) && op == OP_CHOICE) {
            values[target] =
                choice_value(AT(code, pc), points[source], code_vec3(SCENE_ pc + 1u), code_float(SCENE_ pc + 4u));
            pc = pc + 5u;
        } else if (PROGRAMS_HAVE(OP_PICK) && op == OP_PICK) {
            uint count = AT(code, pc);
            PigmentColor sum = no_color();
            for (uint i = 0u; i < count; i = i + 1u) {
                mask here = abs(values[source] - float(i)) < real(0.5f);
                if (any_lane(here))
                    sum = add_constant(SCENE_ sum, pc + 1u + i * 5u, select(here, real(1.0f), real(0.0f)));
            }
            colors[target] = sum;
            pc = pc + 1u + count * 5u;
        } else if (PROGRAMS_HAVE(OP_CLEAR) && op == OP_CLEAR) {
            colors[target] = no_color();
        } else if (PROGRAMS_HAVE(OP_BLEND) && (op == OP_ENTER_MAP || op == OP_ENTER_PICK || op == OP_ENTER_SHARE)) {
            real share;
            if (op == OP_ENTER_MAP) {
                share = entry_share(values[target], code_float(SCENE_ pc), code_float(SCENE_ pc + 1u),
                                    code_float(SCENE_ pc + 2u));
                pc = pc + 3u;
            } else if (op == OP_ENTER_PICK) {
                mask here = abs(values[target] - code_float(SCENE_ pc)) < real(0.5f);
                share = select(here, real(1.0f), real(0.0f));
                pc = pc + 1u;
            } else {
                share = real(code_float(SCENE_ pc));
                pc = pc + 1u;
            }
            mask wanted = mask_and(asking[target], share > real(0.0f));
            shares[target] = share;
            asking[target + 1u] = wanted;
            uint skip = AT(code, pc);
            pc = pc + 1u;
            if (!any_lane(wanted)) pc = pc + skip;
        } else if (PROGRAMS_HAVE(OP_BLEND) && op == OP_BLEND) {
            real share = shares[target];
            PigmentColor entry = colors[target + 1u];
            colors[target].rgb = colors[target].rgb + entry.rgb * share;
            colors[target].filtered = colors[target].filtered + entry.filtered * share;
            colors[target].transmitted = colors[target].transmitted + entry.transmitted * share;
        } else if (PROGRAMS_HAVE(OP_WEIGHT) && op == OP_WEIGHT) {
            weight = colors[0].rgb.x;
            asking[0] = mask_and(at.asking, weight > real(0.0f));
            if (!any_lane(asking[0])) break;
        } else if (PROGRAMS_HAVE(OP_GRAY) && op == OP_GRAY) {
            PigmentColor c = colors[source];
            values[target] = color_part(c, AT(code, pc));
            pc = pc + 1u;
        } else if (PROGRAMS_HAVE(OP_POWER) && op == OP_POWER) {
            real raised = power(values[target], real(code_float(SCENE_ pc)));
            values[target] = select(raised > real(1.0f), fraction(raised), raised);
            pc = pc + 1u;
        } else if (PROGRAMS_HAVE(OP_TILING) && op == OP_TILING) {
            values[target] = tiling_value(SCENE_ pc + 1u, points[source]);
            pc = pc + 1u + AT(code, pc);
        } else if (PROGRAMS_HAVE(OP_DENSITY) && op == OP_DENSITY) {
#ifdef __cplusplus
            values[target] = ask_host(SCENE_ AT(code, pc), points[source], at, asking[source2]).x;
#else
            values[target] = density_at(SCENE_ pc + 1u, points[source]);
#endif
            pc = pc + 7u + AT(code, pc + 6u);
#ifdef KERNEL_RARE_PATTERNS
        } else if (PROGRAMS_HAVE(OP_SHARED_FIELD) && op == OP_SHARED_FIELD) {
#ifdef __cplusplus
            values[target] = ask_host(SCENE_ AT(code, pc), points[source], at, asking[source2]).x;
#else
            values[target] = shader_field_value(SCENE_ AT(code, pc + 1u), pc + 3u, points[source], at);
#endif
            pc = pc + 3u + AT(code, pc + 2u);
        } else if (PROGRAMS_HAVE_ANY(OP_REPEAT, OP_BLACK_HOLE, OP_MAPPING) &&
                   (op == OP_REPEAT || op == OP_BLACK_HOLE || op == OP_MAPPING)) {
#ifdef __cplusplus
            points[target] = ask_host(SCENE_ AT(code, pc), points[source], at, asking[source2]);
#else
            points[target] = shader_warped_point(SCENE_ op, pc + 2u, points[source]);
#endif
            pc = pc + 2u + AT(code, pc + 1u);
        } else if (PROGRAMS_HAVE(OP_CRACKLE) && op == OP_CRACKLE) {
            values[target] = crackle_form_value(points[source], code_vec3(SCENE_ pc), code_float(SCENE_ pc + 3u),
                                                code_float(SCENE_ pc + 4u), AT(code, pc + 5u) != 0u);
            pc = pc + 6u;
#endif
#ifdef __cplusplus
        } else if (op == OP_HOST_FIELD) {
            values[target] = ask_host(SCENE_ AT(code, pc), points[source], at, asking[source2]).x;
            pc = pc + 1u;
#endif
        } else if (PROGRAMS_HAVE(OP_TURBULENCE) && op == OP_TURBULENCE) {
            uint how = AT(code, pc + 3u);
            points[target] = stirred_point(how >> 16u, points[source], code_vec3(SCENE_ pc), (how >> 8u) & 255u,
                                           code_float(SCENE_ pc + 4u), code_float(SCENE_ pc + 5u), how & 255u);
            pc = pc + 6u;
        } else if (PROGRAMS_HAVE(OP_IMAGE)) {  // OP_IMAGE
            colors[target] = image_color(SCENE_ pc, points[source]);
            pc = pc + 5u;
        }
    }
    ProgramResult result;
    result.color = colors[0];
    result.point = points[1];
    result.weight = weight;
    return result;
}

/// The colour that the program at `start` gives.
FN PigmentColor run_program_at(SCENE uint start, PatternPoint at) { return run_whole_program(SCENE_ start, at).color; }

/// The colour that the program at `start` gives for a point (in the pigment's space) that is on no surface.
FN PigmentColor run_program(SCENE uint start, real3 at_point) {
    return run_program_at(SCENE_ start, free_point(at_point));
}

KERNEL_END

#endif
