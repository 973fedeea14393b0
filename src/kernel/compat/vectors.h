// SPDX-License-Identifier: Apache-2.0
// GLSL's vector functions for C++, for uniform vec3 and, where it is another type, varying real3. Included by cpp.h
// alone.
#pragma once

KERNEL_BEGIN

#define SUNDOG_KERNEL_VEC3_FUNCTIONS(V, S)                                                                  \
    FN V operator+(V a, V b) { return V(a.x + b.x, a.y + b.y, a.z + b.z); }                                 \
    FN V operator-(V a, V b) { return V(a.x - b.x, a.y - b.y, a.z - b.z); }                                 \
    FN V operator*(V a, V b) { return V(a.x * b.x, a.y * b.y, a.z * b.z); }                                 \
    FN V operator*(V a, S s) { return V(a.x * s, a.y * s, a.z * s); }                                       \
    FN V operator*(S s, V a) { return V(a.x * s, a.y * s, a.z * s); }                                       \
    FN V operator-(V a) { return V(-a.x, -a.y, -a.z); }                                                     \
    FN S dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }                                        \
    FN V cross(V a, V b) { return V(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); } \
    FN V min(V a, V b) { return V(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)); }                           \
    FN V max(V a, V b) { return V(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)); }                           \
    FN V abs(V a) { return V(abs(a.x), abs(a.y), abs(a.z)); }                                               \
    FN S length(V a) { return sqrt(dot(a, a)); }                                                            \
    FN V normalize(V a) { return a * (S(1.0f) / sqrt(dot(a, a))); }                                         \
    FN S clamp(S x, S low, S high) { return min(max(x, low), high); }                                       \
    FN S mix(S a, S b, S t) { return a * (S(1.0f) - t) + b * t; }                                           \
    FN V mix(V a, V b, S t) { return a * (S(1.0f) - t) + b * t; }

SUNDOG_KERNEL_VEC3_FUNCTIONS(real3, real)
#if SUNDOG_KERNEL_LANES != 1
SUNDOG_KERNEL_VEC3_FUNCTIONS(vec3, float)
#endif
#undef SUNDOG_KERNEL_VEC3_FUNCTIONS

FN real3 select(mask m, real3 a, real3 b) {
    return real3(select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z));
}
FN real2 operator+(real2 a, real2 b) { return real2(a.x + b.x, a.y + b.y); }
FN real2 operator-(real2 a, real2 b) { return real2(a.x - b.x, a.y - b.y); }
FN real2 operator*(real2 a, real2 b) { return real2(a.x * b.x, a.y * b.y); }
FN real2 operator*(real2 a, real s) { return real2(a.x * s, a.y * s); }
FN real2 select(mask m, real2 a, real2 b) { return real2(select(m, a.x, b.x), select(m, a.y, b.y)); }

KERNEL_END
