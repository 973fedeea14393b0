// SPDX-License-Identifier: Apache-2.0
// Light that diffuses below a surface, as if from a source in it and one above it (Jensen, Marschner, Levoy and
// Hanrahan, A Practical Model for Subsurface Light Transport, SIGGRAPH 2001, section 2.2).
#ifndef SUNDOG_KERNEL_BSDF_DIPOLE_H
#define SUNDOG_KERNEL_BSDF_DIPOLE_H

#include "kernel/math.h"

KERNEL_BEGIN

/// A medium, channel by channel.
struct Dipole {
    real3 albedo;  ///< Reduced: of light that meets something, the share that is scattered.
    real3 depth;   ///< Of the source in it: the mean free path.
    real3 height;  ///< Of the source above it.
    real3 fading;  ///< Effective transport coefficient, per unit of length.
};

/// e to the power of -x.
FN real exp_negative(real x) { return exp2_clamped(x * -1.44269504f); }

/// The boundary's factor A of the paper's section 2.2, for an index of refraction of the inside over the outside.
/// Povray's pictures of the edges of shadows agree with the diffuse reflectance of the boundary for light from outside
/// (Egan and Hilgeman's fit, as in Donner and Jensen 2005), which is much less than that for light from inside: 1.2
/// for 1.5, not 3.3.
FN real dipole_boundary(real ior) {
    real n = clamp(ior, real(1.0f), real(3.0f));
    real reflectance = max(-0.4399f + n * (0.7099f + n * (-0.3319f + n * 0.0636f)), real(0.0f));
    return (1.0f + reflectance) / (1.0f - reflectance);
}

/// Total diffuse reflectance (Jensen and Buhler 2002: its integral over the plane) where the product of
/// the transport coefficient and the mean free path is `fading`.
FN real dipole_total(real fading, real boundary) {
    real albedo = 1.0f - fading * fading * 0.333333333f;
    return albedo * 0.5f * (1.0f + exp_negative(fading * boundary * 1.33333333f)) * exp_negative(fading);
}

/// The product for which dipole_total() is this reflectance. Halved in turns: the total only falls.
FN real dipole_fading(real reflectance, real boundary) {
    real low = real(0.0f);
    real high = real(1.73205081f);
    for (uint i = 0u; i < 20u; i = i + 1u) {
        real middle = (low + high) * 0.5f;
        mask above = dipole_total(middle, boundary) > reflectance;
        low = select(above, middle, low);
        high = select(above, high, middle);
    }
    return (low + high) * 0.5f;
}

/// The medium that reflects this much diffusely in all, and in which light goes `scattering_length` before it is
/// scattered, whatever is absorbed.
FN Dipole dipole_of(real3 reflectance, real3 scattering_length, real ior) {
    // No medium reflects all; black ones let nothing come to be scattered.
    real3 r = min(max(reflectance, real3(real(1e-4f))), real3(real(0.999f)));
    real boundary = dipole_boundary(ior);
    real3 f = real3(dipole_fading(r.x, boundary), dipole_fading(r.y, boundary), dipole_fading(r.z, boundary));
    Dipole dipole;
    dipole.albedo = max(real3(real(1.0f)) - f * f * 0.333333333f, real3(real(1e-4f)));
    dipole.depth = scattering_length * dipole.albedo;
    dipole.height = dipole.depth * (1.0f + boundary * 1.33333333f);
    dipole.fading = real3(f.x / dipole.depth.x, f.y / dipole.depth.y, f.z / dipole.depth.z);
    return dipole;
}

/// What one of the two sources brings to a place of the surface; `square` is that of the distance to the place over or
/// under which it stands, at `off`.
FN real dipole_source(real off, real fading, real square) {
    real way2 = square + off * off;
    real way = sqrt(way2);
    real faded = fading * way;
    return off * (1.0f + faded) * exp_negative(faded) / max(way2 * way, real(1e-37f));
}

/// Diffuse reflectance from a place to another one: radiant exitance over incident flux, per area (equation 4).
FN real3 dipole_reflectance(Dipole d, real square) {
    return real3(d.albedo.x *
                     (dipole_source(d.depth.x, d.fading.x, square) + dipole_source(d.height.x, d.fading.x, square)),
                 d.albedo.y *
                     (dipole_source(d.depth.y, d.fading.y, square) + dipole_source(d.height.y, d.fading.y, square)),
                 d.albedo.z *
                     (dipole_source(d.depth.z, d.fading.z, square) + dipole_source(d.height.z, d.fading.z, square))) *
           0.0795774715f;
}

KERNEL_END

#endif
