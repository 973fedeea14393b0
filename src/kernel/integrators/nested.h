// SPDX-License-Identifier: Apache-2.0
// Rays whose radiance is needed by itself before it can be added up: C++ only, for they recurse.
#ifndef SUNDOG_KERNEL_INTEGRATORS_NESTED_H
#define SUNDOG_KERNEL_INTEGRATORS_NESTED_H

#include "kernel/integrators/path.h"
#include "kernel/integrators/surface_met.h"
#include "kernel/lights/shadow.h"
#include "kernel/materials/spectrum.h"

KERNEL_BEGIN

/// What comes back along the ray of `path`, times its weight: path_radiance() from within itself.
inline real3 nested_radiance(SCENE PathState path, INOUT(RayCounts) counts);

/// Most calls of path_radiance() around one another: what lies deeper is neither dispersed nor bent by exponents.
const uint MAX_NESTING = 12u;

/// What the mirrors in the lanes of `bent` add to a path: radiance to the power of one over the finish's exponent,
/// as povray's pictures show it.
FN_LARGE real3 exponent_radiance(SCENE PathState path, Surface s, Lobes lobes, mask bent, INOUT(RayCounts) counts) {
    real3 weight = path.weight * lobes.reflectance;
    PathState mirrored = path;
    mirrored.ray = mirrored_ray(s, path.ray.direction);
    mirrored.weight = real3(real(1.0f));
    mirrored.depth = path.depth + word(DEPTH_UNITS);
    mirrored.kind = word(RAY_REFLECTED);
    mirrored.alive = bent;
    real3 black = real3(real(0.0f));
    real3 seen = max(nested_radiance(SCENE_ mirrored, counts), black);
    real per_exponent = 1.0f / lobes.exponent;
    real3 answer = real3(power(seen.x, per_exponent), power(seen.y, per_exponent), power(seen.z, per_exponent));
    return select(bent, weight * answer, black);
}

/// What passes through the surface in the lanes of `split`, one colour after the other.
FN_LARGE real3 dispersed_radiance(SCENE PathState path, Surface s, Lobes lobes, Crossing crossing, mask split,
                                  INOUT(RayCounts) counts) {
    real3 black = real3(real(0.0f));
    real3 sum = black;
    word interior = interior_of(SCENE_ s, split);
    PathState ray = path;
    ray.depth = path.depth + word(DEPTH_UNITS);
    Ray mirrored = mirrored_ray(s, path.ray.direction);
    MediaInsides beyond = path.media;
    if (FEATURE(FEATURE_HOLLOW)) beyond = media_beyond(SCENE_ s, beyond, split);
    mask todo = split;
    while (any_lane(todo)) {
        uint number = first_lane(todo, interior);
        mask here = mask_and(todo, interior == word(number));
        todo = mask_and(todo, mask_not(here));
        uint samples = AT(interiors, number).dispersion_samples;
        for (uint i = 0u; i < samples; i = i + 1u) {
            real place = real((float(i) + 0.5f) / float(samples));
            real eta = crossing_eta(SCENE_ crossing, interior, path.insides, place);
            real3 refracted;
            mask passes = refract_direction(path.ray.direction, s.normal, eta, refracted);
            // A colour may be thrown back where the others are not.
            ray.ray = mirrored;
            ray.ray.direction = select(passes, normalize(refracted), mirrored.direction);
            ray.ray.origin = select(passes, s.position - s.geometric_normal * s.error, mirrored.origin);
            ray.insides.inner = select(passes, crossing.behind.inner, path.insides.inner);
            ray.insides.outer = select(passes, crossing.behind.outer, path.insides.outer);
            for (uint k = 0u; k < MAX_MEDIA_INSIDES; k = k + 1u)
                ray.media.entry[k] = select(passes, beyond.entry[k], path.media.entry[k]);
            ray.weight = path.weight * lobes.transmittance * real3(spectrum_color(i, samples));
            ray.spectrum = place;
            ray.alive = here;
            sum = sum + select(here, nested_radiance(SCENE_ ray, counts), black);
        }
    }
    return sum;
}

KERNEL_END

#endif
