// SPDX-License-Identifier: Apache-2.0
// What the eye sees through surfaces that don't bend light, for planes of what it meets (AOV_BEYOND). The device
// defines its traversal first (see whitted.h).
#ifndef SUNDOG_KERNEL_INTEGRATORS_SEEN_THROUGH_H
#define SUNDOG_KERNEL_INTEGRATORS_SEEN_THROUGH_H

#include "kernel/integrators/path.h"
#include "kernel/integrators/surface_met.h"
#include "kernel/lights/shadow.h"
#include "kernel/materials/veils.h"

KERNEL_BEGIN

/// denoise::divisor()'s least albedo.
const float LEAST_DIVISOR = 0.05f;

/// What is seen so far: sums over all that a ray meets, each thing by its share of what reaches the eye.
struct SeenThrough {
    real3 albedo;
    real3 normal;
    real nearness;  ///< One over the distance.
};

/// What light at a surface of this albedo is to be divided by: as denoise::divisor() has it.
FN real3 divisor_of(real3 albedo) {
    real3 white = real3(real(1.0f));
    real fade = clamp(largest(albedo) * (1.0f / LEAST_DIVISOR) - 1.0f, real(0.0f), real(1.0f));
    return white + (max(albedo, real3(real(LEAST_DIVISOR))) - white) * fade;
}

/// Adds something that stands `distance` away, has this normal and stops `share` of the light from behind; of what
/// reaches the eye, `albedo` is its part.
FN void add_seen(real3 albedo, real3 share, real3 normal, real distance, mask where, INOUT(SeenThrough) seen) {
    real part = (share.x + share.y + share.z) * 0.333333333f;
    seen.albedo = seen.albedo + select(where, albedo, real3(real(0.0f)));
    seen.normal = seen.normal + select(where, normal * part, real3(real(0.0f)));
    seen.nearness = seen.nearness + select(where, part / max(distance, real(1e-30f)), real(0.0f));
}

/// In lanes of `found` whose surface lets light pass straight on, makes `first` the mean of that surface and of what is
/// behind it, however many such surfaces follow (up to MAX_SHADOW_SURFACES): each by the share of its light that
/// reaches the eye. What has no albedo (mirrors, glass, media, the sky) counts as white, as filters take it. `path` has
/// come to the surface at `distance`, and gets behind it by `crossing`.
FN_LARGE void see_through(SCENE PathState path, LARGE(Surface) surface, LARGE(Lobes) lobes_met, Crossing crossing,
                          real distance, mask found, INOUT(RayCounts) counts, INOUT(FirstHit) first) {
    real3 white = real3(real(1.0f));
    real3 black = real3(real(0.0f));
    Surface s = surface;
    Lobes lobes = lobes_met;
    real3 passes;
    mask veiled = passes_straight(SCENE_ s, lobes, found, passes);
    if (!any_lane(veiled)) return;
    SeenThrough seen;
    seen.albedo = black;
    seen.normal = black;
    seen.nearness = real(0.0f);
    real3 share = white;
    mask alive = veiled;
    for (uint number = 0u; number < MAX_SHADOW_SURFACES; number = number + 1u) {
        real3 kept = max(white - lobes.reflectance - lobes.transmittance, black);
        real3 own = select(lobes.patterned, lobes.albedo, lobes.albedo * kept) + lobes.reflectance;
        add_seen(share * own, share * max(white - passes, black), s.normal, distance, alive, seen);
        share = share * passes;

        path.insides.inner = select(alive, crossing.behind.inner, path.insides.inner);
        path.insides.outer = select(alive, crossing.behind.outer, path.insides.outer);
        if (FEATURE(FEATURE_HOLLOW)) path.media = media_beyond(SCENE_ s, path.media, alive);
        path.ray.origin = select(alive, s.position - s.geometric_normal * s.error, path.ray.origin);
        counts.rays = counts.rays + select(alive, word(1u), word(0u));
        Hit hit = trace_closest(SCENE_ path.ray, alive, path.kind, true);
        mask met = mask_and(alive, hit.geometry != word(NONE));
#ifdef KERNEL_MEDIA
        if (FEATURE(FEATURE_MEDIA)) {
            real reach = select(met, hit.t, path.ray.t_max);
            real3 clear = select(alive, media_transmittance(SCENE_ path.ray, reach, path.media, true, alive), white);
            real3 stopped = share * max(white - clear, black);
            add_seen(stopped, stopped, black, distance, alive, seen);
            share = share * clear;
        }
#endif
        mask missed = mask_and(alive, mask_not(met));
        seen.albedo = seen.albedo + select(missed, share, black);
        alive = met;
        if (!any_lane(alive)) break;
        distance = distance + select(alive, hit.t, real(0.0f));
        LayerColors layered;
        real3 smooth_normal;
        real3 dimmed = surface_met(SCENE_ path.ray, hit, path.insides, real(0.5f), alive, s, lobes, layered, crossing,
                                   smooth_normal);
        share = select(alive, share * dimmed, share);
        mask straight = passes_straight(SCENE_ s, lobes, alive, passes);
        real most = largest(share);
        straight = mask_and(straight, most > real(1e-3f));
        if (number + 1u == MAX_SHADOW_SURFACES) straight = mask_and(straight, mask_not(straight));
        mask ends = mask_and(alive, mask_not(straight));
        add_seen(share * divisor_of(lobes.albedo), share, s.normal, distance, ends, seen);
        alive = straight;
        if (!any_lane(alive)) break;
    }
    first.albedo = select(veiled, seen.albedo, first.albedo);
    first.normal = select(veiled, seen.normal, first.normal);
    first.t = select(veiled, 1.0f / max(seen.nearness, real(1.0f / AOV_FAR)), first.t);
}

KERNEL_END

#endif
