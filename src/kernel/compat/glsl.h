// SPDX-License-Identifier: Apache-2.0
// The GLSL side of compat.h: one ray an invocation. The including shader declares, before any kernel function, the
// buffers of kernel/arrays.h, a FrameParams named `frame`, and specialization constants `frame_features`,
// `frame_aovs`, `frame_integrator`, `program_ops` and `program_fields`. With SUNDOG_MEDIA, the shader draws
// participating media, with SUNDOG_RARE_PATTERNS patterns that few scenes have.
#ifndef SUNDOG_KERNEL_COMPAT_GLSL_H
#define SUNDOG_KERNEL_COMPAT_GLSL_H

#define KERNEL_BEGIN
#define KERNEL_END
#define FN
#define FN_LARGE
#define FN_RECURSIVE
#define OUT(T) out T
#define INOUT(T) inout T
#define LARGE(T) T
#define SCENE
#define SCENE_
#define FRAME frame
#define FEATURE(bits) ((frame_features & (bits)) != 0u)
#define WANTS_AOV(bits) ((frame_aovs & (bits)) != 0u)
#define RECORDING false
#define INTEGRATOR_IS(number) (frame_integrator == (number))
#define PROGRAMS_HAVE(op) ((program_ops & (1u << (op))) != 0u)
// Not by PROGRAMS_HAVE: of three constants in an "or", glslang makes code that no driver takes.
#define PROGRAMS_HAVE_ANY(a, b, c) ((program_ops & ((1u << (a)) | (1u << (b)) | (1u << (c)))) != 0u)
#define FIELDS_HAVE(kind) ((program_fields & (1u << (kind))) != 0u)
#ifdef SUNDOG_MEDIA
#define KERNEL_MEDIA
#endif
#ifdef SUNDOG_RARE_PATTERNS
#define KERNEL_RARE_PATTERNS
#endif
#define AT(array, i) array[i]
#define FIELD(array, i, field) array[i].field
#define GET(array, i) array[i]

#define real float
#define real2 vec2
#define real3 vec3
#define word uint
#define mask bool

bool mask_and(bool a, bool b) { return a && b; }
bool mask_or(bool a, bool b) { return a || b; }
bool mask_not(bool a) { return !a; }
bool select_mask(bool m, bool a, bool b) { return m ? a : b; }
bool any_lane(bool m) { return m; }
bool all_lanes(bool m) { return m; }
uint valid_index(bool m, uint i) { return m ? i : 0u; }
uint first_lane(bool m, uint i) { return i; }
float uniform_float(uint bits) { return uintBitsToFloat(bits); }
uint as_word(float x) { return floatBitsToUint(x); }
float as_real(uint x) { return uintBitsToFloat(x); }
uint word_from_real(float x) { return uint(int(x)); }
float real_from_word(uint x) { return float(int(x)); }
float select(bool m, float a, float b) { return m ? a : b; }
uint select(bool m, uint a, uint b) { return m ? a : b; }
vec2 select(bool m, vec2 a, vec2 b) { return m ? a : b; }
vec3 select(bool m, vec3 a, vec3 b) { return m ? a : b; }

#endif
