// SPDX-License-Identifier: Apache-2.0
// Rays whose radiance is needed by itself before it can be added up: C++ only, for they recurse.
#ifndef SUNDOG_KERNEL_INTEGRATORS_NESTED_H
#define SUNDOG_KERNEL_INTEGRATORS_NESTED_H

#include "kernel/integrators/path.h"
#include "kernel/lights/shadow.h"

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

/// Share of a colour's light between the violet end of the spectrum and a place in it, 0 to 1: a parabola around
/// `middle`. The parabolas were fitted to povray's pictures.
FN float spectrum_share(float place, float middle, float reach) {
    float x = min(max((place - middle) / reach, -1.0f), 1.0f);
    return 0.5f + 0.75f * x - 0.25f * x * x * x;
}

/// The same of red, green and blue.
FN vec3 spectrum_shares(float place) {
    float red = 0.959f * spectrum_share(place, 0.783f, 0.24f) + 0.041f * spectrum_share(place, 0.078f, 0.097f);
    return vec3(red, spectrum_share(place, 0.582f, 0.26f), spectrum_share(place, 0.258f, 0.279f));
}

/// The colour of sample `index` of `count` that the spectrum is cut into; they add up to white.
FN vec3 spectrum_color(uint index, uint count) {
    vec3 before = index == 0u ? vec3(0.0f) : spectrum_shares(float(index) / float(count));
    vec3 after = index + 1u == count ? vec3(1.0f) : spectrum_shares(float(index + 1u) / float(count));
    return after - before;
}

/// Which lanes of `transmits` pass into or out of what disperses light.
FN mask disperses(SCENE Surface s, Lobes lobes, mask transmits) {
    word interior = interior_of(SCENE_ s, mask_and(transmits, lobes.patterned));
    return mask_and(transmits, abs(FIELD(interiors, interior, dispersion) - 1.0f) > real(0.0f));
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
