// SPDX-License-Identifier: Apache-2.0
// What integrators keep of a path of rays.
#ifndef SUNDOG_KERNEL_INTEGRATORS_PATH_H
#define SUNDOG_KERNEL_INTEGRATORS_PATH_H

#include "kernel/atmosphere/media_insides.h"
#include "kernel/materials/interior.h"
#include "kernel/materials/reflection.h"
#include "kernel/materials/surface.h"

KERNEL_BEGIN

/// A ray still to be followed, and how much of its radiance counts.
struct PathState {
    Ray ray;
    real3 weight;
    word depth;  ///< Surfaces before it on its path, in DEPTH_UNITS.
    word kind;   ///< RAY_CAMERA, or RAY_REFLECTED from the first mirror on.
    mask alive;
    Insides insides;     ///< What it is inside of, as far as that is known.
    MediaInsides media;  ///< If FEATURE_HOLLOW: of what its origin is inside, whose media it passes.
#ifdef __cplusplus
    real spectrum;  ///< If FEATURE_DISPERSION: its place there, 0 (violet) to 1 (red); negative: all colours.
    uint nesting;   ///< How many path_radiance() are under way around this one.
#endif
};

/// If RECORDING: what a path remembers, so that points of the picture can be told alike (sampling/traced_grid.h).
struct PathRecord {
    word signature;   ///< Of the objects that were met, in their order, and the lights that lit each.
    word highlights;  ///< Of the lights whose highlights show on each.
    word unlike;      ///< Not 0: nothing is like it.
    word outline;     ///< Of what the eye sees itself; 0: nothing.
    word surface;     ///< Not 0: the first surface is textured, and this is its number.
    real beyond;      ///< Luminance that came by way of further surfaces.
    real3 shade;      ///< What the first surface's texture (FirstHit::albedo) is multiplied by.
    real3 rest;       ///< What is added to that.
};

/// What the primary ray found, for AOVs (a miss where FrameParams::aovs is 0).
struct FirstHit {
    real t;
    real3 normal;
    real3 albedo;
    word geometry, primitive, material;
};

/// A miss, for paths that have met nothing yet.
FN FirstHit nothing_met() {
    FirstHit first;
    first.t = real(3.0e38f);
    first.normal = real3(real(0.0f));
    first.albedo = real3(real(0.0f));
    first.geometry = word(NONE);
    first.primitive = word(NONE);
    first.material = word(NONE);
    return first;
}

/// A colour in the scene's numbers as linear light.
FN real3 linear_light(SCENE real3 color) {
    if (FRAME.working_gamma == 1.0f) return color;
    color = max(color, real3(real(0.0f)));
    if (FRAME.working_gamma > 0.0f) {
        real gamma = real(FRAME.working_gamma);
        return real3(power(color.x, gamma), power(color.y, gamma), power(color.z, gamma));
    }
    return real3(srgb_decoded(color.x), srgb_decoded(color.y), srgb_decoded(color.z));
}

/// The ray off a mirror at a surface.
FN Ray mirrored_ray(Surface s, real3 incoming) {
    Ray ray;
    ray.direction = mirror_direction(incoming, s.normal);
    // A smoothed normal can mirror a ray into the face: lift it out along the face's own normal.
    real into = dot(ray.direction, s.geometric_normal);
    real3 lifted = ray.direction - s.geometric_normal * (2.0f * into);
    ray.direction = select(into < real(0.0f), lifted, ray.direction);
    ray.origin = s.position + s.geometric_normal * s.error;
    ray.t_min = real(0.0f);
    ray.t_max = real(3.0e38f);
    return ray;
}

KERNEL_END

#endif
