// SPDX-License-Identifier: Apache-2.0
// A material at a surface point: lobes with weights, textures looked up.
#ifndef SUNDOG_KERNEL_MATERIALS_MATERIAL_H
#define SUNDOG_KERNEL_MATERIALS_MATERIAL_H

#include "kernel/materials/reflection.h"
#include "kernel/materials/surface.h"
#include "kernel/patterns/texture.h"

KERNEL_BEGIN

/// How a surface answers to light there; linear RGB. reflectance and transmittance are final weights: Fresnel is in
/// them.
struct Lobes {
    real3 emission;
    real3 ambient;
    real3 diffuse;
    real3 specular;
    real shininess;
    mask phong;  ///< Highlight by Phong's formula, else by Blinn's.
    real3 reflectance;
    real3 transmittance;
    real eta;        ///< Index of refraction on the ray's side over that on the other.
    real3 albedo;    ///< What an albedo AOV shows.
    real exponent;   ///< If FEATURE_EXPONENTS: one over that of the radiance that is reflected.
    mask patterned;  ///< A texture of layers (layers.h), whose own light is not thinned by what it reflects or lets
                     ///< through.
};

/// What a surface emits; of it, material, geometry, primitive, uv and weights count.
FN real3 emission_at(SCENE Surface s) {
    real3 emission = FIELD(materials, s.material, emission);
    if (!FEATURE(FEATURE_TEXTURES)) return emission;
    word material = s.material;
    if (FEATURE(FEATURE_VERTEX_ATTRIBUTES)) {
        mask colored = (FIELD(materials, material, flags) & word(MATERIAL_VERTEX_EMISSION)) != word(0u);
        if (any_lane(colored)) {
            word triangle;
            mask is_triangle = on_triangle(SCENE_ s, triangle);
            real alpha_there;
            real3 tint = vertex_color(SCENE_ triangle, is_triangle, s.weights, alpha_there);
            emission = select(colored, emission * tint, emission);
        }
    }
    word maps = FIELD(materials, material, maps);
    word texture = FIELD(material_maps, maps, emission.texture);
    mask used = texture != word(NONE);
    if (!any_lane(used)) return emission;
    word ref_flags = FIELD(material_maps, maps, emission.flags);
    real2 uv = map_uv(SCENE_ s, ref_flags);
    real2 place = uv * FIELD(material_maps, maps, emission.scale) + FIELD(material_maps, maps, emission.offset);
    if (any_lane((ref_flags & word(TEXTURE_TURNED)) != word(0u)))
        place = turned_uv(ref_flags, place, uv, FIELD(material_maps, maps, emission.shear));
    real alpha;
    real3 color = texture_lookup(SCENE_ valid_index(used, texture), ref_flags, place, alpha);
    return select(used, emission * color, emission);
}

