// SPDX-License-Identifier: Apache-2.0
// The reflection model of a material at a surface point, its maps looked up.
#ifndef SUNDOG_KERNEL_MATERIALS_BSDF_MATERIAL_H
#define SUNDOG_KERNEL_MATERIALS_BSDF_MATERIAL_H

#include "kernel/bsdf/bsdf.h"
#include "kernel/materials/bump.h"
#include "kernel/materials/material.h"

KERNEL_BEGIN

/// One of a model's maps (BSDF_MAP_*) as linear RGB and alpha; 1 in lanes that have none.
FN_LARGE real3 bsdf_map(SCENE LARGE(Surface) s, word maps, mask mapped, uint which, OUT(real) alpha) {
    real3 white = real3(real(1.0f));
    alpha = real(1.0f);
    word there = valid_index(mapped, maps);
    word texture = FIELD(bsdf_maps, there, map[which].texture);
    mask used = mask_and(mapped, texture != word(NONE));
    if (!any_lane(used)) return white;
    word flags = FIELD(bsdf_maps, there, map[which].flags);
    real2 uv = map_uv(SCENE_ s, flags);
    real2 place = uv * FIELD(bsdf_maps, there, map[which].scale) + FIELD(bsdf_maps, there, map[which].offset);
    if (any_lane((flags & word(TEXTURE_TURNED)) != word(0u)))
        place = turned_uv(flags, place, uv, FIELD(bsdf_maps, there, map[which].shear));
    real looked_up;
    real3 color = texture_lookup(SCENE_ valid_index(used, texture), flags, place, looked_up);
    alpha = select(used, looked_up, alpha);
    return select(used, color, white);
}

/// How opaque a model's surface is: what it isn't lets light pass straight through.
FN real bsdf_opacity(SCENE Surface s, word model, mask here) {
    real opacity = FIELD(bsdfs, model, opacity);
    if (!FEATURE(FEATURE_TEXTURES)) return opacity;
    word maps = FIELD(bsdfs, model, maps);
    mask mapped = mask_and(here, maps != word(NONE));
    word there = valid_index(mapped, maps);
    mask used = mapped;
    if (any_lane(mapped)) used = mask_and(mapped, FIELD(bsdf_maps, there, map[BSDF_MAP_OPACITY].texture) != word(NONE));
    mask fades = mask_and(here, mask_not(here));
    real share = real(1.0f);
    if (FEATURE(FEATURE_VERTEX_ATTRIBUTES)) {
        fades = (FIELD(materials, s.material, flags) & word(MATERIAL_VERTEX_ALPHA)) != word(0u);
        fades = mask_and(here, fades);
        if (any_lane(fades)) {
            word triangle;
            mask is_triangle = on_triangle(SCENE_ s, triangle);
            real vertex_alpha;
            vertex_color(SCENE_ triangle, is_triangle, s.weights, vertex_alpha);
            share = select(fades, vertex_alpha, share);
        }
    }
    if (!any_lane(mask_or(used, fades))) return opacity;
    word flags = word(0u);
    if (any_lane(mapped)) flags = select(mapped, FIELD(bsdf_maps, there, map[BSDF_MAP_OPACITY].flags), flags);
    if (any_lane(used)) {
        real alpha;
        real3 color = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_OPACITY, alpha);
        share = select(used, share * texture_channel(color, alpha, flags), share);
    }
    mask cut_off = (flags & word(TEXTURE_CUTOFF)) != word(0u);
    if (any_lane(cut_off)) {
        mask kept = share >= FIELD(bsdf_maps, there, map[BSDF_MAP_OPACITY].strength);
        share = select(cut_off, select(kept, real(1.0f), real(0.0f)), share);
    }
    return select(mask_or(used, fades), opacity * share, opacity);
}

/// Facets so smooth that they count as mirrors would have densities beyond single precision.
const float LEAST_ALPHA = 1e-3f;

