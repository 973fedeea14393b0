// SPDX-License-Identifier: Apache-2.0
// Paths in media: where a particle scatters a path, and what shines and dims on the way there. Places are drawn by
// delta tracking (Woodcock et al. 1965) with weights for colours (Kutz et al., Spectral and Decomposition Tracking,
// SIGGRAPH 2017), without bias whatever the density.
#ifndef SUNDOG_KERNEL_INTEGRATORS_PARTICLES_H
#define SUNDOG_KERNEL_INTEGRATORS_PARTICLES_H

#include "kernel/atmosphere/media.h"
#include "kernel/integrators/scatter.h"
#include "kernel/integrators/traced_path.h"

KERNEL_BEGIN

/// Steps of tracking after which a path is given up.
const uint MAX_MEDIA_STEPS = 65536u;
/// Where a medium shines, a way is looked at in as many places at least, on average.
const float LEAST_PLACES = 4.0f;
/// The first number of the choices along a path that are made in media; they are hashes' (sample_hash).
const uint FIRST_MEDIA_CHOICE = 0x10000000u;

/// Draws one of the particles at a point, in the lanes of `here`, by how much light each scatters.
FN void choose_scatterer(Scatterers scatterers, real u, mask here, INOUT(Particle) particle) {
    real all = real(0.0f);
    for (uint k = 0u; k < scatterers.count; k = k + 1u) all = all + largest(abs(scatterers.color[k]));
    real left = u * all;
    mask open = here;
    for (uint k = 0u; k < scatterers.count; k = k + 1u) {
        left = left - largest(abs(scatterers.color[k]));
        bool is_last = k + 1u == scatterers.count;
        mask taken = is_last ? open : mask_and(open, left < real(0.0f));
        particle.type = select(taken, word(scatterers.type[k]), particle.type);
        particle.eccentricity = select(taken, real(scatterers.eccentricity[k]), particle.eccentricity);
        open = mask_and(open, mask_not(taken));
    }
}

/// The same for paths that are in the media of a group together.
FN_LARGE void track_group(SCENE MediaGroup group, real reach, mask here, INOUT(TracedPath) path, INOUT(real3) radiance,
                          INOUT(Particle) particle) {
    real3 black = real3(real(0.0f));
    // Where nothing scatters or shines, twice as many places as needed make the weights' noise smaller.
    float factor = group.scatters ? 1.0f : 2.0f;
    real least = group.emits ? LEAST_PLACES / max(reach, real(1e-20f)) : real(0.0f);
    word number = word(FIRST_MEDIA_CHOICE) + (path.vertices << 18u);
    Walk walk = begun_walk();
    mask going = here;
    for (uint i = 0u; i < MAX_MEDIA_STEPS; i = i + 1u) {
        real u = 1.0f - sample_hash(path.draws, number + word(3u * i));
        walk_on(SCENE_ group, factor, least, path.ray, log2_positive(u) * -0.693147181f, reach, going, walk);
        going = mask_and(going, walk.t < reach);
        if (!any_lane(going)) return;
        real t = walk.t;
        real per_density = 1.0f / max(walk.density, real(1e-30f));
        Scatterers scatterers;
        MediaPoint point = media_at(SCENE_ group, point_at(path.ray, select(going, t, real(0.0f))), scatterers);
        radiance = radiance + select(going, path.weight * point.glow * per_density, black);
        real3 scattered = black;
        for (uint k = 0u; k < scatterers.count; k = k + 1u) scattered = scattered + scatterers.color[k];
        real3 passing = max(real3(walk.density) - point.extinction, black);
        real by_scattering = largest(abs(path.weight * scattered));
        real by_passing = largest(path.weight * passing);
        real all = by_scattering + by_passing;
        real share = select(all > real(0.0f), by_scattering / max(all, real(1e-30f)), real(0.0f));
        real choice = sample_hash(path.draws, number + word(3u * i + 1u));
        mask scatters = mask_and(going, choice < share);
        real3 factor = select(scatters, scattered * (1.0f / max(share, real(1e-20f))),
                              passing * (1.0f / max(1.0f - share, real(1e-20f))));
        path.weight = select(going, path.weight * factor * per_density, path.weight);
        if (any_lane(scatters)) {
            choose_scatterer(scatterers, choice / max(share, real(1e-20f)), scatters, particle);
            particle.met = mask_or(particle.met, scatters);
            particle.t = select(scatters, t, particle.t);
            going = mask_and(going, mask_not(scatters));
        }
        // Paths that bring little end at random, so that dense media take no longer than need be.
        real brings = largest(path.weight);
        mask weak = mask_and(going, brings < real(0.05f));
        if (any_lane(weak)) {
            real survival = brings * 10.0f;
            mask ends = mask_and(weak, sample_hash(path.draws, number + word(3u * i + 2u)) >= survival);
            real3 raised = path.weight * (1.0f / max(survival, real(1e-20f)));
            path.weight = select(weak, select(ends, black, raised), path.weight);
            going = mask_and(going, mask_not(ends));
        }
    }
    path.weight = select(going, black, path.weight);
}

/// Takes paths over the first `reach` of their rays: adds to `radiance` what media shine at them, dims their weights,
/// and says which of them a particle scatters before.
FN Particle track_media(SCENE real reach, INOUT(TracedPath) path, INOUT(real3) radiance) {
    Particle particle = no_particle();
    real way = min(reach, real(RAY_FAR));
    mask todo = mask_and(path.alive, way > real(0.0f));
    while (any_lane(todo)) {
        MediaGroup group;
        mask here = take_alike(SCENE_ path.media, FRAME.atmosphere != NONE, todo, group);
        if (group.count == 0u) continue;
        if (group.varies || group.emits || group.scatters) {
            track_group(SCENE_ group, way, here, path, radiance, particle);
        } else if (group.absorbs) {
            real3 passes = dimmed_by(media_depth(SCENE_ group, path.ray, select(here, way, real(0.0f))));
            path.weight = select(here, path.weight * passes, path.weight);
        }
    }
    return particle;
}

KERNEL_END

#endif
