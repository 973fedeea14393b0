// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion (Zhukov, Iones and Kronin, An Ambient Light Illumination Model, 1998): how much of the sky a
// surface sees, were it white and nothing farther off than a distance.
#ifndef SUNDOG_KERNEL_INTEGRATORS_OCCLUSION_H
#define SUNDOG_KERNEL_INTEGRATORS_OCCLUSION_H

#include "kernel/integrators/path_tracing.h"

KERNEL_BEGIN

/// As extend_path(): from the eye to a surface, and on from there in a direction drawn by the cosine. What is met hides
/// all where it is near and less the farther it is off, down to nothing at the distance, so that this leaves no edge.
FN void extend_occlusion(SCENE bool together, INOUT(TracedPath) path, INOUT(real3) radiance, INOUT(RayCounts) counts,
                         INOUT(FirstHit) first) {
    counts.rays = counts.rays + select(path.alive, word(1u), word(0u));
    Hit hit = trace_closest(SCENE_ path.ray, path.alive, path.kind, together);
    mask found = mask_and(path.alive, hit.geometry != word(NONE));
    mask from_eye = path.vertices == word(0u);
    real3 white = real3(real(1.0f));
    real relative = hit.t * (1.0f / FRAME.occlusion_distance);
    real3 seen = white * select(found, min(relative * relative, real(1.0f)), real(1.0f));
    mask second = mask_and(path.alive, mask_not(from_eye));
    // The sky itself is white, too.
    mask ended = mask_or(second, mask_and(path.alive, mask_not(found)));
    radiance = radiance + select(ended, seen, real3(real(0.0f)));
    mask here = mask_and(found, from_eye);
    path.alive = here;
    if (!any_lane(here)) return;
    Surface s = surface_at(SCENE_ path.ray, hit, here);
    if (FEATURE(FEATURE_BUMP)) s.normal = bumped_normal(SCENE_ s);
    if (FRAME.aovs != 0u) {
        first.t = select(here, hit.t, first.t);
        first.normal = select(here, s.normal, first.normal);
        first.geometry = select(here, s.geometry, first.geometry);
        first.primitive = select(here, s.primitive, first.primitive);
        first.material = select(here, s.material, first.material);
        first.albedo = select(here, white, first.albedo);
    }
    ShadingFrame basis = frame_around(s.normal);
    real3 direction = to_world(basis, cosine_direction(sample_pair(path.draws, word(FIRST_CHOICE))));
    direction = normalize(direction);
    // Under the face itself, behind a smoothed normal, nothing is seen.
    path.alive = mask_and(here, dot(direction, s.geometric_normal) > real(0.0f));
    path.ray.origin = select(here, s.position + s.geometric_normal * s.error, path.ray.origin);
    path.ray.direction = select(here, direction, path.ray.direction);
    path.ray.t_max = select(here, real(FRAME.occlusion_distance), path.ray.t_max);
    path.kind = select(here, word(RAY_SHADOW), path.kind);
    path.vertices = select(here, word(1u), path.vertices);
}

KERNEL_END

#endif
