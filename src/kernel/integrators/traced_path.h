// SPDX-License-Identifier: Apache-2.0
// A path of path tracing: what it carries on from surface to surface.
#ifndef SUNDOG_KERNEL_INTEGRATORS_TRACED_PATH_H
#define SUNDOG_KERNEL_INTEGRATORS_TRACED_PATH_H

#include "kernel/integrators/path.h"
#include "kernel/sequences.h"

KERNEL_BEGIN

/// A path under way.
struct TracedPath {
    Ray ray;
    real3 weight;
    word vertices;  ///< Surfaces met so far.
    word kind;      ///< RAY_*
    real density;   ///< Over solid angle, with which the ray's direction was drawn; 0: it was the only one.
    real passed;    ///< If FEATURE_VEILS: how far the ray's origin is from where that was, as it came straight through.
    PathSample draws;
    real spectrum;  ///< If FEATURE_DISPERSION: the place in the spectrum by which it is refracted,
    mask colored;   ///< and where it has been, so that it has that colour.
    Insides insides;
    MediaInsides media;
    mask alive;
};

/// A path that starts with a camera's ray.
FN TracedPath begun_path(SCENE Ray ray, PathSample draws, mask alive) {
    TracedPath path;
    path.ray = ray;
    path.weight = real3(real(1.0f));
    path.vertices = word(0u);
    path.kind = word(RAY_CAMERA);
    path.density = real(0.0f);
    path.passed = real(0.0f);
    path.draws = draws;
    path.spectrum = real(0.5f);
    path.colored = mask(false);
    if (FEATURE(FEATURE_DISPERSION)) path.spectrum = sample_pair(draws, word(2u)).x;
    path.insides = insides_of_eye(SCENE_ alive);
    path.media = eye_insides(SCENE_ alive);
    path.alive = alive;
    return path;
}

/// Puts `other` in the lanes of m.
FN void take_path(mask m, TracedPath other, INOUT(TracedPath) path) {
    path.ray.origin = select(m, other.ray.origin, path.ray.origin);
    path.ray.direction = select(m, other.ray.direction, path.ray.direction);
    path.ray.t_min = select(m, other.ray.t_min, path.ray.t_min);
    path.ray.t_max = select(m, other.ray.t_max, path.ray.t_max);
    path.weight = select(m, other.weight, path.weight);
    path.vertices = select(m, other.vertices, path.vertices);
    path.kind = select(m, other.kind, path.kind);
    path.density = select(m, other.density, path.density);
    path.draws.pixel = select(m, other.draws.pixel, path.draws.pixel);
    path.draws.index = select(m, other.draws.index, path.draws.index);
    path.passed = select(m, other.passed, path.passed);
    path.spectrum = select(m, other.spectrum, path.spectrum);
    path.colored = select_mask(m, other.colored, path.colored);
    path.insides.inner = select(m, other.insides.inner, path.insides.inner);
    path.insides.outer = select(m, other.insides.outer, path.insides.outer);
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
        path.media.entry[i] = select(m, other.media.entry[i], path.media.entry[i]);
    path.alive = select_mask(m, other.alive, path.alive);
}

/// Choices at each vertex: the direction, the place of a light, and which lobe and light.
const uint CHOICES_A_VERTEX = 3u;
/// The first of them; those before are the camera's.
const uint FIRST_CHOICE = 4u;

KERNEL_END

#endif
