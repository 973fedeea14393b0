// SPDX-License-Identifier: Apache-2.0
// Paths that go below a surface and come out elsewhere. The CPU's alone; shaders never see this header. The device
// defines its traversal first (see whitted.h).
#ifndef SUNDOG_KERNEL_INTEGRATORS_PATHS_BELOW_H
#define SUNDOG_KERNEL_INTEGRATORS_PATHS_BELOW_H

#include "kernel/integrators/scatter.h"
#include "kernel/integrators/traced_path.h"
#include "kernel/lights/subsurface.h"

KERNEL_BEGIN

/// The first number of the choices along a path that are made below surfaces; they are hashes' (sample_hash).
const uint FIRST_CHOICE_BELOW = 0x20000000u;
const uint CHOICES_BELOW = 64u;
/// How often a place is looked for before a path is given up.
const uint TRIES_BELOW = 16u;

/// Where surfaces let light in, paths choose between what they are on top (highlights, mirrors) and what is below:
/// there the surface becomes a matt white one at a place where light may have entered, and the path's weight what comes
/// from there by diffusion. Places are drawn as diffused_light() draws them. Light of lights without size that is
/// scattered once is added to `radiance`, by one sample.
FN_LARGE void go_below(SCENE LARGE(LayerColors) layered, mask outside, INOUT(RayCounts) counts, INOUT(TracedPath) path,
                       INOUT(real3) radiance, INOUT(Surface) s, INOUT(Lobes) lobes, INOUT(Scatter) scatter,
                       INOUT(ShadingFrame) basis) {
    real3 black = real3(real(0.0f));
    real3 reflectance;
    SubsurfacePoint point;
    mask spread = subsurface_point(SCENE_ s, lobes, layered, path.kind, path.media, outside, point, reflectance);
    if (!any_lane(spread)) return;
    real leaving = share_leaving(point, path.ray.direction);
    if (FRAME.light_count > 0u) {
        real3 once = single_scattered_light(SCENE_ point, path.ray.direction, word(1u), spread, counts);
        radiance = radiance + select(spread, path.weight * once * leaving, black);
    }
    word first = word(FIRST_CHOICE_BELOW) + path.vertices * word(CHOICES_BELOW);
    real above = scatter.rough * scatter.gloss + scatter.mirrored + scatter.through;
    real below = select(above > real(0.0f), clamp(1.0f - above, real(0.1f), real(0.9f)), real(1.0f));
    below = select(largest(reflectance) > real(0.0f), below, real(0.0f));
    mask goes = mask_and(spread, sample_hash(path.draws, first) < below);
    mask stays = mask_and(spread, mask_not(goes));
    path.weight = select(stays, path.weight * (1.0f / max(1.0f - below, real(1e-3f))), path.weight);
    lobes.albedo = select(stays, black, lobes.albedo);
    // What is left on top scatters by its highlight.
    scatter.gloss = select(mask_and(stays, scatter.gloss > real(0.0f)), real(1.0f), scatter.gloss);
    if (!any_lane(goes)) return;

    ShadingFrame around = frame_around(s.geometric_normal);
    real3 depth = depths_below(SCENE_ point, goes, counts);
    real3 value = black;
    Surface out = s;
    mask searching = goes;
    for (uint k = 0u; k < TRIES_BELOW; k = k + 1u) {
        word number = first + word(4u * k + 1u);
        real2 u = real2(sample_hash(path.draws, number), sample_hash(path.draws, number + word(1u)));
        word channel = word_from_real(sample_hash(path.draws, number + word(2u)) * 2.9999f);
        real under = select(channel == word(0u), depth.x, select(channel == word(1u), depth.y, depth.z));
        Surface x;
        mask found = place_below(SCENE_ point, around, u, under, searching, counts, x);
        if (any_lane(found)) {
            value = select(found, value_of_place(point, depth, x), value);
            out.position = select(found, x.position, out.position);
            out.error = select(found, x.error, out.error);
            out.geometric_normal = select(found, -x.geometric_normal, out.geometric_normal);
            out.normal = select(found, -x.normal, out.normal);
            out.geometry = select(found, x.geometry, out.geometry);
            out.primitive = select(found, x.primitive, out.primitive);
        }
        searching = mask_and(searching, mask_not(found));
        if (!any_lane(searching)) break;
    }
    value = select(searching, black, value);
    // The boundary takes its share at the way out, and at the way in that of light from all sides.
    real entering = 2.0f / (dipole_boundary(1.0f / point.eta) + 1.0f);
    path.weight = select(goes, path.weight * value * (leaving * entering / below), path.weight);
    lobes.diffuse = select(goes, real3(real(1.0f)), lobes.diffuse);
    lobes.specular = select(goes, black, lobes.specular);
    become_matt(goes, lobes, scatter);
    s.position = select(goes, out.position, s.position);
    s.error = select(goes, out.error, s.error);
    s.geometric_normal = select(goes, out.geometric_normal, s.geometric_normal);
    s.normal = select(goes, out.normal, s.normal);
    s.geometry = select(goes, out.geometry, s.geometry);
    s.primitive = select(goes, out.primitive, s.primitive);
    ShadingFrame there = frame_around(s.normal);
    basis.x = select(goes, there.x, basis.x);
    basis.y = select(goes, there.y, basis.y);
    basis.z = select(goes, there.z, basis.z);
}

KERNEL_END

#endif