/// A model's index of refraction at a place in the spectrum, 0.5 for all colours together (KHR_materials_dispersion).
FN real bsdf_ior(SCENE word model, real spectrum) {
    real ior = FIELD(bsdfs, model, ior);
    if (!FEATURE(FEATURE_DISPERSION)) return ior;
    return ior + (ior - 1.0f) * FIELD(bsdfs, model, dispersion) * (0.5f - spectrum) * 0.05f;
}

/// The normal of clear coat, which doesn't follow its base's bumps: it has a map of its own, or is smooth
/// (KHR_materials_clearcoat).
FN real3 coat_normal(SCENE Surface s, word maps, mask mapped, mask here) {
    word triangle;
    mask is_triangle = on_triangle(SCENE_ s, triangle);
    real3 n = s.geometric_normal;
    if (FEATURE(FEATURE_SMOOTH)) n = smooth_normal(SCENE_ s, is_triangle);
    mapped = mask_and(mapped, here);
    if (!any_lane(mapped)) return lifted_normal(s, n);
    word there = valid_index(mapped, maps);
    mapped = mask_and(mapped, FIELD(bsdf_maps, there, map[BSDF_MAP_COAT_NORMAL].texture) != word(NONE));
    if (!any_lane(mapped)) return lifted_normal(s, n);
    word flags = FIELD(bsdf_maps, there, map[BSDF_MAP_COAT_NORMAL].flags);
    real3 tangent;
    real3 bitangent;
    mask usable = mask_and(mapped, map_tangents(SCENE_ s, n, flags, tangent, bitangent));
    real alpha;
    real3 stored = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_COAT_NORMAL, alpha);
    real strength = FIELD(bsdf_maps, there, map[BSDF_MAP_COAT_NORMAL].strength);
    return lifted_normal(s, select(usable, map_normal(s, n, tangent, bitangent, stored, flags, strength), n));
}

