// SPDX-License-Identifier: Apache-2.0
// Bump maps (Blinn 1978) and tangent-space normal maps on triangles.
#ifndef SUNDOG_KERNEL_MATERIALS_BUMP_H
#define SUNDOG_KERNEL_MATERIALS_BUMP_H

#include "kernel/materials/surface.h"
#include "kernel/patterns/texture.h"

KERNEL_BEGIN

/// World-space change of position per unit of u (dp_du) and v of a triangle, zero where its uvs are degenerate. They
/// are those that a map with `flags` goes by.
FN mask triangle_tangents(SCENE Surface s, word flags, OUT(real3) dp_du, OUT(real3) dp_dv) {
    word triangle;
    mask is_triangle = on_triangle(SCENE_ s, triangle);
    word a = FIELD(triangle_uvs, triangle, a);
    mask present = mask_and(is_triangle, a != word(NONE));
    word ia = valid_index(present, a);
    word ib = valid_index(present, FIELD(triangle_uvs, triangle, b));
    word ic = valid_index(present, FIELD(triangle_uvs, triangle, c));
    if (FEATURE(FEATURE_VERTEX_ATTRIBUTES)) {
        mask second = mask_and(present, (flags & word(TEXTURE_SECOND_UV)) != word(0u));
        word further = select(second, word(VERTEX_SECOND_UV), word(0u));
        ia = ia + further;
        ib = ib + further;
        ic = ic + further;
    }
    real2 uv_a = GET(uvs, ia);
    real2 uv_1 = GET(uvs, ib) - uv_a;
    real2 uv_2 = GET(uvs, ic) - uv_a;
    real3 p_a = GET(positions, FIELD(triangles, triangle, p0));
    real3 e1 = GET(positions, FIELD(triangles, triangle, p1)) - p_a;
    real3 e2 = GET(positions, FIELD(triangles, triangle, p2)) - p_a;
    real determinant = uv_1.x * uv_2.y - uv_1.y * uv_2.x;
    mask usable = mask_and(present, abs(determinant) > real(1e-20f));
    real inverse = 1.0f / select(usable, determinant, real(1.0f));
    dp_du = (e1 * uv_2.y - e2 * uv_1.y) * inverse;
    dp_dv = (e2 * uv_1.x - e1 * uv_2.x) * inverse;
    word instance = FIELD(geometries, s.geometry, instance);
    mask moved = instance != word(NONE);
    if (any_lane(moved)) {
        word i = valid_index(moved, instance);
        real3 x = FIELD(instances, i, world_from_object_x);
        real3 y = FIELD(instances, i, world_from_object_y);
        real3 z = FIELD(instances, i, world_from_object_z);
        dp_du = select(moved, x * dp_du.x + y * dp_du.y + z * dp_du.z, dp_du);
        dp_dv = select(moved, x * dp_dv.x + y * dp_dv.y + z * dp_dv.z, dp_dv);
    }
    return usable;
}

/// Unit vectors along which a normal map's x and y go: those of the triangle's vertices (glTF 2.0, section 3.7.2.1: the
/// second is the normal's cross product with the first, times the handedness), else those of its texture coordinates.
/// False where there are neither.
FN mask map_tangents(SCENE Surface s, real3 normal, word flags, OUT(real3) tangent, OUT(real3) bitangent) {
    mask usable = triangle_tangents(SCENE_ s, flags, tangent, bitangent);
    tangent = tangent * (1.0f / sqrt(max(dot(tangent, tangent), real(1e-30f))));
    bitangent = bitangent * (1.0f / sqrt(max(dot(bitangent, bitangent), real(1e-30f))));
    if (!FEATURE(FEATURE_VERTEX_ATTRIBUTES)) return usable;
    word triangle;
    mask is_triangle = on_triangle(SCENE_ s, triangle);
    mask own = has_vertex_attributes(SCENE_ triangle, is_triangle);
    real2 xy = vertex_pair(SCENE_ triangle, own, s.weights, VERTEX_TANGENT);
    real2 zw = vertex_pair(SCENE_ triangle, own, s.weights, VERTEX_TANGENT + 1u);
    real3 t = real3(xy.x, xy.y, zw.x);
    own = mask_and(own, dot(t, t) > real(1e-12f));
    if (!any_lane(own)) return usable;
    real hand = select(zw.y < real(0.0f), real(-1.0f), real(1.0f));
    if (FEATURE(FEATURE_INSTANCES)) {
        word instance = FIELD(geometries, s.geometry, instance);
        mask moved = instance != word(NONE);
        word i = valid_index(moved, instance);
        real3 x = FIELD(instances, i, world_from_object_x);
        real3 y = FIELD(instances, i, world_from_object_y);
        real3 z = FIELD(instances, i, world_from_object_z);
        t = select(moved, x * t.x + y * t.y + z * t.z, t);
        // A map that mirrors turns cross products round.
        mask mirrors = mask_and(moved, dot(cross(x, y), z) < real(0.0f));
        hand = select(mirrors, -hand, hand);
    }
    t = normalize(select(own, t, normal));
    hand = select(s.from_behind, -hand, hand);
    tangent = select(own, t, tangent);
    bitangent = select(own, cross(normal, t) * hand, bitangent);
    return mask_or(usable, own);
}

