// SPDX-License-Identifier: Apache-2.0
// What the lights themselves do at a surface.
#ifndef SUNDOG_KERNEL_LIGHTS_DIRECT_H
#define SUNDOG_KERNEL_LIGHTS_DIRECT_H

#include "kernel/lights/light.h"
#include "kernel/lights/shadow.h"
#include "kernel/materials/layers.h"
#include "kernel/materials/material.h"

KERNEL_BEGIN

/// Lanes of `alive` whose surface a light in direction `to_light` lights: their front, or, in the lanes of `behind`,
/// their back, where the material lets that be seen. Not where it is behind the face, or behind the smoothed one.
FN mask lit_lanes(SCENE Surface s, mask patterned, real3 to_light, mask alive, OUT(mask) behind) {
    mask faces = dot(s.normal, to_light) > real(0.0f);
    // Layers have normals of their own, which may turn to a light that the surface's turns from.
    if (FEATURE(FEATURE_NORMALS)) faces = mask_or(faces, patterned);
    real facing = dot(s.geometric_normal, to_light);
    mask lit = mask_and(alive, mask_and(faces, facing > real(0.0f)));
    behind = mask_and(alive, mask_not(alive));
    if (FEATURE(FEATURE_BACKLIT)) {
        mask backlit = (FIELD(materials, s.material, flags) & word(MATERIAL_BACKLIT)) != word(0u);
        behind = mask_and(mask_and(alive, backlit), facing < real(0.0f));
        lit = mask_or(lit, behind);
    }
    return lit;
}

/// Adds what light of number `light_number` does that arrives from one direction in the lanes of `lit`.
FN void add_light(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, real3 light_color, uint light_flags,
                  uint light_number, mask lit, mask behind, real3 to_light, real3 to_eye, INOUT(real3) base,
                  INOUT(real3) highlight) {
    light_color = select(lit, light_color, real3(real(0.0f)));
    if (FEATURE(FEATURE_PATTERNED)) {
        light_layers(SCENE_ s, layered, lit, behind, lobes.patterned, light_color, light_flags, light_number, to_light,
                     to_eye, base, highlight);
    }
    base = base + lobes.diffuse * light_color * dot(s.normal, to_light);
    real specular_most = largest(lobes.specular);
    if (any_lane(mask_and(lit, specular_most > real(0.0f)))) {
        real blinn = blinn_phong_highlight(s.normal, to_light, to_eye, lobes.shininess);
        if (any_lane(lobes.phong)) {
            blinn = select(lobes.phong, phong_highlight(s.normal, to_light, to_eye, lobes.shininess), blinn);
        }
        highlight = highlight + lobes.specular * light_color * blinn;
    }
}

/// If RECORDING: sums of numbers that stand for the lights that light a place, and for those whose highlights show
/// there.
struct LightStates {
    word lit;
    word highlit;
};

/// Highlights that are weaker don't count as visible.
const float VISIBLE_HIGHLIGHT = 0.02f;

