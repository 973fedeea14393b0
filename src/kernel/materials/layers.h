// SPDX-License-Identifier: Apache-2.0
// Textures of layers, each a pigment and a finish, as POV-Ray's reference describes them (section 3.5 "Texture"). Light
// is additive: what is reflected takes nothing from a surface's own colour.
#ifndef SUNDOG_KERNEL_MATERIALS_LAYERS_H
#define SUNDOG_KERNEL_MATERIALS_LAYERS_H

#include "kernel/materials/material.h"
#include "kernel/materials/normal.h"
#include "kernel/patterns/program.h"

KERNEL_BEGIN

/// What lighting a texture needs to know of each of its layers at a point, the top one first.
struct LayerColors {
    real3 own[MAX_LAYERS];    ///< The pigment's share that doesn't let light through, as seen through the layers above.
    real3 above[MAX_LAYERS];  ///< What the layers above let through.
    real3 tint[MAX_LAYERS];   ///< The pigment: metals colour their highlights by it.
    real3 normal[MAX_LAYERS];  ///< If FEATURE_NORMALS: unit, world space.
    real3 mirror;  ///< The normal of the layer that reflects most, else the top one's; the surface's own for
                   ///< lanes without layers.
};

/// How a metal tints what it reflects: by its colour, but white at grazing incidence (Schlick 1994).
FN real3 metallic_tint(real3 color, real metallic, real cosine) {
    real3 toward_white = fresnel_schlick(color, cosine);
    return mix(real3(real(1.0f)), toward_white, metallic);
}

/// Reflectance of a layer under a cosine between its normal and the ray.
/// `eta` is the index of refraction in front over the one behind. Fresnel's equations give nothing where it is
/// `enclosed` (see is_enclosed()).
FN real3 layer_reflectance(Layer layer, real eta, mask enclosed, real3 color, real cos_in) {
    real c = clamp(cos_in, real(0.0f), real(1.0f));
    real angle_share;
    if ((layer.flags & LAYER_FRESNEL) != 0u) {
        angle_share = select(enclosed, real(0.0f), fresnel_dielectric(c, eta));
    } else {
        angle_share = power(1.0f - c, real(layer.reflection_falloff));
    }
    real3 r = mix(real3(layer.reflection_min), real3(layer.reflection_max), angle_share);
    if (layer.reflection_metallic > 0.0f) r = r * metallic_tint(color, real(layer.reflection_metallic), c);
    return r;
}

/// How a layer's thin film colours matt light, and what is mirrored (both cosines are then the eye's): waves that were
/// thrown back at its top and at its bottom meet in or out of phase. The amounts are those of povray's pictures.
FN real3 film_color(SCENE Layer layer, real3 p, real cos_light, real cos_eye) {
    real thickness = real(layer.irid_thickness);
    if (layer.irid_turbulence != 0.0f) {
        real stirred = 0.94f + 3.87f * turbulence_scalar(p, 5u, 2.0f, 0.5f, 2u);
        thickness = thickness * (1.0f + stirred * layer.irid_turbulence);
    }
    real way = 6.28318531f * thickness * (cos_light + cos_eye);
    real3 phase = real3(cosine(way / real(FRAME.irid_wavelength.x)), cosine(way / real(FRAME.irid_wavelength.y)),
                        cosine(way / real(FRAME.irid_wavelength.z)));
    return real3(real(1.0f)) + phase * real(layer.irid);
}