/// Lanes of kind BSDF_PRINCIPLED.
FN Principled principled_at(SCENE Surface s, word model, mask here, real3 color, real ior, INOUT(ShadingFrame) basis) {
    Principled p;
    word maps = FIELD(bsdfs, model, maps);
    mask mapped = mask_and(here, maps != word(NONE));
    bool looks = FEATURE(FEATURE_TEXTURES) && any_lane(mapped);
    real alpha;
    p.base = color;
    p.metallic = FIELD(bsdfs, model, metallic);
    p.roughness = FIELD(bsdfs, model, roughness);
    real specular = FIELD(bsdfs, model, specular);
    real3 specular_color = FIELD(bsdfs, model, specular_color);
    p.transmission = FIELD(bsdfs, model, transmission);
    p.thin = FIELD(bsdfs, model, thin) != word(0u);
    p.coat = FIELD(bsdfs, model, coat);
    real coat_roughness = FIELD(bsdfs, model, coat_roughness);
    p.sheen = FIELD(bsdfs, model, sheen);
    p.sheen_roughness = FIELD(bsdfs, model, sheen_roughness);
    p.film = FIELD(bsdfs, model, film);
    p.film_ior = FIELD(bsdfs, model, film_ior);
    real film_place = real(1.0f);
    real anisotropy = FIELD(bsdfs, model, anisotropy);
    real rotation = FIELD(bsdfs, model, anisotropy_rotation);
    if (looks) {
        real3 rough_metal = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_METALLIC_ROUGHNESS, alpha);
        p.roughness = p.roughness * rough_metal.y;
        p.metallic = p.metallic * rough_metal.z;
        bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_SPECULAR, alpha);
        specular = specular * alpha;
        specular_color = specular_color * bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_SPECULAR_COLOR, alpha);
        real3 passes = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_TRANSMISSION, alpha);
        p.transmission = p.transmission * passes.x;
        real3 coat = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_COAT, alpha);
        p.coat = p.coat * coat.x;
        coat = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_COAT_ROUGHNESS, alpha);
        coat_roughness = coat_roughness * coat.y;
        p.sheen = p.sheen * bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_SHEEN_COLOR, alpha);
        bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_SHEEN_ROUGHNESS, alpha);
        p.sheen_roughness = p.sheen_roughness * alpha;
        real3 film = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_FILM, alpha);
        p.film = p.film * film.x;
        film = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_FILM_THICKNESS, alpha);
        film_place = film.y;
        if (any_lane(anisotropy > real(0.0f))) {
            real3 stretch = bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_ANISOTROPY, alpha);
            word texture = FIELD(bsdf_maps, valid_index(mapped, maps), map[BSDF_MAP_ANISOTROPY].texture);
            mask turned = mask_and(mapped, texture != word(NONE));
            rotation =
                rotation + select(turned, angle_of(stretch.y * 2.0f - 1.0f, stretch.x * 2.0f - 1.0f), real(0.0f));
            anisotropy = anisotropy * stretch.z;
        }
    }
    p.film_nm = mix(FIELD(bsdfs, model, film_least_nm), FIELD(bsdfs, model, film_most_nm), film_place);
    p.roughness = clamp(p.roughness, real(0.0f), real(1.0f));
    real wide = p.roughness * p.roughness;
    // As KHR_materials_anisotropy has it: along the direction wider, up to roughness 1.
    p.alpha_x = max(mix(wide, real(1.0f), anisotropy * anisotropy), real(LEAST_ALPHA));
    p.alpha_y = max(wide, real(LEAST_ALPHA));
    p.roughness = sqrt(sqrt(p.alpha_x * p.alpha_y));
    p.coat_alpha = max(coat_roughness * coat_roughness, real(LEAST_ALPHA));
    p.eta = select(mask_and(s.from_behind, mask_not(p.thin)), ior, 1.0f / ior);
    real root = (ior - 1.0f) / (ior + 1.0f);
    real3 dielectric = min(specular_color * (root * root), real3(real(1.0f))) * specular;
    p.f0 = mix(dielectric, p.base, p.metallic);
    p.f90 = mix(specular, real(1.0f), p.metallic);
    mask stretched = mask_and(here, anisotropy > real(0.0f));
    if (FEATURE(FEATURE_TEXTURES) && any_lane(stretched)) {
        real3 along_u;
        real3 along_v;
        word flags = word(0u);
        if (any_lane(mapped)) {
            word there = valid_index(mapped, maps);
            flags = select(mapped, FIELD(bsdf_maps, there, map[BSDF_MAP_ANISOTROPY].flags), flags);
        }
        mask usable = mask_and(stretched, map_tangents(SCENE_ s, basis.z, flags, along_u, along_v));
        real3 tangent = along_u * cosine(rotation) + along_v * sine(rotation);
        tangent = tangent - basis.z * dot(basis.z, tangent);
        usable = mask_and(usable, dot(tangent, tangent) > real(1e-20f));
        tangent = normalize(select(usable, tangent, basis.x));
        basis.x = select(usable, tangent, basis.x);
        basis.y = select(usable, cross(basis.z, tangent), basis.y);
    }
    p.coat_normal = real3(real(0.0f), real(0.0f), real(1.0f));
    mask coated = mask_and(here, p.coat > real(0.0f));
    if (FEATURE(FEATURE_BUMP) && any_lane(coated)) {
        // Where neither has a map, both have the same normal.
        word of_base = FIELD(material_maps, FIELD(materials, s.material, maps), normal.texture);
        word of_coat = FIELD(bsdf_maps, valid_index(mapped, maps), map[BSDF_MAP_COAT_NORMAL].texture);
        mask bent = mask_or(of_base != word(NONE), mask_and(mapped, of_coat != word(NONE)));
        coated = mask_and(coated, bent);
        real3 n = coat_normal(SCENE_ s, maps, mapped, coated);
        p.coat_normal = select(coated, to_local(basis, n), p.coat_normal);
    }
    return p;
}

