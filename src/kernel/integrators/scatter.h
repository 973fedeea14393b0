// SPDX-License-Identifier: Apache-2.0
// How paths scatter at a surface: by its lobes and layers, or by a reflection model of its own. The device defines its
// traversal first (see whitted.h).
#ifndef SUNDOG_KERNEL_INTEGRATORS_SCATTER_H
#define SUNDOG_KERNEL_INTEGRATORS_SCATTER_H

#include "kernel/atmosphere/scattering.h"
#include "kernel/bsdf/blinn_phong.h"
#include "kernel/bsdf/frame.h"
#include "kernel/lights/direct.h"
#include "kernel/materials/bsdf_material.h"

KERNEL_BEGIN

/// Which particles of media scatter paths, before they come to a surface.
struct Particle {
    mask met;
    real t;  ///< Where on the ray.
    word type;
    real eccentricity;
};

FN Particle no_particle() {
    Particle particle;
    particle.met = mask(false);
    particle.t = real(0.0f);
    particle.type = word(1u);
    particle.eccentricity = real(0.0f);
    return particle;
}

/// How directions are drawn at a surface. Shares are of what goes on: matt and glossy ones in all directions, one that
/// is mirrored, one that passes through.
struct Scatter {
    real rough, mirrored, through;  ///< Shares; they add up to 1 where the path can go on at all.
    real gloss;                     ///< Of the rough share, how much is drawn for highlights,
    real exponent;                  ///< of this sharpness.
    mask own;                       ///< Rough directions are those of a reflection model of the material's own,
    word model;                     ///< number `model` of `bsdfs`,
    mask clear;                     ///< and light comes through it from behind.
    mask seamless;                  ///< If FEATURE_BODIES: what it parts bends light alike, and rays pass straight.
    mask particle;                  ///< If FEATURE_MEDIA: this is no surface but a particle
    word phase;                     ///< of this type (phase_density),
    real eccentricity;              ///< and this shape.
};

/// In the lanes of `where`, takes all from a surface but its diffuse and specular colours: it neither shines nor
/// reflects nor lets light through, and paths go off from it in all directions.
FN void become_matt(mask where, INOUT(Lobes) lobes, INOUT(Scatter) scatter) {
    real3 black = real3(real(0.0f));
    lobes.emission = select(where, black, lobes.emission);
    lobes.ambient = select(where, black, lobes.ambient);
    lobes.reflectance = select(where, black, lobes.reflectance);
    lobes.transmittance = select(where, black, lobes.transmittance);
    lobes.patterned = mask_and(lobes.patterned, mask_not(where));
    scatter.rough = select(where, real(1.0f), scatter.rough);
    scatter.mirrored = select(where, real(0.0f), scatter.mirrored);
    scatter.through = select(where, real(0.0f), scatter.through);
    scatter.gloss = select(where, real(0.0f), scatter.gloss);
    scatter.own = mask_and(scatter.own, mask_not(where));
    scatter.clear = mask_and(scatter.clear, mask_not(where));
}

/// The sharpest highlight of layers counts, and the share of all.
FN void layers_gloss(SCENE Surface s, LARGE(LayerColors) layered, mask patterned_lanes, INOUT(real) gloss,
                     INOUT(real) exponent) {
    mask todo = patterned_lanes;
    word look = FIELD(patterned, valid_index(todo, FIELD(materials, s.material, patterned)), look);
    while (any_lane(todo)) {
        uint i = first_lane(todo, look);
        mask here = mask_and(todo, look == word(i));
        todo = mask_and(todo, mask_not(here));
        PatternedMaterial m = AT(patterned, i);
        for (uint l = 0u; l < m.layer_count; l = l + 1u) {
            Layer layer = AT(layers, m.first_layer + l);
            real seen = largest(layered.above[l]);
            if (layer.specular > 0.0f) {
                gloss =
                    gloss + select(here, seen * (layer.specular * 8.0f / (layer.specular_exponent + 8.0f)), real(0.0f));
                exponent = max(exponent, select(here, real(layer.specular_exponent), real(0.0f)));
            }
            if (layer.phong > 0.0f) {
                // A mirrored ray's angle is about twice a halfway vector's.
                gloss = gloss + select(here, seen * (layer.phong * 2.0f / (layer.phong_size + 2.0f)), real(0.0f));
                exponent = max(exponent, select(here, real(4.0f * layer.phong_size), real(0.0f)));
            }
        }
    }
}