/// Puts the textures of those lanes of `found` that have one into `lobes`, whose eta is set already, and their layers
/// into `layered`. `enclosed`: see is_enclosed(). For a shadow ray, which goes straight on, nothing is thrown back by
/// total internal reflection or kept by conserve_energy, as in povray.
FN_LARGE void evaluate_layers(SCENE Surface s, real3 incoming, mask found, mask enclosed, bool for_shadow,
                              INOUT(Lobes) lobes, OUT(LayerColors) layered) {
    real3 black = real3(real(0.0f));
    for (uint l = 0u; l < MAX_LAYERS; l = l + 1u) {
        layered.own[l] = black;
        layered.above[l] = black;
        layered.tint[l] = black;
        if (FEATURE(FEATURE_NORMALS)) layered.normal[l] = s.normal;
    }
    layered.mirror = s.normal;
    mask todo = mask_and(found, lobes.patterned);
    word index = valid_index(todo, FIELD(materials, s.material, patterned));
    word look = FIELD(patterned, index, look);
    real cos_in = -dot(s.normal, incoming);
    while (any_lane(todo)) {
        uint i = first_lane(todo, look);
        mask here = mask_and(todo, look == word(i));
        todo = mask_and(todo, mask_not(here));
        PatternedMaterial m = AT(patterned, i);
        real3 p = s.position;
        real3 point = real3(m.texture_from_world_x) * p.x + real3(m.texture_from_world_y) * p.y +
                      real3(m.texture_from_world_z) * p.z + real3(m.texture_from_world_t);
        real3 above = real3(real(1.0f));
        real3 emission = black;
        real3 ambient = black;
        real3 albedo = black;
        real3 reflectance = black;
        real3 film = real3(real(1.0f));
        real strongest = real(0.0f);
        mask in_part = here;     // Lanes that the part at hand of a patterned texture has a share in.
        real3 entering = above;  // What came to the first part,
        real3 left = black;      // and what the parts so far let through.
        for (uint l = 0u; l < m.layer_count; l = l + 1u) {
            Layer layer = AT(layers, m.first_layer + l);
            bool begins_part = (layer.flags & LAYER_PART) != 0u;
            if ((layer.flags & LAYER_FIRST_PART) != 0u) {
                entering = above;
                left = black;
            } else if (begins_part) {
                left = left + above;
            }
            if (begins_part) in_part = here;
            real3 at = point;
            if (layer.uses_uv != 0u) at = real3(s.uv.x, s.uv.y, real(0.0f));
            PatternPoint asked;
            asked.position = at;
            asked.normal = s.normal;
            asked.direction = incoming;
            asked.world = s.position;
            asked.asking = in_part;
            PigmentColor c = no_color();
            if (layer.program == NONE) {
                c.rgb = FIELD(patterned, index, color);
                c.filtered = FIELD(patterned, index, filtered);
                c.transmitted = FIELD(patterned, index, transmitted);
            } else if (any_lane(in_part)) {
                ProgramResult answer = run_whole_program(SCENE_ layer.program, asked);
                c = answer.color;
                if (begins_part) {
                    above = entering * answer.weight;
                    in_part = mask_and(here, answer.weight > real(0.0f));
                    asked.asking = in_part;
                }
            }
            // Of more than all it lets through, a pigment takes its own colour away: scenes raise contrast by that.
            real3 own = above * c.rgb * (1.0f - c.filtered - c.transmitted);
            layered.own[l] = select(here, own, layered.own[l]);
            layered.above[l] = select(here, above, layered.above[l]);
            layered.tint[l] = select(here, c.rgb, layered.tint[l]);
            emission = emission + own * real3(layer.emission);
            ambient = ambient + own * real3(layer.ambient);
            albedo = albedo + own * real(layer.diffuse);
            real cos_layer = cos_in;
            if (FEATURE(FEATURE_NORMALS)) {
                real3 n = s.normal;
                if (layer.normal != NONE && (!for_shadow || FEATURE(FEATURE_CAUSTICS)) && any_lane(in_part)) {
                    real3 placed = point;
                    if (layer.normal_uses_uv != 0u) placed = real3(s.uv.x, s.uv.y, real(0.0f));
                    asked.position = placed;
                    n = perturbed_normal(SCENE_ layer.normal, asked, m.texture_from_world_x, m.texture_from_world_y,
                                         m.texture_from_world_z);
                }
                layered.normal[l] = select(here, n, layered.normal[l]);
                cos_layer = -dot(n, incoming);
            }
            real3 r = layer_reflectance(layer, lobes.eta, enclosed, c.rgb, cos_layer);
            if (FEATURE(FEATURE_NORMALS)) {
                real3 weight = above * r;
                real most = largest(weight);
                mask stronger = mask_and(here, most > strongest);
                if (l == 0u) stronger = here;
                // One that is bent away from the ray can't say where it goes on to.
                mask away = dot(layered.normal[l], incoming) >= real(0.0f);
                layered.mirror = select(stronger, select(away, s.normal, layered.normal[l]), layered.mirror);
                strongest = select(stronger, most, strongest);
            }
            if (FEATURE(FEATURE_EXPONENTS)) {
                if (layer.reflection_exponent != 1.0f) {
                    // One exponent for what all layers reflect.
                    mask bends = mask_and(here, largest(r) > real(0.0f));
                    lobes.exponent = select(bends, real(layer.reflection_exponent), lobes.exponent);
                }
            }
            if (layer.irid > 0.0f && !for_shadow) {
                real cos_eye = abs(cos_layer);
                film = film_color(SCENE_ layer, s.position, cos_eye, cos_eye);
                reflectance = reflectance + above * r * film;
            } else {
                reflectance = reflectance + above * r;
            }
            above = above * (c.rgb * c.filtered + real3(c.transmitted));
            if ((layer.flags & LAYER_CONSERVE_ENERGY) != 0u && !for_shadow)
                above = above * max(real3(real(1.0f)) - r, black);
            if ((layer.flags & LAYER_PARTS_END) != 0u) {
                above = left + above;
                in_part = here;
            }
        }
        lobes.emission = select(here, emission, lobes.emission);
        lobes.ambient = select(here, ambient, lobes.ambient);
        lobes.albedo = select(here, albedo, lobes.albedo);
        // Total internal reflection throws back all light, as povray's pictures show, whatever the pigment is; a film
        // colours it.
        real cos_mirror = cos_in;
        if (FEATURE(FEATURE_NORMALS)) cos_mirror = -dot(layered.mirror, incoming);
        mask total = mask_and(is_total_reflection(cos_mirror, lobes.eta), mask(!for_shadow));
        total = mask_and(total, largest(above) > real(0.0f));
        lobes.reflectance = select(here, select(total, film, reflectance), lobes.reflectance);
        lobes.transmittance = select(here, select(total, black, above), lobes.transmittance);
    }
}