/// The models of the lanes `here`, for light at a place in the spectrum; their frame's x is turned to where a surface
/// is brushed along. eta: index of refraction in front over the one behind, for all colours together, if
/// FEATURE_BODIES.
FN_LARGE BsdfPoint bsdf_at(SCENE Surface s, mask here, real spectrum, real eta, INOUT(ShadingFrame) basis) {
    word model = valid_index(here, FIELD(materials, s.material, bsdf));
    BsdfPoint p;
    p.color = FIELD(bsdfs, model, color);
    word maps = FIELD(bsdfs, model, maps);
    mask mapped = mask_and(here, maps != word(NONE));
    if (FEATURE(FEATURE_TEXTURES) && any_lane(mapped)) {
        real alpha;
        p.color = p.color * bsdf_map(SCENE_ s, maps, mapped, BSDF_MAP_COLOR, alpha);
    }
    if (FEATURE(FEATURE_VERTEX_ATTRIBUTES)) {
        word triangle;
        mask is_triangle = on_triangle(SCENE_ s, triangle);
        real unused;
        p.color = p.color * vertex_color(SCENE_ triangle, mask_and(is_triangle, here), s.weights, unused);
    }
    p.alpha_x = FIELD(bsdfs, model, alpha_x);
    p.alpha_y = FIELD(bsdfs, model, alpha_y);
    p.n = FIELD(bsdfs, model, n);
    p.k = FIELD(bsdfs, model, k);
    real ior = bsdf_ior(SCENE_ model, spectrum);
    p.eta = select(s.from_behind, ior, 1.0f / ior);
    p.principled = principled_at(SCENE_ s, model, here, p.color, ior, basis);
    if (FEATURE(FEATURE_BODIES)) {
        mask body = mask_and(here, FIELD(materials, s.material, interior) != word(0u));
        real spread = ior / FIELD(bsdfs, model, ior);
        p.eta = select(body, select(s.from_behind, eta * spread, eta / spread), p.eta);
        p.principled.eta = select(body, p.eta, p.principled.eta);
    }
    return p;
}

/// Lanes of `here` that light passes through in other ways than straight on.
FN mask bsdf_is_clear(SCENE word model, BsdfPoint p, mask here) {
    word kind = FIELD(bsdfs, model, kind);
    mask glass = kind == word(BSDF_DIELECTRIC);
    mask base = mask_and(kind == word(BSDF_PRINCIPLED), p.principled.transmission > real(0.0f));
    return mask_and(here, mask_or(glass, base));
}

/// Lanes of different kinds, one kind after the other: value and density of bsdf_value(), 0 in lanes not `here`.
FN void bsdf_values(SCENE word model, LARGE(BsdfPoint) p, real3 to_eye, real3 to_light, mask here, OUT(real3) value,
                    OUT(real) density) {
    value = real3(real(0.0f));
    density = real(0.0f);
    word kind = FIELD(bsdfs, model, kind);
    mask todo = here;
    while (any_lane(todo)) {
        uint number = first_lane(todo, kind);
        mask now = mask_and(todo, kind == word(number));
        todo = mask_and(todo, mask_not(now));
        real3 one_value;
        real one_density;
        bsdf_value(SCENE_ number, p, to_eye, to_light, one_value, one_density);
        value = select(now, one_value, value);
        density = select(now, one_density, density);
    }
}

/// Likewise bsdf_direction().
FN real3 bsdf_directions(SCENE word model, LARGE(BsdfPoint) p, real3 to_eye, real2 u, real choice, mask here) {
    real3 direction = real3(real(0.0f));
    word kind = FIELD(bsdfs, model, kind);
    mask todo = here;
    while (any_lane(todo)) {
        uint number = first_lane(todo, kind);
        mask now = mask_and(todo, kind == word(number));
        todo = mask_and(todo, mask_not(now));
        real3 one = bsdf_direction(SCENE_ number, p, to_eye, u, choice);
        direction = select(now, one, direction);
    }
    return direction;
}

KERNEL_END

#endif
