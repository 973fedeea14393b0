// SPDX-License-Identifier: Apache-2.0
// Numbers of the kernel's functions, for kernel_calls.h and the tests that use it.
#ifndef SUNDOG_TESTS_PARITY_CALL_NUMBERS_H
#define SUNDOG_TESTS_PARITY_CALL_NUMBERS_H

#ifdef __cplusplus
#include "kernel/shared.h"
namespace sundog::kernel {
#define CALL_CONST constexpr
#else
#define CALL_CONST const
#endif

/// Arguments and results of a call.
CALL_CONST uint CALL_VALUES = 18u;
/// Calls in a row that share their uniform arguments.
CALL_CONST uint CALL_BATCH = 64u;

CALL_CONST uint CALL_LOG2 = 0u;
CALL_CONST uint CALL_EXP2 = 1u;
CALL_CONST uint CALL_POWER = 2u;
CALL_CONST uint CALL_ANGLE = 3u;
CALL_CONST uint CALL_HIT_ERROR = 4u;
CALL_CONST uint CALL_FIRST_SHAPE = 5u;
CALL_CONST uint CALL_SPHERE = 5u;
CALL_CONST uint CALL_BOX = 6u;
CALL_CONST uint CALL_PLANE = 7u;
CALL_CONST uint CALL_TRIANGLE = 8u;
CALL_CONST uint CALL_PLANES = 9u;
CALL_CONST uint CALL_SPHERE_UV = 10u;
CALL_CONST uint CALL_BOX_UV = 11u;
CALL_CONST uint CALL_PLANE_UV = 12u;
CALL_CONST uint CALL_INTERPOLATE = 13u;
CALL_CONST uint CALL_FIRST_REFLECTION = 14u;
CALL_CONST uint CALL_LAMBERT = 14u;
CALL_CONST uint CALL_MIRROR = 15u;
CALL_CONST uint CALL_PHONG = 16u;
CALL_CONST uint CALL_BLINN = 17u;
CALL_CONST uint CALL_REFRACT = 18u;
CALL_CONST uint CALL_FRESNEL = 19u;
CALL_CONST uint CALL_SCHLICK = 20u;
CALL_CONST uint CALL_LIGHT = 21u;
CALL_CONST uint CALL_FIRST_CAMERA = 22u;
CALL_CONST uint CALL_PINHOLE = 22u;
CALL_CONST uint CALL_PIXEL_SAMPLE = 23u;
CALL_CONST uint CALL_FIRST_PATTERN = 24u;
CALL_CONST uint CALL_CHECKER = 24u;
CALL_CONST uint CALL_WRAP = 25u;
CALL_CONST uint CALL_TEXTURE = 26u;
CALL_CONST uint CALL_FIRST_SURFACE = 27u;
CALL_CONST uint CALL_SURFACE = 27u;
CALL_CONST uint CALL_MATERIAL = 28u;
CALL_CONST uint CALL_BUMP = 29u;
CALL_CONST uint CALL_FIRST_PROCEDURAL = 30u;
CALL_CONST uint CALL_SINE = 30u;
CALL_CONST uint CALL_FIELD = 31u;
CALL_CONST uint CALL_WAVE = 32u;
CALL_CONST uint CALL_CHOICE = 33u;
CALL_CONST uint CALL_IMAGE_POSITION = 34u;
CALL_CONST uint CALL_LIGHT_SHARE = 35u;
CALL_CONST uint CALL_AREA_LIGHT = 36u;
CALL_CONST uint CALL_FOG = 37u;
CALL_CONST uint CALL_LAYER = 38u;
CALL_CONST uint CALL_PROJECTION = 39u;
CALL_CONST uint CALL_NORMAL = 40u;
CALL_CONST uint CALL_PHASE = 41u;
CALL_CONST uint CALL_COUNT = 42u;

/// Arguments that are the same for all rays.
struct UniformValues {
    float v[CALL_VALUES];
};

#ifdef __cplusplus
}  // namespace sundog::kernel
#endif
#undef CALL_CONST
#endif