/// In which lanes a light of some group reaches a material.
FN mask light_reaches(SCENE uint group, word material, mask patterned_lanes) {
    word index = valid_index(patterned_lanes, FIELD(materials, material, patterned));
    word bits = GET(code, FIELD(patterned, index, light_set) + word(group / 32u));
    mask listed = ((bits >> (group % 32u)) & word(1u)) != word(0u);
    return select_mask(patterned_lanes, listed, mask(group == 0u));
}

/// Adds what one light does to the lanes of `lit` that have textures: to `base` matt light, to `highlight` highlights.
/// `behind`: lanes whose back it lights. `light_number` tells lights apart where something is random.
FN void light_layers(SCENE Surface s, LARGE(LayerColors) layered, mask lit, mask behind, mask patterned_lanes,
                     real3 light_color, uint light_flags, uint light_number, real3 to_light, real3 to_eye,
                     INOUT(real3) base, INOUT(real3) highlight) {
    real3 black = real3(real(0.0f));
    mask todo = mask_and(lit, patterned_lanes);
    word look = FIELD(patterned, valid_index(todo, FIELD(materials, s.material, patterned)), look);
    real cosine = max(dot(s.normal, to_light), real(0.0f));
    while (any_lane(todo)) {
        uint i = first_lane(todo, look);
        mask here = mask_and(todo, look == word(i));
        todo = mask_and(todo, mask_not(here));
        PatternedMaterial m = AT(patterned, i);
        for (uint l = 0u; l < m.layer_count; l = l + 1u) {
            Layer layer = AT(layers, m.first_layer + l);
            real3 n = s.normal;
            if (FEATURE(FEATURE_NORMALS)) {
                n = layered.normal[l];
                cosine = max(dot(n, to_light), real(0.0f));
            }
            if (FEATURE(FEATURE_BACKLIT)) cosine = max(dot(n, select(behind, -to_light, to_light)), real(0.0f));
            real share = cosine;
            if (layer.brilliance != 1.0f) share = power(cosine, real(layer.brilliance));
            real diffuse = real(layer.diffuse);
            if (FEATURE(FEATURE_BACKLIT)) {
                if (m.double_illuminated == 0u) diffuse = select(behind, real(layer.diffuse_back), diffuse);
            }
            // Light that a layer lets in is subsurface_light()'s; that of photons stays where it came to.
            if (FEATURE(FEATURE_SUBSURFACE)) {
                if (layer.translucency.x > 0.0f && light_number < max(FRAME.light_count, 1u)) diffuse = real(0.0f);
            }
            real matt = share * diffuse;
            if (layer.crand > 0.0f)
                matt = matt - layer.crand * random_at(s.position, word(light_number * MAX_LAYERS + l));
            real3 own = layered.own[l];
            if (layer.irid > 0.0f) own = own * film_color(SCENE_ layer, s.position, cosine, abs(dot(n, to_eye)));
            base = base + select(here, own * light_color * matt, black);
            if ((light_flags & LIGHT_HIGHLIGHTS) != 0u) {
                if (layer.phong > 0.0f || layer.specular > 0.0f) {
                    real shine = real(0.0f);
                    if (layer.phong > 0.0f)
                        shine = layer.phong * phong_highlight(n, to_light, to_eye, real(layer.phong_size));
                    if (layer.specular > 0.0f)
                        shine = shine + layer.specular *
                                            blinn_phong_highlight(n, to_light, to_eye, real(layer.specular_exponent));
                    real3 color = layered.above[l] * light_color * shine;
                    if (layer.metallic > 0.0f)
                        color = color * metallic_tint(layered.tint[l], real(layer.metallic), cosine);
                    mask shines = here;
                    if (m.double_illuminated == 0u) shines = mask_and(here, mask_not(behind));
                    highlight = highlight + select(shines, color, black);
                }
            }
        }
    }
}

KERNEL_END

#endif
