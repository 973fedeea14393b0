// SPDX-License-Identifier: Apache-2.0
// Participating media: what particles in the air or in an object absorb, emit and scatter (POV-Ray's reference, section
// 3.4.8 "Media").
#ifndef SUNDOG_KERNEL_ATMOSPHERE_MEDIA_H
#define SUNDOG_KERNEL_ATMOSPHERE_MEDIA_H

#include "kernel/atmosphere/majorants.h"
#include "kernel/atmosphere/media_group.h"
#include "kernel/patterns/noise.h"
#include "kernel/patterns/program.h"

KERNEL_BEGIN

/// Most particles of different kinds at one place that scatter light.
const uint MAX_SCATTERERS = 8u;
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
    real3 color[MAX_SCATTERERS];  ///< Per unit of length.
};

/// The density of the medium at `at` in `code`, at a point of its own space, per channel.
FN real3 medium_density(SCENE uint at, real3 placed) {
    real3 density = real3(real(1.0f));
    uint programs = AT(code, at + 13u);
    for (uint d = 0u; d < AT(code, at + 12u); d = d + 1u)
        density = density * run_program(SCENE_ AT(code, programs + d), placed).rgb;
    return density;
}

/// Where the media of a list have the point p.
FN real3 placed_in_media(SCENE uint list, real3 p) {
    return real3(code_vec3(SCENE_ list + 1u)) * p.x + real3(code_vec3(SCENE_ list + 4u)) * p.y +
           real3(code_vec3(SCENE_ list + 7u)) * p.z + real3(code_vec3(SCENE_ list + 10u));
}

/// All media at p, without the light that they scatter.
FN_LARGE MediaPoint media_at(SCENE MediaGroup group, real3 p, OUT(Scatterers) scatterers) {
    MediaPoint point;
    point.extinction = real3(real(0.0f));
    point.glow = real3(real(0.0f));
    scatterers.count = 0u;
    for (uint k = 0u; k < group.count; k = k + 1u) {
        uint list = group.list[k];
        real3 placed = placed_in_media(SCENE_ list, p);
        for (uint i = 0u; i < AT(code, list); i = i + 1u) {
            uint at = list + MEDIA_LIST_WORDS + i * MEDIUM_WORDS;
            real3 density = medium_density(SCENE_ at, placed);
            real3 scattered = density * real3(code_vec3(SCENE_ at + 6u));
            point.extinction =
                point.extinction + density * real3(code_vec3(SCENE_ at)) + scattered * real(code_float(SCENE_ at + 9u));
            point.glow = point.glow + density * real3(code_vec3(SCENE_ at + 3u));
            if (scatterers.count < MAX_SCATTERERS && not_black(code_vec3(SCENE_ at + 6u))) {
                scatterers.type[scatterers.count] = AT(code, at + 11u);
                scatterers.eccentricity[scatterers.count] = code_float(SCENE_ at + 10u);
                scatterers.color[scatterers.count] = scattered;
                scatterers.count = scatterers.count + 1u;
            }
        }
    }
    return point;
}

/// Extinction of media that are the same everywhere.
FN real3 even_extinction(SCENE MediaGroup group) {
    real3 extinction = real3(real(0.0f));
    for (uint k = 0u; k < group.count; k = k + 1u) {
        uint list = group.list[k];
        for (uint i = 0u; i < AT(code, list); i = i + 1u) {
            uint at = list + MEDIA_LIST_WORDS + i * MEDIUM_WORDS;
            extinction = extinction + real3(code_vec3(SCENE_ at)) +
                         real3(code_vec3(SCENE_ at + 6u)) * real(code_float(SCENE_ at + 9u));
        }
    }
    return extinction;
}

/// e to the power of -x, for each channel.
FN real3 dimmed_by(real3 x) {
    return real3(exp2_clamped(x.x * -1.44269504f), exp2_clamped(x.y * -1.44269504f), exp2_clamped(x.z * -1.44269504f));
}

