// SPDX-License-Identifier: Apache-2.0
// A matt surface (Lambert, Photometria, 1760). Vectors are local to the normal, unit, and point away from the surface.
#ifndef SUNDOG_KERNEL_BSDF_LAMBERT_H
#define SUNDOG_KERNEL_BSDF_LAMBERT_H

#include "kernel/bsdf/frame.h"

KERNEL_BEGIN

/// The BSDF of a white one.
FN real lambert_value() { return real(0.318309886f); }

FN real3 lambert_direction(real2 u) { return cosine_direction(u); }

FN real lambert_density(real3 to_light) { return max(to_light.z, real(0.0f)) * 0.318309886f; }

KERNEL_END

#endif
