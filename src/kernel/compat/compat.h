// SPDX-License-Identifier: Apache-2.0
// The language that kernel headers are written in: the subset that C++20 and GLSL 4.60 share, over lanes.
//
// Varying values (one per ray) have the types real, real2, real3, word (32 bits, unsigned) and mask; the C++ side
// compiles them for 1, 4, 8 or 16 rays at a time (SUNDOG_KERNEL_LANES), GLSL for one. Uniform values (the same for all
// rays: lights, frame parameters, loop counters) are float, vec2, vec3, uint and int; they widen by themselves.
// - Branch on varying values with select(mask, a, b); `if` and loops take uniform conditions, any_lane(mask) among
// them.
// - mask_and, mask_or, mask_not combine masks.
// - Where lanes meet different programs or finishes, loop over those at hand with first_lane(mask, index), which makes
// a
//   uniform value of one lane's, and take the lanes that share it off the mask.
// - FN starts a function, FN_LARGE one that is called from several places and not worth a copy in each; OUT(T),
// INOUT(T) its output parameters.
// - SCENE is a function's first parameter where it reads the scene, SCENE_ the argument that passes it on.
// - AT(array, i): element at a uniform index. FIELD(array, i, field), GET(array, i): at a varying one, which must be
//   valid in every lane, active or not: valid_index(mask, i) makes it so.
// - FRAME.x: a frame parameter. FEATURE(bits): whether the scene needs any of these FEATURE_* bits.
//   WANTS_AOV(bits): whether the frame wants any of these AOV_* bits. INTEGRATOR_IS(number): whether it is this one.
//   PROGRAMS_HAVE(OP_*), FIELDS_HAVE(FIELD_*): whether pigments' programs may; PROGRAMS_HAVE_ANY: any of three OP_*.
// - KERNEL_MEDIA: defined where there is code for participating media; KERNEL_RARE_PATTERNS: for patterns of OP_RARE.
// - Float literals end in f. No references, pointers, recursion, templates, default arguments.
#ifdef __cplusplus
#include "kernel/compat/cpp.h"
#else
#include "kernel/compat/glsl.h"
#endif