/// Textures' part of evaluate_material.
FN void apply_textures(SCENE Surface s, word flags, INOUT(Lobes) lobes) {
    mask checker = (flags & word(MATERIAL_CHECKER)) != word(0u);
    if (any_lane(checker)) {
        mask other = mask_and(checker, checker_is_other(s.uv, FIELD(materials, s.material, checker_cells)));
        real3 color = FIELD(materials, s.material, checker_other);
        lobes.diffuse = select(other, color, lobes.diffuse);
        lobes.ambient = select(other, color, lobes.ambient);
    }
    real alpha;
    word maps = FIELD(materials, s.material, maps);
    word texture = FIELD(material_maps, maps, diffuse.texture);
    mask used = texture != word(NONE);
    if (any_lane(used)) {
        word ref_flags = FIELD(material_maps, maps, diffuse.flags);
        real2 base = map_uv(SCENE_ s, ref_flags);
        real2 uv = base * FIELD(material_maps, maps, diffuse.scale) + FIELD(material_maps, maps, diffuse.offset);
        if (any_lane((ref_flags & word(TEXTURE_TURNED)) != word(0u)))
            uv = turned_uv(ref_flags, uv, base, FIELD(material_maps, maps, diffuse.shear));
        real3 color = texture_lookup(SCENE_ valid_index(used, texture), ref_flags, uv, alpha);
        color = select(used, color, real3(real(1.0f)));
        lobes.diffuse = lobes.diffuse * color;
        lobes.ambient = lobes.ambient * color;
    }
    texture = FIELD(material_maps, maps, specular.texture);
    used = texture != word(NONE);
    if (any_lane(used)) {
        word ref_flags = FIELD(material_maps, maps, specular.flags);
        real2 base = map_uv(SCENE_ s, ref_flags);
        real2 uv = base * FIELD(material_maps, maps, specular.scale) + FIELD(material_maps, maps, specular.offset);
        if (any_lane((ref_flags & word(TEXTURE_TURNED)) != word(0u)))
            uv = turned_uv(ref_flags, uv, base, FIELD(material_maps, maps, specular.shear));
        real3 color = texture_lookup(SCENE_ valid_index(used, texture), ref_flags, uv, alpha);
        color = select(used, color, real3(real(1.0f)));
        lobes.specular = lobes.specular * color;
        lobes.reflectance = lobes.reflectance * color;
    }
    lobes.emission = emission_at(SCENE_ s);
    texture = FIELD(material_maps, maps, occlusion.texture);
    used = texture != word(NONE);
    if (any_lane(used)) {
        word ref_flags = FIELD(material_maps, maps, occlusion.flags);
        real2 base = map_uv(SCENE_ s, ref_flags);
        real2 uv = base * FIELD(material_maps, maps, occlusion.scale) + FIELD(material_maps, maps, occlusion.offset);
        if (any_lane((ref_flags & word(TEXTURE_TURNED)) != word(0u)))
            uv = turned_uv(ref_flags, uv, base, FIELD(material_maps, maps, occlusion.shear));
        real3 open = texture_lookup(SCENE_ valid_index(used, texture), ref_flags, uv, alpha);
        real share = 1.0f + FIELD(material_maps, maps, occlusion.strength) * (open.x - 1.0f);
        lobes.ambient = select(used, lobes.ambient * share, lobes.ambient);
    }
    real vertex_alpha = real(1.0f);
    mask fades = mask_and(used, mask_not(used));
    if (FEATURE(FEATURE_VERTEX_ATTRIBUTES)) {
        word triangle;
        mask is_triangle = on_triangle(SCENE_ s, triangle);
        real3 tint = vertex_color(SCENE_ triangle, is_triangle, s.weights, vertex_alpha);
        lobes.diffuse = lobes.diffuse * tint;
        lobes.ambient = lobes.ambient * tint;
        mask mirrors = (flags & word(MATERIAL_VERTEX_SPECULAR)) != word(0u);
        lobes.specular = select(mirrors, lobes.specular * tint, lobes.specular);
        lobes.reflectance = select(mirrors, lobes.reflectance * tint, lobes.reflectance);
        mask passes = (flags & word(MATERIAL_VERTEX_PASSES)) != word(0u);
        lobes.transmittance = select(passes, lobes.transmittance * tint, lobes.transmittance);
        fades = (flags & word(MATERIAL_VERTEX_ALPHA)) != word(0u);
    }
    texture = FIELD(material_maps, maps, opacity.texture);
    used = texture != word(NONE);
    mask thinned = mask_or(used, fades);
    if (any_lane(thinned)) {
        word ref_flags = FIELD(material_maps, maps, opacity.flags);
        real opacity = real(1.0f);
        if (any_lane(used)) {
            real2 base = map_uv(SCENE_ s, ref_flags);
            real2 uv = base * FIELD(material_maps, maps, opacity.scale) + FIELD(material_maps, maps, opacity.offset);
            if (any_lane((ref_flags & word(TEXTURE_TURNED)) != word(0u)))
                uv = turned_uv(ref_flags, uv, base, FIELD(material_maps, maps, opacity.shear));
            real3 color = texture_lookup(SCENE_ valid_index(used, texture), ref_flags, uv, alpha);
            opacity = select(used, texture_channel(color, alpha, ref_flags), opacity);
        }
        opacity = select(fades, opacity * vertex_alpha, opacity);
        mask cut_off = (ref_flags & word(TEXTURE_CUTOFF)) != word(0u);
        if (any_lane(cut_off)) {
            mask there = opacity >= FIELD(material_maps, maps, opacity.strength);
            opacity = select(cut_off, select(there, real(1.0f), real(0.0f)), opacity);
        }
        opacity = select(thinned, opacity, real(1.0f));
        // What the map takes away lets light pass straight through.
        lobes.transmittance = real3(real(1.0f)) - (real3(real(1.0f)) - lobes.transmittance) * opacity;
        lobes.reflectance = lobes.reflectance * opacity;
        lobes.specular = lobes.specular * opacity;
    }
}

