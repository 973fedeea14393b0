// SPDX-License-Identifier: Apache-2.0
// Directions around a normal: local frames, and directions drawn over the hemisphere.
#ifndef SUNDOG_KERNEL_BSDF_FRAME_H
#define SUNDOG_KERNEL_BSDF_FRAME_H

#include "kernel/math.h"

KERNEL_BEGIN

/// Three unit vectors across each other.
struct ShadingFrame {
    real3 x, y, z;
};

/// A frame whose z is a unit vector (Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017).
FN ShadingFrame frame_around(real3 z) {
    real sign = select(z.z < real(0.0f), real(-1.0f), real(1.0f));
    real a = -1.0f / (sign + z.z);
    real b = z.x * z.y * a;
    ShadingFrame basis;
    basis.x = real3(1.0f + sign * z.x * z.x * a, sign * b, -sign * z.x);
    basis.y = real3(b, sign + z.y * z.y * a, -z.y);
    basis.z = z;
    return basis;
}

FN real3 to_local(ShadingFrame basis, real3 v) { return real3(dot(basis.x, v), dot(basis.y, v), dot(basis.z, v)); }
FN real3 to_world(ShadingFrame basis, real3 v) { return basis.x * v.x + basis.y * v.y + basis.z * v.z; }

/// A direction over the hemisphere around z, by the cosine to it: its density is that cosine over pi.
FN real3 cosine_direction(real2 u) {
    real radius = sqrt(u.x);
    real angle = u.y * 6.28318531f;
    return real3(radius * cosine(angle), radius * sine(angle), sqrt(max(1.0f - u.x, real(0.0f))));
}

/// How much a sample that was drawn with density `own` counts, where another way of drawing it has density `other`
/// (Veach 1997, section 9.2.2: the power heuristic).
FN real power_heuristic(real own, real other) {
    // Densities of tiny lights are large: their squares need not fit.
    real ratio = other / max(own, real(1e-30f));
    return 1.0f / (1.0f + ratio * ratio);
}

KERNEL_END

#endif
