// SPDX-License-Identifier: Apache-2.0
// Participating media: what particles in the air or in an object absorb, emit and scatter (POV-Ray's reference, section
// 3.4.8 "Media"). CPU only.
#ifndef SUNDOG_KERNEL_ATMOSPHERE_MEDIA_H
#define SUNDOG_KERNEL_ATMOSPHERE_MEDIA_H

#include "kernel/atmosphere/media_insides.h"
#include "kernel/patterns/program.h"

KERNEL_BEGIN

/// Rays that hit nothing are followed through media as far as this, as povray does.
const float MEDIA_FAR = 1.0e7f;
/// Most particles of different kinds at one place that scatter light.
const uint MAX_SCATTERERS = 6u;
/// Most halvings of a step.
const uint MAX_HALVINGS = 8u;

/// How densely rays through media are sampled: the finest of what the media at hand ask for.
struct MediaSampling {
    uint steps;     ///< Equal steps along a ray, or between its boundaries.
    uint halvings;  ///< How often a step is halved where its ends differ by more than `threshold`.
    float threshold;
    bool exact_steps;  ///< Steps dim their own light (methods 1 and 2); method 3 counts it whole.
    bool varies;       ///< Somewhere, density depends on the place.
    bool scatters;
};

/// What media do to light at a point, per unit of length.
struct MediaPoint {
    real3 extinction;  ///< The share that is absorbed or scattered away.
    real3 glow;        ///< Radiance that is added.
};

/// Particles that scatter light, gathered at a point.
struct Scatterers {
    uint count;
    uint type[MAX_SCATTERERS];
    float eccentricity[MAX_SCATTERERS];
    real3 color[MAX_SCATTERERS];  ///< Per unit of length; black in lanes that don't have them.
};

/// Takes the needs of a list of media into account.
FN void add_sampling(SCENE uint list, INOUT(MediaSampling) sampling) {
    uint count = AT(code, list);
    for (uint i = 0u; i < count; i = i + 1u) {
        uint at = list + 13u + i * MEDIUM_WORDS;
        vec3 scattering = code_vec3(SCENE_ at + 6u);
        bool scatters = max(abs(scattering.x), max(abs(scattering.y), abs(scattering.z))) > 0.0f;
        uint steps = AT(code, at + 14u);
        if (scatters) steps = steps * AT(code, at + 18u);
        sampling.steps = max(sampling.steps, steps);
        if (AT(code, at + 15u) != 3u) sampling.exact_steps = true;
        sampling.halvings = max(sampling.halvings, min(AT(code, at + 16u), MAX_HALVINGS));
        sampling.threshold = min(sampling.threshold, code_float(SCENE_ at + 17u));
        if (AT(code, at + 12u) > 0u) sampling.varies = true;
        if (scatters) sampling.scatters = true;
    }
}

/// What the lanes of `active` need together.
FN MediaSampling media_sampling(SCENE MediaInsides insides, bool atmosphere, mask active) {
    MediaSampling sampling;
    sampling.steps = 1u;
    sampling.halvings = 0u;
    sampling.threshold = 1.0f;
    sampling.exact_steps = false;
    sampling.varies = false;
    sampling.scatters = false;
    if (atmosphere) add_sampling(SCENE_ FRAME.atmosphere, sampling);
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u) {
        mask todo = mask_and(active, insides.entry[i] < word(MEDIUM_SOLID));
        while (any_lane(todo)) {
            uint list = first_lane(todo, insides.entry[i]);
            todo = mask_and(todo, mask_not(insides.entry[i] == word(list)));
            add_sampling(SCENE_ list, sampling);
        }
    }
    return sampling;
}