/// By how much light each of its ways brings on.
FN Scatter scatter_of(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, mask found) {
    real matt = largest(lobes.diffuse);
    real gloss = largest(lobes.specular) * 8.0f / (lobes.shininess + 8.0f);
    Scatter scatter;
    scatter.exponent = select(lobes.phong, lobes.shininess * 4.0f, lobes.shininess);
    if (FEATURE(FEATURE_PATTERNED)) {
        mask patterned_lanes = mask_and(found, lobes.patterned);
        matt = select(lobes.patterned, largest(lobes.albedo), matt);
        gloss = select(lobes.patterned, real(0.0f), gloss);
        scatter.exponent = select(lobes.patterned, real(0.0f), scatter.exponent);
        layers_gloss(SCENE_ s, layered, patterned_lanes, gloss, scatter.exponent);
    }
    real rough = max(matt, real(0.0f)) + max(gloss, real(0.0f));
    real mirrored = max(largest(lobes.reflectance), real(0.0f));
    real through = max(largest(lobes.transmittance), real(0.0f));
    real all = rough + mirrored + through;
    real per_all = select(all > real(0.0f), 1.0f / max(all, real(1e-30f)), real(0.0f));
    scatter.rough = rough * per_all;
    scatter.mirrored = mirrored * per_all;
    scatter.through = through * per_all;
    scatter.gloss = max(gloss, real(0.0f)) / max(rough, real(1e-30f));
    scatter.own = mask_and(found, mask_not(found));
    scatter.clear = scatter.own;
    scatter.model = word(0u);
    scatter.seamless = scatter.own;
    scatter.particle = scatter.own;
    scatter.phase = word(1u);
    scatter.eccentricity = real(0.0f);
    return scatter;
}

/// Density over solid angle of drawing a rough direction. Vectors are local to the normal.
FN real rough_density(Scatter scatter, real3 to_eye, real3 to_light) {
    real matt = max(to_light.z, real(0.0f)) * 0.318309886f;
    real density = matt;
    if (any_lane(scatter.gloss > real(0.0f)))
        density = mix(matt, blinn_phong_density(to_eye, to_light, scatter.exponent), scatter.gloss);
    return density * scatter.rough;
}

/// Lanes of `alive` that light from a direction lights; in the lanes of `behind` it comes from the back.
FN mask scattering_lanes(SCENE Surface s, Lobes lobes, Scatter scatter, real3 to_light, mask alive, OUT(mask) behind) {
    mask lit = lit_lanes(SCENE_ s, lobes.patterned, to_light, alive, behind);
    if (FEATURE(FEATURE_BSDF)) {
        mask through = mask_and(mask_and(alive, scatter.clear), dot(s.geometric_normal, to_light) < real(0.0f));
        through = mask_and(through, dot(s.normal, to_light) < real(0.0f));
        behind = mask_or(behind, through);
        lit = mask_or(lit, through);
    }
    if (FEATURE(FEATURE_MEDIA)) {
        lit = mask_or(lit, mask_and(alive, scatter.particle));
        behind = mask_and(behind, mask_not(scatter.particle));
    }
    return lit;
}

/// What a light of colour 1 from a direction makes of the surface in the lanes of `lit` (pi times BSDF times cosine),
/// and the density over solid angle of drawing that direction.
FN_LARGE real3 scattered_light(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, LARGE(BsdfPoint) point,
                               Scatter scatter, ShadingFrame basis, mask lit, mask behind, real3 to_light, real3 to_eye,
                               OUT(real) density) {
    real3 black = real3(real(0.0f));
    real3 base = black;
    real3 highlight = base;
    density = real(0.0f);
    real3 local_eye = to_local(basis, to_eye);
    real3 local_light = to_local(basis, to_light);
    mask plain = mask_and(lit, mask_not(scatter.own));
    if (FEATURE(FEATURE_MEDIA)) plain = mask_and(plain, mask_not(scatter.particle));
    if (any_lane(plain)) {
        add_light(SCENE_ s, lobes, layered, real3(real(1.0f)), LIGHT_HIGHLIGHTS, 0u, plain, behind, to_light, to_eye,
                  base, highlight);
        density = rough_density(scatter, local_eye, local_light);
    }
    real3 value = select(plain, base + highlight, black);
    if (FEATURE(FEATURE_BSDF)) {
        mask own = mask_and(lit, scatter.own);
        if (any_lane(own)) {
            real3 own_value;
            real own_density;
            bsdf_values(SCENE_ scatter.model, point, local_eye, local_light, own, own_value, own_density);
            value = select(own, own_value * (scatter.rough * 3.14159265f), value);
            density = select(own, own_density * scatter.rough, density);
        }
    }
    if (FEATURE(FEATURE_MEDIA)) {
        mask particle = mask_and(lit, scatter.particle);
        if (any_lane(particle)) {
            real sent = phase_density(scatter.phase, -dot(to_eye, to_light), scatter.eccentricity);
            value = select(particle, real3(sent * 3.14159265f), value);
            density = select(particle, sent, density);
        }
    }
    return value;
}

KERNEL_END

#endif