/// The material at a surface point, for a ray that comes along `incoming`; eta as in Lobes.
FN Lobes evaluate_material_between(SCENE Surface s, real3 incoming, real eta) {
    Lobes lobes;
    word flags = FIELD(materials, s.material, flags);
    lobes.emission = FIELD(materials, s.material, emission);
    lobes.ambient = FIELD(materials, s.material, ambient);
    lobes.diffuse = FIELD(materials, s.material, diffuse);
    lobes.specular = real3(real(0.0f));
    lobes.shininess = real(1.0f);
    lobes.phong = (flags & word(MATERIAL_PHONG)) != word(0u);
    if (FEATURE(FEATURE_HIGHLIGHTS)) {
        lobes.specular = FIELD(materials, s.material, specular);
        lobes.shininess = FIELD(materials, s.material, shininess);
    }
    lobes.reflectance = real3(real(0.0f));
    lobes.transmittance = real3(real(0.0f));
    lobes.eta = eta;
    lobes.exponent = real(1.0f);
    lobes.patterned = (flags & word(MATERIAL_PATTERNED)) != word(0u);
    if (FEATURE(FEATURE_MIRRORS)) lobes.reflectance = FIELD(materials, s.material, reflectance);
    if (FEATURE(FEATURE_TRANSPARENT)) {
        lobes.transmittance = FIELD(materials, s.material, transmittance);
    }
    if (FEATURE(FEATURE_TEXTURES)) {
        if (any_lane((flags & word(MATERIAL_TEXTURED)) != word(0u))) apply_textures(SCENE_ s, flags, lobes);
    }
    mask fresnel = (flags & word(MATERIAL_FRESNEL)) != word(0u);
    if (FEATURE(FEATURE_MIRRORS | FEATURE_TRANSPARENT)) {
        real cos_in = -dot(s.normal, incoming);
        real3 t = lobes.transmittance;
        mask transparent = largest(t) > real(0.0f);
        if (any_lane(fresnel)) {
            real3 opaque_reflectance = fresnel_schlick(lobes.reflectance, cos_in);
            lobes.reflectance = select(mask_and(fresnel, mask_not(transparent)), opaque_reflectance, lobes.reflectance);
        }
        if (any_lane(transparent)) {
            real f = fresnel_dielectric(cos_in, lobes.eta);
            mask total = f >= real(1.0f);
            mask split = mask_and(fresnel, transparent);
            lobes.reflectance = select(split, lobes.reflectance * f, lobes.reflectance);
            lobes.transmittance = select(split, t * (1.0f - f), t);
            // Total internal reflection: all that would have passed is thrown back.
            mask thrown_back = mask_and(transparent, total);
            lobes.reflectance = select(thrown_back, max(t, lobes.reflectance), lobes.reflectance);
            lobes.transmittance = select(thrown_back, real3(real(0.0f)), lobes.transmittance);
        }
    }
    lobes.albedo = lobes.diffuse;
    return lobes;
}

/// The same between the material and the open air.
FN Lobes evaluate_material(SCENE Surface s, real3 incoming) {
    real eta = real(1.0f);
    if (FEATURE(FEATURE_TRANSPARENT)) {
        real ior = FIELD(materials, s.material, ior);
        eta = select(s.from_behind, ior, 1.0f / ior);
    }
    return evaluate_material_between(SCENE_ s, incoming, eta);
}

KERNEL_END

#endif