/// Adds what a list of media does at p in the lanes of `here`.
FN_LARGE void add_media(SCENE uint list, real3 p, mask here, INOUT(MediaPoint) point, INOUT(Scatterers) scatterers) {
    uint count = AT(code, list);
    real3 placed = real3(code_vec3(SCENE_ list + 1u)) * p.x + real3(code_vec3(SCENE_ list + 4u)) * p.y +
                   real3(code_vec3(SCENE_ list + 7u)) * p.z + real3(code_vec3(SCENE_ list + 10u));
    real3 black = real3(real(0.0f));
    for (uint i = 0u; i < count; i = i + 1u) {
        uint at = list + 13u + i * MEDIUM_WORDS;
        real3 density = real3(real(1.0f));
        uint programs = AT(code, at + 13u);
        for (uint d = 0u; d < AT(code, at + 12u); d = d + 1u)
            density = density * run_program(SCENE_ AT(code, programs + d), placed).rgb;
        density = select(here, density, black);
        real3 scattered = density * real3(code_vec3(SCENE_ at + 6u));
        point.extinction =
            point.extinction + density * real3(code_vec3(SCENE_ at)) + scattered * real(code_float(SCENE_ at + 9u));
        point.glow = point.glow + density * real3(code_vec3(SCENE_ at + 3u));
        vec3 scattering = code_vec3(SCENE_ at + 6u);
        if (max(abs(scattering.x), max(abs(scattering.y), abs(scattering.z))) > 0.0f &&
            scatterers.count < MAX_SCATTERERS) {
            scatterers.type[scatterers.count] = AT(code, at + 11u);
            scatterers.eccentricity[scatterers.count] = code_float(SCENE_ at + 10u);
            scatterers.color[scatterers.count] = scattered;
            scatterers.count = scatterers.count + 1u;
        }
    }
}

/// All media at p, without the light that they scatter.
FN MediaPoint media_at(SCENE real3 p, MediaInsides insides, bool atmosphere, mask active, OUT(Scatterers) scatterers) {
    MediaPoint point;
    point.extinction = real3(real(0.0f));
    point.glow = real3(real(0.0f));
    scatterers.count = 0u;
    if (atmosphere) add_media(SCENE_ FRAME.atmosphere, p, active, point, scatterers);
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u) {
        mask todo = mask_and(active, insides.entry[i] < word(MEDIUM_SOLID));
        while (any_lane(todo)) {
            uint list = first_lane(todo, insides.entry[i]);
            mask here = mask_and(todo, insides.entry[i] == word(list));
            todo = mask_and(todo, mask_not(here));
            add_media(SCENE_ list, p, here, point, scatterers);
        }
    }
    return point;
}

/// e to the power of -x, for each channel.
FN real3 dimmed_by(real3 x) {
    return real3(exp2_clamped(x.x * -1.44269504f), exp2_clamped(x.y * -1.44269504f), exp2_clamped(x.z * -1.44269504f));
}

/// The lanes of `alive` in which there are any media.
FN mask in_media(MediaInsides insides, bool atmosphere, mask alive) {
    mask somewhere = mask(atmosphere);
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
        somewhere = mask_or(somewhere, insides.entry[i] < word(MEDIUM_SOLID));
    return mask_and(mask_and(alive, somewhere), mask_not(in_solid(insides)));
}

/// Share of light, per channel, that gets through media over `distance` along a ray.
FN_LARGE real3 media_transmittance(SCENE Ray ray, real distance, MediaInsides insides, bool with_atmosphere,
                                   mask alive) {
    bool atmosphere = with_atmosphere && FRAME.atmosphere != NONE;
    mask active = in_media(insides, atmosphere, alive);
    real3 white = real3(real(1.0f));
    if (!any_lane(active)) return white;
    MediaSampling sampling = media_sampling(SCENE_ insides, atmosphere, active);
    real reach = min(select(active, distance, real(0.0f)), real(MEDIA_FAR));
    uint steps = sampling.varies ? sampling.steps : 1u;
    real step = reach * (1.0f / float(steps));
    real3 depth = real3(real(0.0f));
    Scatterers scatterers;
    for (uint i = 0u; i < steps; i = i + 1u) {
        real3 p = ray.origin + ray.direction * (step * (float(i) + 0.5f));
        depth = depth + media_at(SCENE_ p, insides, atmosphere, active, scatterers).extinction * step;
    }
    return select(active, dimmed_by(depth), white);
}

KERNEL_END

#endif