/// Share of light that gets through a group's media over `reach` of a ray, by ratio tracking (Novak et al., Residual
/// Ratio Tracking, SIGGRAPH Asia 2014): right on average, for any density. Its numbers come from the ray's own.
FN real3 tracked_transmittance(SCENE MediaGroup group, Ray ray, real reach, mask here) {
    real3 passes = real3(real(1.0f));
    word seed = hash_word(hash_word(hash_word(as_word(ray.origin.x)) + as_word(ray.origin.y)) + as_word(ray.origin.z));
    Walk walk = begun_walk();
    mask going = here;
    uint step = 0u;
    while (true) {
        real u = 1.0f - random_at(ray.direction, seed + word(step));
        // Twice as many places as needed make its noise smaller.
        walk_on(SCENE_ group, 2.0f, real(0.0f), ray, log2_positive(u) * -0.693147181f, reach, going, walk);
        going = mask_and(going, walk.t < reach);
        if (!any_lane(going)) return passes;
        Scatterers scatterers;
        MediaPoint point = media_at(SCENE_ group, point_at(ray, select(going, walk.t, real(0.0f))), scatterers);
        real3 share = real3(real(1.0f)) - point.extinction * (1.0f / max(walk.density, real(1e-30f)));
        passes = select(going, passes * share, passes);
        going = mask_and(going, largest(abs(passes)) > real(1e-4f));
        step = step + 1u;
    }
}

/// Extinction along `reach` of a ray, summed up over the places where povray's methods have their samples when no light
/// tells them to take more.
FN real3 media_depth(SCENE MediaGroup group, Ray ray, real reach) {
    if (!group.varies) return even_extinction(SCENE_ group) * reach;
    real3 sum = real3(real(0.0f));
    uint samples = AT(code, group.first + 14u);
    uint intervals = AT(code, group.first + 18u);
    bool adaptive = AT(code, group.first + 15u) == 3u;
    // Of method 1, between the least and the most.
    if (AT(code, group.first + 15u) == 1u) samples = (samples + AT(code, group.first + 22u)) / 2u;
    // Method 3: `samples` at ends of steps and one between each two; but the last step's length is not passed.
    uint places = adaptive ? 2u * samples - 1u : samples;
    float step = adaptive ? 0.5f / float(samples) : 1.0f / float(samples);
    float share = adaptive ? 1.0f / float(3u * (samples - 1u)) : step;
    share = share / float(intervals);
    step = step / float(intervals);
    Scatterers scatterers;
    for (uint i = 0u; i < intervals; i = i + 1u) {
        float begin = float(i) / float(intervals);
        for (uint k = 0u; k < places; k = k + 1u) {
            float at = begin + step * (adaptive ? float(k) : float(k) + 0.5f);
            bool inner_end = adaptive && k % 2u == 0u && k > 0u && k + 1u < places;
            real3 extinction = media_at(SCENE_ group, point_at(ray, reach * at), scatterers).extinction;
            sum = sum + extinction * real(inner_end ? 2.0f * share : share);
        }
    }
    return sum * reach;
}

/// Share of light, per channel, that gets through media over `distance` along a ray.
FN_LARGE real3 media_transmittance(SCENE Ray ray, real distance, MediaInsides insides, bool with_atmosphere,
                                   mask alive) {
    bool atmosphere = with_atmosphere && FRAME.atmosphere != NONE;
    real3 passes = real3(real(1.0f));
    real reach = min(distance, real(RAY_FAR));
    mask todo = mask_and(alive, reach > real(0.0f));
    while (any_lane(todo)) {
        MediaGroup group;
        mask here = take_alike(SCENE_ insides, atmosphere, todo, group);
        if (group.count == 0u || !group.absorbs) continue;
        if (group.varies && INTEGRATOR_IS(INTEGRATOR_PATH)) {
            passes = select(here, tracked_transmittance(SCENE_ group, ray, reach, here), passes);
            continue;
        }
        passes = select(here, dimmed_by(media_depth(SCENE_ group, ray, select(here, reach, real(0.0f)))), passes);
    }
    return passes;
}

KERNEL_END

#endif