/// Light that a surface sends back from the lights alone: matt and emitted light in `base`, highlights apart.
FN void direct_light(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, real3 to_eye, MediaInsides media,
                     mask alive, INOUT(RayCounts) counts, OUT(real3) base, OUT(real3) highlight,
                     OUT(LightStates) states) {
    states.lit = word(0u);
    states.highlit = word(0u);
    base = lobes.emission + lobes.ambient * real3(FRAME.ambient);
    highlight = real3(real(0.0f));
    for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
        Light light = AT(lights, i);
        real distance;
        real3 to_light = direction_to_light(light, s.position, distance);
        // An area that illuminates lights from each of its lights, dimmed by the shadow of the area as a whole.
        bool in_parts = FEATURE(FEATURE_LIGHT_SHAPES) && (light.flags & LIGHT_ILLUMINATES) != 0u;
        mask behind;
        mask lit = lit_lanes(SCENE_ s, lobes.patterned, to_light, alive, behind);
        if (in_parts) lit = alive;
        if (FEATURE(FEATURE_LIGHT_GROUPS))
            lit = mask_and(lit, light_reaches(SCENE_ light.group, s.material, lobes.patterned));
        // No shadow ray where nothing is lit.
        if (!any_lane(lit)) continue;
        real3 light_color = real3(light.color);
        if (FEATURE(FEATURE_LIGHT_SHAPES)) {
            if (!in_parts) light_color = light_color * light_share(light, s.position, to_light, distance);
            // Lights may be negative.
            real3 amount = abs(light_color);
            lit = mask_and(lit, largest(amount) > real(0.0f));
        }
        if (FEATURE(FEATURE_SHADOWS)) {
            if ((light.flags & LIGHT_SHADOWS) != 0u && any_lane(lit)) {
                real3 off = s.geometric_normal * s.error;
                if (FEATURE(FEATURE_BACKLIT)) off = select(behind, -off, off);
                // What doesn't collect photons gets the light that they stand for along shadow rays, in a turn of its
                // own: in one place, for the code of shadows is large.
                uint turns = FEATURE(FEATURE_PHOTONS) ? 2u : 1u;
                for (uint turn = 0u; turn < turns; turn = turn + 1u) {
                    Light asked = light;
                    mask here = lit;
                    if (FEATURE(FEATURE_PHOTONS)) {
                        mask collects = (FIELD(geometries, s.geometry, photons) & word(PHOTONS_COLLECT)) != word(0u);
                        if (turn == 0u) {
                            here = mask_and(lit, collects);
                        } else {
                            here = mask_and(lit, mask_not(collects));
                            asked.flags = light.flags | LIGHT_PHOTONS_NEVER_REFRACT;
                        }
                    }
#ifdef SUNDOG_KERNEL_SHORTCUTS
                    if (scene.light_cells != nullptr) {
                        mask dark;
                        mask unknown = unknown_shadows(SCENE_ i, s.position + off, s.primitive, here, dark);
                        light_color = select(dark, real3(real(0.0f)), light_color);
                        // Rays all the same, however they are answered.
                        word known = select(mask_and(here, mask_not(unknown)), word(1u), word(0u));
                        counts.rays = counts.rays + known;
                        counts.shadow_rays = counts.shadow_rays + known;
                        here = unknown;
                    }
#endif
                    if (any_lane(here)) {
                        real3 passes =
                            light_visibility(SCENE_ asked, s.position + off, to_light, distance, media, here, counts);
                        light_color = select(here, light_color * passes, light_color);
                    }
                }
            }
        }
        real3 highlight_before = highlight;
        if (RECORDING) {
            real3 arrives = abs(light_color);
            mask reaches = mask_and(lit, largest(arrives) > real(0.0f));
            states.lit = states.lit + select(reaches, hash_word(word(i + 1u)), word(0u));
        }
        uint parts = in_parts ? light.area_count_u * light.area_count_v : 1u;
        mask reached = lit;
        real3 color = light_color;
        real3 from = to_light;
        for (uint part = 0u; part < parts; part = part + 1u) {
            if (in_parts) {
                uint column = part % light.area_count_u;
                uint row = part / light.area_count_u;
                real3 place = area_light_place(light, real(place_in_row(column, light.area_count_u)),
                                               real(place_in_row(row, light.area_count_v)), to_light);
                if (light.kind != LIGHT_SUN) place = place - s.position;
                real reach = max(length(place), real(1e-30f));
                from = place * (1.0f / reach);
                lit = lit_lanes(SCENE_ s, lobes.patterned, from, reached, behind);
                color = light_color * (light_share(light, s.position, from, reach) * (1.0f / float(parts)));
            }
            add_light(SCENE_ s, lobes, layered, color, light.flags, i, lit, behind, from, to_eye, base, highlight);
        }
        if (RECORDING) {
            real3 gained = highlight - highlight_before;
            mask shows = mask_and(alive, largest(gained) > real(VISIBLE_HIGHLIGHT));
            states.highlit = states.highlit + select(shows, hash_word(word(i + 1u)), word(0u));
        }
    }
}

KERNEL_END

#endif