/// `normal` (on the viewer's side) bent by what a normal map holds there.
FN real3 map_normal(Surface s, real3 normal, real3 tangent, real3 bitangent, real3 stored, word flags, real strength) {
    mask turned_over = mask_and(s.from_behind, (flags & word(TEXTURE_TURNS_OVER)) != word(0u));
    strength = select(turned_over, -strength, strength);
    real x = (stored.x * 2.0f - 1.0f) * strength;
    real y = (stored.y * 2.0f - 1.0f) * strength;
    real z = stored.z * 2.0f - 1.0f;
    return normalize(tangent * x + bitangent * y + normal * max(z, real(0.01f)));
}

/// A normal, kept on the viewer's side of the face.
FN real3 lifted_normal(Surface s, real3 n) {
    real under = dot(n, s.geometric_normal);
    real3 lifted = n - s.geometric_normal * (under - 0.01f);
    return select(under < real(0.01f), normalize(lifted), n);
}

/// A map's height: the channel that the material says, times its strength.
FN real bump_height(SCENE word texture, word flags, real2 uv) {
    real alpha;
    real3 color = texture_lookup(SCENE_ texture, flags, uv, alpha);
    return texture_channel(color, alpha, flags);
}

/// The shading normal after the material's bump or normal map.
FN real3 bumped_normal(SCENE Surface s) {
    real3 n = s.normal;
    word maps = FIELD(materials, s.material, maps);
    word bump = FIELD(material_maps, maps, bump.texture);
    mask bumps = bump != word(NONE);
    if (any_lane(bumps)) {
        word flags = FIELD(material_maps, maps, bump.flags);
        real3 dp_du;
        real3 dp_dv;
        bumps = mask_and(bumps, triangle_tangents(SCENE_ s, flags, dp_du, dp_dv));
        real du2 = max(dot(dp_du, dp_du), real(1e-30f));
        real dv2 = max(dot(dp_dv, dp_dv), real(1e-30f));
        word texture = valid_index(bumps, bump);
        real2 scale = FIELD(material_maps, maps, bump.scale);
        real2 base = map_uv(SCENE_ s, flags);
        real2 uv = base * scale + FIELD(material_maps, maps, bump.offset);
        if (any_lane((flags & word(TEXTURE_TURNED)) != word(0u)))
            uv = turned_uv(flags, uv, base, FIELD(material_maps, maps, bump.shear));
        real strength = FIELD(material_maps, maps, bump.strength);
        // Differences over one texel. Heights are in units of the texture's width on the surface, so that a map keeps
        // its slope when the model is scaled.
        real step_u = 1.0f / real_from_word(FIELD(textures, texture, width));
        real step_v = 1.0f / real_from_word(FIELD(textures, texture, height));
        real h = bump_height(SCENE_ texture, flags, uv);
        real slope_u = (bump_height(SCENE_ texture, flags, uv + real2(step_u, real(0.0f))) - h) * strength;
        real slope_v = (bump_height(SCENE_ texture, flags, uv + real2(real(0.0f), step_v)) - h) * strength;
        real3 tangent = dp_du * (1.0f / sqrt(du2));
        real3 bitangent = dp_dv * (1.0f / sqrt(dv2));
        real3 bumped = n - tangent * slope_u - bitangent * slope_v;
        n = select(bumps, normalize(bumped), n);
    }

    word map = FIELD(material_maps, maps, normal.texture);
    mask mapped = map != word(NONE);
    if (any_lane(mapped)) {
        word flags = FIELD(material_maps, maps, normal.flags);
        real3 tangent;
        real3 bitangent;
        mapped = mask_and(mapped, map_tangents(SCENE_ s, s.normal, flags, tangent, bitangent));
        word texture = valid_index(mapped, map);
        real2 scale = FIELD(material_maps, maps, normal.scale);
        real2 base = map_uv(SCENE_ s, flags);
        real2 uv = base * scale + FIELD(material_maps, maps, normal.offset);
        if (any_lane((flags & word(TEXTURE_TURNED)) != word(0u)))
            uv = turned_uv(flags, uv, base, FIELD(material_maps, maps, normal.shear));
        real alpha;
        real3 stored = texture_lookup(SCENE_ texture, flags, uv, alpha);
        real strength = FIELD(material_maps, maps, normal.strength);
        n = select(mapped, map_normal(s, s.normal, tangent, bitangent, stored, flags, strength), n);
    }
    return lifted_normal(s, n);
}

KERNEL_END

#endif
